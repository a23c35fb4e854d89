//! Waypoints at random, beside obstacles.

use std::collections::BTreeSet;

use super::Way;
use crate::{Cell, Grid, parts::Parts};

/// Cells for waypoints, in the order of a draw.
pub(super) struct Waypoints {
    parts: Parts,
    cells: Vec<Cell>,
    next: usize,
}

impl Waypoints {
    /// Cells beside obstacles that are neither start nor goal, shuffled; any free cells where
    /// there is no obstacle.
    pub(super) fn of(grid: &Grid, ways: &[Way], draw: u32) -> Self {
        let taken: BTreeSet<Cell> = ways
            .iter()
            .flat_map(|&(start, goal)| [Some(start), goal])
            .flatten()
            .collect();
        let free = grid.cells().map(|(cell, _)| cell);
        let free: Vec<Cell> = free
            .filter(|&cell| grid.is_vertex(cell) && !taken.contains(&cell))
            .collect();
        let is_obstacle = |x: Option<u32>, y: Option<u32>| {
            let cell = x.zip(y).map(|(x, y)| Cell::new(x, y));
            cell.is_some_and(|cell| grid.ground(cell).is_some() && !grid.is_vertex(cell))
        };
        let is_beside = |&Cell { x, y }: &Cell| {
            is_obstacle(x.checked_sub(1), Some(y))
                || is_obstacle(x.checked_add(1), Some(y))
                || is_obstacle(Some(x), y.checked_sub(1))
                || is_obstacle(Some(x), y.checked_add(1))
        };
        let beside: Vec<Cell> = free.iter().copied().filter(is_beside).collect();
        let mut cells = if beside.is_empty() { free } else { beside };
        fastrand::Rng::with_seed(draw.into()).shuffle(&mut cells);
        Self {
            parts: Parts::of(grid),
            cells,
            next: 0,
        }
    }

    /// The next cells that a robot can come to from its start.
    pub(super) fn draw(&mut self, start: Cell, count: u32) -> Vec<Cell> {
        let part = self.parts.number(start);
        let mut drawn = Vec::new();
        for _ in 0..self.cells.len() {
            if drawn.len() == count as usize {
                break;
            }
            let cell = self.cells.get(self.next % self.cells.len()).copied();
            self.next += 1;
            drawn.extend(cell.filter(|&cell| self.parts.number(cell) == part));
        }
        drawn
    }
}
