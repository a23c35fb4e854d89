//! The cells that are used most.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use giveway_model::{Cell, sorting};

use super::{BusyCell, Subject};

/// How many there are.
const MOST: usize = 8;
/// The letters on the map.
const LETTERS: [&str; MOST] = ["a", "b", "c", "d", "e", "f", "g", "h"];

/// The busiest cells: those that robots enter most often, then those of most robots, then those
/// where they wait longest. A cell that is entered by one robot once is not busy.
pub(super) fn busiest(subject: &Subject<'_>) -> Vec<BusyCell> {
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
    let mut cells: Vec<(Cell, Use)> = uses.into_iter().collect();
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

#[derive(Clone, Copy, Debug, Default)]
struct Use {
    passes: u32,
    robots: usize,
    waits: u32,
    /// The robot that was there last.
    last: Option<usize>,
}
