//! Grid distances: the fewest moves between cells, as if no edge were slow.

use std::collections::VecDeque;

use giveway_model::{Cell, Grid};

/// The distances from one cell to all others.
pub(super) struct Distances {
    width: u32,
    steps: Vec<Option<u32>>,
}

impl Distances {
    pub(super) fn from(grid: &Grid, start: Cell) -> Self {
        let size = grid.width() as usize * grid.height() as usize;
        let mut distances = Self {
            width: grid.width(),
            steps: vec![None; size],
        };
        distances.set(start, 0);
        let mut open = VecDeque::from([(start, 0)]);
        while let Some((u, steps)) = open.pop_front() {
            for v in grid.neighbours(u) {
                if distances.to(v).is_none() {
                    distances.set(v, steps + 1);
                    open.push_back((v, steps + 1));
                }
            }
        }
        distances
    }

    /// The distance to a cell; `None` where there is no way.
    pub(super) fn to(&self, cell: Cell) -> Option<u32> {
        self.steps.get(self.index(cell)).copied().flatten()
    }

    fn set(&mut self, cell: Cell, steps: u32) {
        let index = self.index(cell);
        if let Some(place) = self.steps.get_mut(index) {
            *place = Some(steps);
        }
    }

    fn index(&self, cell: Cell) -> usize {
        cell.y as usize * self.width as usize + cell.x as usize
    }
}

/// The fewest moves from one cell to another, as if no edge were slow.
pub(crate) fn grid_distance(grid: &Grid, from: Cell, to: Cell) -> Option<u32> {
    Distances::from(grid, from).to(to)
}
