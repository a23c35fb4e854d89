//! The facts of a set in one sentence: many of one kind are joined.

use std::collections::BTreeSet;

use giveway_model::sorting::{set, sort};
use giveway_model::words::and;
use giveway_model::{Cell, tr};

use super::heads::{facts_title, no_help};
use crate::explain::{Core, Fact, FactKind, Helps, Verdict};

/// So many facts of a kind are told one by one.
const ONE_BY_ONE: usize = 3;
/// So many names or cells of a list are told; of a longer one fewer, and the rest is
/// counted.
const IN_LIST: usize = 4;

/// So many clauses are told; of more than that one fewer, and the rest is counted.
const CLAUSES: usize = 6;

/// The sets of facts, a sentence each. Facts that help when they alone are left out are marked where the
/// facts are listed.
pub(crate) fn because(core: Option<&Core>, verdict: Verdict) -> Vec<String> {
    let Some(core) = core.filter(|core| !core.facts.is_empty()) else {
        return Vec::new();
    };
    let sets = core.sets().enumerate();
    let mut sentences: Vec<String> = sets
        .map(|(set, core)| {
            let title = facts_title(verdict, core, set > 0);
            tr!("{title}: {facts}.", title, facts = clauses(core))
        })
        .collect();
    let helps = |fact: &Fact| fact.helps == Helps::Yes;
    if !core.facts.iter().any(helps) {
        sentences.extend(no_help(core).map(str::to_owned));
    }
    sentences
}

/// The facts of a set as clauses.
fn clauses(core: &Core) -> String {
    let alike = |a: &Fact, b: &Fact| {
        a.kind == b.kind && (a.kind != FactKind::Waypoint || a.agents == b.agents)
    };
    let mut groups: Vec<Vec<&Fact>> = Vec::new();
    // A breakdown comes first: it is what a person wants to hear of.
    let is_breakdown = |fact: &&Fact| fact.kind == FactKind::Breakdown;
    let (first, then): (Vec<&Fact>, Vec<&Fact>) = core.facts.iter().partition(is_breakdown);
    for fact in first.into_iter().chain(then) {
        match groups.iter_mut().find(|group| alike(group[0], fact)) {
            Some(group) => group.push(fact),
            None => groups.push(vec![fact]),
        }
    }
    let mut clauses = Vec::new();
    for group in &groups {
        if group.len() <= ONE_BY_ONE {
            clauses.extend(group.iter().map(|fact| (fact.text.clone(), 1)));
        } else {
            clauses.push((together(group), group.len()));
        }
    }
    if clauses.len() > CLAUSES && !core.groups.is_empty() {
        let groups: Vec<&str> = core.groups.iter().map(|it| it.text.as_str()).collect();
        return groups.join("; ");
    }
    if clauses.len() <= CLAUSES {
        return clauses
            .into_iter()
            .map(|(text, _)| text)
            .collect::<Vec<_>>()
            .join("; ");
    }
    let rest = clauses.split_off(CLAUSES - 1);
    let more: usize = rest.iter().map(|(_, facts)| facts).sum();
    let told: Vec<String> = clauses.into_iter().map(|(text, _)| text).collect();
    tr!(
        "{facts}; and {n} more" | "{facts}; and {n} more" % more,
        facts = told.join("; ")
    )
}

/// Facts of one kind as one clause.
pub(super) fn together(facts: &[&Fact]) -> String {
    let names: Vec<String> = facts.iter().map(|fact| and(&fact.agents)).collect();
    let list = || few(&names);
    let cells = || {
        let cells: Vec<Cell> = facts.iter().filter_map(|fact| fact.cell).collect();
        in_runs(&cells)
    };
    match facts[0].kind {
        FactKind::Task => tr!("{robots} must reach their goals", robots = list()),
        FactKind::Waypoint => tr!("{name} must visit {cell}", name = names[0], cell = cells()),
        FactKind::Battery => tr!("the batteries of {robots} are limited", robots = list()),
        FactKind::Obstacle => tr!("{cells} are obstacles", cells = cells()),
        FactKind::Collision => tr!("these pairs must not collide: {pairs}", pairs = list()),
        FactKind::Stay => tr!("{robots} stay at their goals", robots = list()),
        FactKind::Presence => tr!("{robots} may rest at any cell", robots = list()),
        FactKind::Rest => tr!("{robots} stay where they rest", robots = list()),
        // Of these there is one at most.
        FactKind::Slow | FactKind::Deadline | FactKind::Floor => facts[0].text.clone(),
        FactKind::Breakdown => tr!("{robots} are broken down", robots = list()),
        FactKind::Constraint => {
            let texts: Vec<String> = facts.iter().map(|fact| fact.text.clone()).collect();
            few(&texts)
        }
    }
}

/// A list, shortened where it is long.
fn few(list: &[String]) -> String {
    if list.len() <= IN_LIST {
        return and(list);
    }
    let (told, rest) = list.split_at(IN_LIST - 1);
    let (told, more) = (told.join(", "), rest.len());
    tr!("{told} and {more} more", told, more)
}

/// Cells, those in a row or a column as `(1, 0) to (9, 0)`.
pub(super) fn in_runs(cells: &[Cell]) -> String {
    let rows = runs(cells, |cell| (cell.y, cell.x));
    let columns = runs(cells, |cell| (cell.x, cell.y));
    let runs = if columns.len() < rows.len() {
        columns
    } else {
        rows
    };
    if runs.len() <= IN_LIST {
        let phrase = |run: &Vec<Cell>| match run[..] {
            [first, .., last] if run.len() > 2 => tr!("cells" => "{first} to {last}", first, last),
            _ => and(&texts(run)),
        };
        return and(&runs.iter().map(phrase).collect::<Vec<_>>());
    }
    few(&texts(&runs.concat()))
}

/// Cells by the blocks in which they lie side by side: full ones with their corners as `(4, 9) to (28, 10)`,
/// others in rows or columns.
pub(super) fn in_blocks(cells: &[Cell]) -> String {
    let mut rest: BTreeSet<Cell> = set(cells.iter().copied());
    let mut blocks = Vec::new();
    while let Some(first) = rest.pop_first() {
        let (mut from, mut to) = (first, first);
        let (mut open, mut block) = (vec![first], Vec::new());
        while let Some(cell) = open.pop() {
            block.push(cell);
            from = Cell::new(from.x.min(cell.x), from.y.min(cell.y));
            to = Cell::new(to.x.max(cell.x), to.y.max(cell.y));
            let beside = [
                (cell.x.checked_add(1), Some(cell.y)),
                (cell.x.checked_sub(1), Some(cell.y)),
                (Some(cell.x), cell.y.checked_add(1)),
                (Some(cell.x), cell.y.checked_sub(1)),
            ];
            let beside = beside.into_iter();
            for cell in beside.filter_map(|(x, y)| Some(Cell::new(x?, y?))) {
                if rest.remove(&cell) {
                    open.push(cell);
                }
            }
        }
        let sides = (u64::from(to.x - from.x) + 1, u64::from(to.y - from.y) + 1);
        blocks.push(if block.len() as u64 != sides.0 * sides.1 {
            sort(&mut block);
            in_runs(&block)
        } else if from == to {
            from.to_string()
        } else {
            tr!("cells" => "{first} to {last}", first = from, last = to)
        });
    }
    few(&blocks)
}

fn texts(cells: &[Cell]) -> Vec<String> {
    cells.iter().map(Cell::to_string).collect()
}

/// Cells in longest runs along a line; `place` is the line and the place on it.
fn runs(cells: &[Cell], place: impl Fn(&Cell) -> (u32, u32)) -> Vec<Vec<Cell>> {
    let mut cells = cells.to_vec();
    giveway_model::sorting::sort_by_key(&mut cells, &place);
    let follows = |a: &Cell, b: &Cell| {
        let ((line, at), next) = (place(a), place(b));
        next == (line, at + 1)
    };
    cells.chunk_by(follows).map(<[Cell]>::to_vec).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(cells: &[(u32, u32)]) -> String {
        let cells: Vec<Cell> = cells.iter().map(|&(x, y)| Cell::new(x, y)).collect();
        in_blocks(&cells)
    }

    #[test]
    fn only_full_blocks_have_corners() {
        assert_eq!(told(&[(2, 3), (1, 3), (1, 2), (2, 2)]), "(1, 2) to (2, 3)");
        assert_eq!(told(&[(4, 4), (1, 0)]), "(1, 0) and (4, 4)");
        // An L: its corners would take in (2, 0).
        assert_eq!(
            told(&[(1, 0), (1, 1), (2, 1)]),
            "(1, 0) and (1, 1) and (2, 1)"
        );
        // A frame around a cell that is free.
        let frame: Vec<(u32, u32)> = (0..9).filter(|&i| i != 4).map(|i| (i % 3, i / 3)).collect();
        assert!(!told(&frame).contains("(0, 0) to (2, 2)"));
    }
}
