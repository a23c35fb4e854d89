//! The table of times, cells and battery levels, as the papers print it: a
//! column a time, wrapped into blocks; for each agent a row of cells and, where
//! it has a battery, a row of levels.

use std::fmt::Write as _;

use giveway_model::{
    Cell, Instance, Plan,
    change::{History, Trajectory},
    check::{arrivals, levels, levels_over_time},
};

use super::plain;

/// With more agents, only the arrivals are listed.
const MAX_AGENTS: usize = 40;
/// Names are cut to so many columns.
const NAME_COLUMNS: usize = 16;
/// Longer plans are not told step by step.
const MAX_TIMES: usize = 2000;
const TOO_LARGE: &str =
    "The plan is too large for a table of times; --format json shows all of it.\n";

/// Draws the table of a plan, in lines of at most so many columns.
///
/// The plan may be broken: what it has is drawn as it is.
pub(crate) fn draw(instance: &Instance, plan: &Plan, columns: usize) -> String {
    let mut plan = plan.clone();
    plan.cut_trailing_goals(instance);
    let rows = if instance.agents().len() > MAX_AGENTS {
        Vec::new()
    } else {
        rows(instance, &plan)
    };
    let times = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
    if instance.agents().is_empty() {
        String::new()
    } else if rows.is_empty() || times > MAX_TIMES {
        summary(instance, &plan)
    } else {
        blocks(&rows, times, columns) + &legend(&rows)
    }
}

/// Draws the table of a plan around which the world changes, in absolute times.
pub(crate) fn draw_over_time(history: &History, plan: &Plan, columns: usize) -> String {
    let timelines = history.timelines();
    let mut rows = Vec::new();
    for trajectory in timelines
        .iter()
        .filter_map(|timeline| Trajectory::of(history, timeline, plan))
    {
        let timeline = trajectory.timeline;
        let from = timeline.from as usize;
        let levels = levels_over_time(history, &trajectory);
        rows.append(&mut life_rows(
            timeline.name(),
            from,
            trajectory.path,
            trajectory.charges,
            &levels,
        ));
    }
    let times = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
    if timelines.is_empty() {
        String::new()
    } else if timelines.len() > MAX_AGENTS || times > MAX_TIMES {
        TOO_LARGE.to_owned()
    } else {
        blocks(&rows, times, columns) + &legend(&rows)
    }
}

/// Draws a plan with another one beside it: agents that do something else have
/// their other row below their own, what differs marked.
pub(crate) fn beside(instance: &Instance, plan: &Plan, other: &Plan, columns: usize) -> String {
    let cut = |plan: &Plan| {
        let mut plan = plan.clone();
        plan.cut_trailing_goals(instance);
        plan
    };
    let (plan, other) = (cut(plan), cut(other));
    if instance.agents().len() > MAX_AGENTS {
        return summary(instance, &other);
    }
    let mut rows = Vec::new();
    for i in 0..instance.agents().len() {
        let mut own = agent_rows(instance, i, &plan);
        let mut others = agent_rows(instance, i, &other);
        let same = own.len() == others.len()
            && own.iter().zip(&others).all(|(a, b)| a.entries == b.entries);
        if !same {
            for (k, row) in others.iter_mut().enumerate() {
                let before = own.get(k).map_or(&[][..], |row| row.entries.as_slice());
                // Levels differ all the time; of their row only charges count.
                row.mark_differences(before, k > 0);
                let label = if k > 0 { "    level" } else { "  other" };
                label.clone_into(&mut row.label);
            }
            own.append(&mut others);
        }
        rows.append(&mut own);
    }
    let times = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
    if times > MAX_TIMES {
        return summary(instance, &other);
    }
    let differ = rows.iter().any(|row| row.label == "  other");
    let words = if differ {
        "  other: what the robot does in the other plan; ! marks a difference\n"
    } else {
        ""
    };
    blocks(&rows, times, columns) + &legend(&rows) + words
}

/// One row: its label, and an entry a time from 0.
struct Row {
    label: String,
    entries: Vec<String>,
}

fn rows(instance: &Instance, plan: &Plan) -> Vec<Row> {
    let agents = 0..instance.agents().len();
    agents.flat_map(|i| agent_rows(instance, i, plan)).collect()
}

/// The row of cells of an agent and, where it has a battery, that of levels.
fn agent_rows(instance: &Instance, i: usize, plan: &Plan) -> Vec<Row> {
    let Some(agent) = instance.agents().get(i) else {
        return Vec::new();
    };
    let from = plan.from.get(&agent.name).map_or(0, |t| *t as usize);
    let (path, charges) = (plan.path(&agent.name), plan.charges(&agent.name));
    life_rows(&agent.name, from, path, charges, &levels(instance, i, plan))
}

/// The same from the parts; the path and the levels begin at the time `from`.
fn life_rows(
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
    let name = plain::cut(&plain::text(name), NAME_COLUMNS);
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
    fn mark_differences(&mut self, before: &[String], charges_only: bool) {
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

/// The rows, cut into blocks of times that fit the width.
fn blocks(rows: &[Row], times: usize, columns: usize) -> String {
    let widest = |texts: &mut dyn Iterator<Item = usize>| texts.max().unwrap_or(0);
    let label = widest(&mut rows.iter().map(|row| plain::width(&row.label))).max(4);
    let entry = widest(
        &mut rows
            .iter()
            .flat_map(|row| row.entries.iter().map(String::len)),
    );
    let pitch = entry.max(times.to_string().len() + 1) + 1;
    let fitting = (columns.saturating_sub(label) / pitch).max(1);
    // Blocks of about one length read better than one that holds the rest.
    let per_block = times.div_ceil(times.div_ceil(fitting).max(1)).max(1);
    let mut text = String::new();
    for first in (0..times).step_by(per_block) {
        if first > 0 {
            text.push('\n');
        }
        let block = first..times.min(first + per_block);
        let header = block.clone().map(|t| format!("{t} "));
        text += &line("time", label, pitch, header);
        for row in rows {
            let entries = block
                .clone()
                .map(|t| row.entries.get(t).cloned().unwrap_or_default());
            // Who has arrived is left out of the later blocks.
            if row.entries.len() > first {
                text += &line(&row.label, label, pitch, entries);
            }
        }
    }
    text
}

fn line(
    label: &str,
    label_columns: usize,
    pitch: usize,
    entries: impl Iterator<Item = String>,
) -> String {
    let mut line = plain::pad_right(label, label_columns);
    for entry in entries {
        line += &plain::pad_left(&entry, pitch);
    }
    line.trim_end().to_owned() + "\n"
}

fn legend(rows: &[Row]) -> String {
    let occurs = |what: &str| {
        rows.iter()
            .any(|row| row.entries.iter().any(|e| e.contains(what)))
    };
    let words: Vec<&str> = [("..", ".. in transit on a slow move"), ("*", "* charges")]
        .into_iter()
        .filter(|(what, _)| occurs(what))
        .map(|(_, words)| words)
        .collect();
    if words.is_empty() {
        String::new()
    } else {
        format!("  {}\n", words.join(", "))
    }
}

/// Where each agent starts and ends, and when it arrives.
fn summary(instance: &Instance, plan: &Plan) -> String {
    let mut text = format!(
        "{:NAME_COLUMNS$} {:>11} {:>11} {:>8} {:>8}\n",
        "robot", "start", "goal", "arrival", "charges"
    );
    for (agent, arrival) in instance.agents().iter().zip(arrivals(instance, plan)) {
        let name = plain::cut(&plain::text(&agent.name), NAME_COLUMNS);
        let _ = writeln!(
            text,
            "{} {:>11} {:>11} {:>8} {:>8}",
            plain::pad_right(&name, NAME_COLUMNS),
            agent.start.to_string(),
            agent.goal.to_string(),
            arrival.map_or("none".to_owned(), |t| t.to_string()),
            plan.charges(&agent.name).len(),
        );
    }
    format!("{text}\n{TOO_LARGE}")
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use giveway_model::{Agent, Battery, Cell, Scene};

    use super::*;

    fn agent(name: &str, start: [u32; 2], goal: [u32; 2], battery: Option<Battery>) -> Agent {
        Agent {
            name: name.to_owned(),
            start: Cell::new(start[0], start[1]),
            goal: Cell::new(goal[0], goal[1]),
            waypoints: Vec::new(),
            battery,
        }
    }

    fn check(map: &[&str], agents: Vec<Agent>, plan: &str, columns: usize, expect: &Expect) {
        let scene = Scene {
            map: map.iter().map(|&row| row.to_owned()).collect(),
            agents,
            ..Scene::default()
        };
        let plan = serde_json::from_str(plan).unwrap();
        expect.assert_eq(&draw(&Instance::new(scene).unwrap(), &plan, columns));
    }

    const PLAN: &str = r#"{ "giveway": 1,
        "paths": { "A1": [[0,0],[1,0],null,[2,0],[3,0]], "A2": [[0,1],[1,1],[1,1]] },
        "charges": { "A1": [1] } }"#;

    fn agents() -> Vec<Agent> {
        let battery = Battery {
            capacity: 10,
            initial: 3,
        };
        vec![
            agent("A1", [0, 0], [3, 0], Some(battery)),
            agent("A2", [0, 1], [1, 1], None),
        ]
    }

    const MAP: [&str; 2] = [".*~.", "...."];

    #[test]
    fn cells_levels_charges_and_transit() {
        check(
            &MAP,
            agents(),
            PLAN,
            100,
            &expect![[r#"
            time      0    1    2    3    4
            A1      0,0  1,0   ..  2,0  3,0
              level   3    2*  10    9    8
            A2      0,1  1,1
              .. in transit on a slow move, * charges
        "#]],
        );
    }

    #[test]
    fn a_narrow_terminal_gets_blocks() {
        check(
            &MAP,
            agents(),
            PLAN,
            22,
            &expect![[r#"
                time      0    1    2
                A1      0,0  1,0   ..
                  level   3    2*  10
                A2      0,1  1,1

                time      3    4
                A1      2,0  3,0
                  level   9    8
                  .. in transit on a slow move, * charges
            "#]],
        );
    }

    #[test]
    fn a_plan_without_paths_has_no_table() {
        let plan = r#"{ "giveway": 1, "paths": {} }"#;
        check(&MAP, agents(), plan, 100, &expect![[r#""#]]);
    }

    #[test]
    fn many_agents_get_a_summary() {
        let row = ".".repeat(41);
        let agents = (0..41)
            .map(|i| agent(&format!("A{i}"), [i, 0], [i, 0], None))
            .collect();
        let plan = r#"{ "giveway": 1, "paths": { "A0": [[0,0]] } }"#;
        let scene = Scene {
            map: vec![row],
            agents,
            ..Scene::default()
        };
        let plan = serde_json::from_str(plan).unwrap();
        let text = draw(&Instance::new(scene).unwrap(), &plan, 100);
        let lines: Vec<&str> = text.lines().take(3).collect();
        expect![[r#"
            [
                "robot                  start        goal  arrival  charges",
                "A0                    (0, 0)      (0, 0)        0        0",
                "A1                    (1, 0)      (1, 0)     none        0",
            ]
        "#]]
        .assert_debug_eq(&lines);
        assert!(text.contains("--format json"));
    }
}
