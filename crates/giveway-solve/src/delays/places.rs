//! The places at which most steps are lost.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use giveway_model::{
    Cell,
    sorting::{map, sort_by_key},
};

use super::{AgentDelay, AgentLoss, CellLoss, LossPlace};

/// So many places are told.
const MOST: usize = 3;

/// The places with most lost steps, the worst first; no cell is in two of them. Of places with
/// as many the shorter is the first, then that further up, further to the left.
pub(super) fn places(heat: &[CellLoss], rows: &[AgentDelay]) -> Vec<LossPlace> {
    let steps: BTreeMap<(u32, u32), u32> =
        map(heat.iter().map(|it| ((it.cell.x, it.cell.y), it.steps)));
    let right = |(x, y): (u32, u32)| (x.saturating_add(1), y);
    let down = |(x, y): (u32, u32)| (x, y.saturating_add(1));
    let left = |(x, y): (u32, u32)| Some((x.checked_sub(1)?, y));
    let up = |(x, y): (u32, u32)| Some((x, y.checked_sub(1)?));
    let mut runs = longest_runs(&steps, left, right);
    runs.extend(longest_runs(&steps, up, down));
    let sum = |run: &Vec<(u32, u32)>| run.iter().filter_map(|cell| steps.get(cell)).sum::<u32>();
    sort_by_key(&mut runs, |run| {
        let first = run.first().map(|&(x, y)| (y, x));
        (Reverse(sum(run)), run.len(), first)
    });
    let mut places: Vec<LossPlace> = Vec::new();
    for run in runs {
        let cells: Vec<Cell> = run.iter().map(|&cell| Cell::from(cell)).collect();
        let is_told = |cell: &Cell| places.iter().any(|place| place.cells.contains(cell));
        if places.len() < MOST && !cells.iter().any(is_told) {
            places.push(LossPlace {
                steps: sum(&run),
                agents: losers(&cells, rows),
                cells,
            });
        }
    }
    places
}

/// The longest runs of cells, each the next of the one before it.
fn longest_runs(
    steps: &BTreeMap<(u32, u32), u32>,
    before: impl Fn((u32, u32)) -> Option<(u32, u32)>,
    next: impl Fn((u32, u32)) -> (u32, u32),
) -> Vec<Vec<(u32, u32)>> {
    let is_lost = |cell: &(u32, u32)| steps.contains_key(cell);
    let first = steps
        .keys()
        .filter(|&&cell| !before(cell).as_ref().is_some_and(is_lost));
    let run = |&first: &(u32, u32)| {
        let cells = std::iter::successors(Some(first), |&cell| Some(next(cell)).filter(is_lost));
        cells.collect()
    };
    first.map(run).collect()
}

/// Who loses how much at some cells, who loses most first.
fn losers(cells: &[Cell], rows: &[AgentDelay]) -> Vec<AgentLoss> {
    let loss = |row: &AgentDelay| AgentLoss {
        agent: row.agent.clone(),
        steps: row
            .lost
            .iter()
            .filter(|it| cells.contains(&it.cell))
            .map(|it| it.steps)
            .sum(),
    };
    let mut losers: Vec<AgentLoss> = rows.iter().map(loss).filter(|it| it.steps > 0).collect();
    sort_by_key(&mut losers, |it| Reverse(it.steps));
    losers
}
