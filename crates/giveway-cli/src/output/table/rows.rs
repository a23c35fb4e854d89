//! The rows of a table: for each agent its cells and its levels, an entry a time.

use giveway_model::{Cell, Instance, Plan, check::levels};

use super::{MAX_TIMES, NAME_COLUMNS};
use crate::output::plain;

/// One row: its label, and an entry a time from 0.
pub(super) struct Row {
    pub(super) label: String,
    pub(super) entries: Vec<String>,
}

/// The rows of all agents.
pub(super) fn rows(instance: &Instance, plan: &Plan) -> Vec<Row> {
    let agents = 0..instance.agents().len();
    agents.flat_map(|i| agent_rows(instance, i, plan)).collect()
}

/// The row of cells of an agent and, where it has a battery, that of levels.
pub(super) fn agent_rows(instance: &Instance, i: usize, plan: &Plan) -> Vec<Row> {
    let Some(agent) = instance.agents().get(i) else {
        return Vec::new();
    };
    let from = plan.from.get(&agent.name).map_or(0, |t| *t as usize);
    let (path, charges) = (plan.path(&agent.name), plan.charges(&agent.name));
    life_rows(&agent.name, from, path, charges, &levels(instance, i, plan))
}

/// The same from the parts; the path and the levels begin at the time `from`.
pub(super) fn life_rows(
    name: &str,
    from: usize,
    path: &[Option<Cell>],
    charges: &[u32],
    levels: &[i64],
) -> Vec<Row> {
    let mark = |k: usize| {
        let charged = charges.iter().any(|t| *t as usize == from + k);
        if charged { '*' } else { ' ' }
    };
    // Without levels the mark of a charge, which is wrong then, stands at the cell.
    let cells = path.iter().enumerate().map(|(k, cell)| {
        let mark = if levels.is_empty() { mark(k) } else { ' ' };
        cell.map_or("..".to_owned(), |c| format!("{},{}", c.x, c.y)) + mark.encode_utf8(&mut [0; 4])
    });
    let name = plain::cut_middle(&plain::text(name), NAME_COLUMNS);
    let mut rows = vec![Row::after(from, name, cells)];
    if !levels.is_empty() {
        let levels = levels.iter().enumerate();
        let levels = levels.map(|(k, n)| format!("{n}{}", mark(k)));
        rows.push(Row::after(from, "  level".to_owned(), levels));
    }
    rows
}

impl Row {
    /// Marks the entries that are not those of another row, or only those that
    /// differ in a charge.
    pub(super) fn mark_differences(&mut self, before: &[String], charges_only: bool) {
        for (time, entry) in self.entries.iter_mut().enumerate() {
            let charges = |entry: &String| entry.ends_with('*');
            let differs = match before.get(time) {
                Some(other) if charges_only => charges(other) != charges(entry),
                other => other != Some(entry) && (charges(entry) || !charges_only),
            };
            if differs {
                entry.insert(0, '!');
            }
        }
    }

    /// A row whose first entry stands at the time `from`.
    fn after(from: usize, label: String, entries: impl Iterator<Item = String>) -> Self {
        let from = from.min(MAX_TIMES);
        Self {
            label,
            entries: std::iter::repeat_n(String::new(), from)
                .chain(entries)
                .collect(),
        }
    }
}

/// Names that are alike once they are cut get a number each.
pub(super) fn tell_apart(rows: &mut [Row]) {
    let labels: Vec<String> = rows.iter().map(|row| row.label.clone()).collect();
    for (at, row) in rows.iter_mut().enumerate() {
        let same = |other: &&String| **other == row.label;
        let place = labels.iter().take(at + 1).filter(same).count();
        let is_cut = row.label.contains('…');
        if is_cut && labels.iter().filter(same).count() > 1 {
            let number = format!("·{place}");
            let room = NAME_COLUMNS - plain::width(&number);
            row.label = plain::cut_middle(&row.label, room) + &number;
        }
    }
}
