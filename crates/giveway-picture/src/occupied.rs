//! Which cells agents stand on, so that what else is there makes way.

use std::collections::BTreeSet;

use giveway_model::Cell;

use crate::{Point, Track, whole};

/// How near to the middle of a cell an agent hides what is there, in cells.
const REACH: f64 = 0.75;

/// The cells that agents stand on or come to.
#[derive(Clone, Debug, Default)]
pub struct Occupied {
    cells: BTreeSet<Cell>,
}

impl Occupied {
    /// Takes in where the agents are at a time.
    pub fn see(&mut self, tracks: &[Track], time: f64) {
        self.cells.clear();
        for track in tracks {
            if let Some(pose) = track.pose(time).filter(|pose| !pose.is_gone) {
                self.add(pose.at);
            }
        }
    }

    fn add(&mut self, at: Point) {
        let reached = |at: f64, cell: u32| (at - f64::from(cell)).abs() < REACH;
        let (left, top) = (whole(at.x), whole(at.y));
        for (x, y) in [(left, top), (left + 1, top), (left, top + 1)] {
            if reached(at.x, x) && reached(at.y, y) {
                self.cells.insert(Cell::new(x, y));
            }
        }
    }

    /// Whether a cell is occupied.
    pub fn has(&self, cell: Cell) -> bool {
        self.cells.contains(&cell)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_two_cells_both_are_occupied() {
        let cells = |x, y| {
            let mut occupied = Occupied::default();
            occupied.add(Point { x, y });
            let cells = occupied.cells.into_iter();
            cells.map(|cell| (cell.x, cell.y)).collect::<Vec<_>>()
        };
        assert_eq!(cells(2.0, 1.0), [(2, 1)]);
        assert_eq!(cells(2.5, 1.0), [(2, 1), (3, 1)]);
        assert_eq!(cells(2.0, 1.9), [(2, 2)]);
        assert_eq!(cells(2.0, 1.6), [(2, 1), (2, 2)]);
    }
}
