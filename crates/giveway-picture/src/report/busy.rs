//! The cells that are used most.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use giveway_model::{Cell, sorting};

use super::{BusyCell, Subject};

/// How many there are.
const MOST: usize = 8;
/// The letters on the map.
const LETTERS: [&str; MOST] = ["a", "b", "c", "d", "e", "f", "g", "h"];

/// So many of the cells at which robots wait longest are told.
const WAITED: usize = 3;

/// The cells at which robots wait longest, with the steps of all of them.
pub(super) fn waited(subject: &Subject<'_>) -> Vec<(Cell, u32)> {
    let mut cells: Vec<(Cell, u32)> = uses(subject)
        .into_iter()
        .map(|(cell, of)| (cell, of.waits))
        .collect();
    cells.retain(|(_, waits)| *waits > 0);
    sorting::sort_by_key(&mut cells, |(cell, waits)| {
        (Reverse(*waits), cell.y, cell.x)
    });
    cells.truncate(WAITED);
    cells
}

/// The busiest cells: those that robots enter most often, then those of most robots, then those
/// where they wait longest. A cell that is entered by one robot once is not busy.
pub(super) fn busiest(subject: &Subject<'_>) -> Vec<BusyCell> {
    let mut cells: Vec<(Cell, Use)> = uses(subject).into_iter().collect();
    cells.retain(|(_, of)| of.passes > 1);
    sorting::sort_by_key(&mut cells, |(cell, of)| {
        (Reverse((of.passes, of.robots, of.waits)), cell.y, cell.x)
    });
    let lettered = cells.into_iter().zip(LETTERS);
    lettered
        .map(|((cell, of), letter)| BusyCell {
            letter: letter.to_owned(),
            cell,
            passes: of.passes,
            robots: of.robots,
            waits: of.waits,
        })
        .collect()
}

/// How each cell is used.
fn uses(subject: &Subject<'_>) -> BTreeMap<Cell, Use> {
    let mut uses: BTreeMap<Cell, Use> = BTreeMap::new();
    for (index, robot) in subject.robots.iter().enumerate() {
        let mut last = None;
        for (_, cell) in subject.way(robot) {
            let of = uses.entry(cell).or_default();
            if last == Some(cell) {
                of.waits += 1;
            } else {
                of.passes += 1;
            }
            if of.last != Some(index) {
                (of.last, of.robots) = (Some(index), of.robots + 1);
            }
            last = Some(cell);
        }
    }
    uses
}

#[derive(Clone, Copy, Debug, Default)]
struct Use {
    passes: u32,
    robots: usize,
    waits: u32,
    /// The robot that was there last.
    last: Option<usize>,
}
