//! One-way lanes that leave a way from every cell to every cell.

use std::collections::{BTreeSet, VecDeque};

use giveway_model::{Cell, Grid};

/// The moves that are left where lanes are one-way.
pub(super) struct Roads<'g> {
    pub(super) grid: &'g Grid,
    /// Moves that are forbidden.
    pub(super) closed: BTreeSet<(Cell, Cell)>,
}

impl Roads<'_> {
    /// The lanes of a line, each as long as it can be: it ends at obstacles, and where it
    /// would leave no other way back from a cell to the one before it, so that nothing is
    /// shut in.
    pub(super) fn lanes(&mut self, line: &[Cell]) -> Vec<Vec<Cell>> {
        let mut lanes = Vec::new();
        let mut lane: Vec<Cell> = Vec::new();
        for &cell in line {
            let goes_on = lane
                .last()
                .is_some_and(|&last| self.grid.is_vertex(cell) && self.has_other_way((cell, last)));
            if goes_on {
                if let Some(&last) = lane.last() {
                    self.closed.insert((cell, last));
                }
            } else if lane.len() > 1 {
                lanes.push(std::mem::take(&mut lane));
            } else {
                lane.clear();
            }
            if self.grid.is_vertex(cell) {
                lane.push(cell);
            }
        }
        lanes.extend(Some(lane).filter(|lane| lane.len() > 1));
        lanes
    }

    /// Whether a way leads from one cell to its neighbour that is not the move between them.
    pub(super) fn has_other_way(&self, (from, to): (Cell, Cell)) -> bool {
        let mut seen = BTreeSet::from([from]);
        let mut queue = VecDeque::from([from]);
        while let Some(cell) = queue.pop_front() {
            for next in self.grid.neighbours(cell) {
                let is_open = (cell, next) != (from, to) && !self.closed.contains(&(cell, next));
                if is_open && next == to {
                    return true;
                }
                if is_open && self.grid.is_vertex(next) && seen.insert(next) {
                    queue.push_back(next);
                }
            }
        }
        false
    }
}
