//! The cell on the board, and beside it who passes, in order.

use std::collections::BTreeMap;

use giveway_model::{Cell, tr};

use super::crossing::{index, passes};
use crate::State;
use crate::inside::Sign;

/// At most so many robots stand in the strip.
const MOST: usize = 8;

/// The cell, and who passes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Strip {
    /// The cell.
    pub cell: Cell,
    /// Who passes, in order; of many those around the time shown.
    pub robots: Vec<StripRobot>,
    /// How many pass before the first of these, and after the last.
    pub more: (usize, usize),
}

/// A robot in the strip.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StripRobot {
    /// Its index.
    pub agent: usize,
    /// Whether it is out of the cell at the time shown.
    pub is_through: bool,
    /// Whether it is in the cell at the time shown.
    pub is_in: bool,
}

/// The cell and who passes it; `None` where the order is not shown.
pub fn strip(state: &State) -> Option<Strip> {
    let cell = state.order_cell()?;
    let time = state.view.playback.time;
    let mut robots = Vec::new();
    for pass in passes(state, cell) {
        let is_through = pass.leaves.is_some_and(|leaves| leaves < time);
        robots.extend(index(state, &pass.name).map(|agent| StripRobot {
            agent,
            is_through,
            is_in: pass.arrives <= time && !is_through,
        }));
    }
    let through = robots.iter().filter(|it| it.is_through).count();
    let before = through
        .saturating_sub(2)
        .min(robots.len().saturating_sub(MOST));
    let all = robots.len();
    let robots: Vec<StripRobot> = robots.into_iter().skip(before).take(MOST).collect();
    let after = all.saturating_sub(before + robots.len());
    Some(Strip {
        cell,
        robots,
        more: (before, after),
    })
}

/// The signs of the order in the legend; `None` where it is not shown.
pub fn legend(state: &State) -> Option<Vec<Sign>> {
    state.order_cell()?;
    let sign = |class, words: &str| Sign {
        class,
        agent: None,
        words: words.to_owned(),
    };
    let mut signs = vec![
        sign("k-ocell", tr!("a cell on the board" => "This cell")),
        sign("k-in-cell", tr!("a robot" => "is in it")),
        sign("k-link", tr!("must leave before")),
        sign("k-tight", tr!("no slack")),
    ];
    if state.late_plan().is_some() {
        signs.push(sign("k-planned", tr!("planned arrival")));
    }
    Some(signs)
}

/// What the names of cells end with: `3 robots pass: A6, A5, A4`; `None` where it is not shown.
pub fn notes(state: &State) -> Option<Vec<(Cell, String)>> {
    let order = state.order()?;
    let mut cells: BTreeMap<(u32, u32), Vec<(u32, &str)>> = BTreeMap::new();
    for agent in &order.agents {
        for visit in &agent.visits {
            let at = cells.entry((visit.cell.y, visit.cell.x)).or_default();
            at.push((visit.arrives, &agent.agent));
        }
    }
    let note = |((y, x), mut who): ((u32, u32), Vec<(u32, &str)>)| {
        giveway_model::sorting::sort_by_key(&mut who, |(time, _)| *time);
        let n = who.len() as u32;
        let who: Vec<&str> = who.into_iter().map(|(_, name)| name).collect();
        let who = who.join(", ");
        let note = tr!(
            "{n} robot passes: {who}" | "{n} robots pass: {who}" % n,
            who
        );
        (Cell::new(x, y), note)
    };
    Some(cells.into_iter().map(note).collect())
}
