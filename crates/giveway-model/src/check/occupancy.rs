//! Occupancy: the agents at each vertex at one time.

use crate::{Cell, Grid};

/// Lists of agents by vertex, cleared in the time that it took to fill them.
///
/// Cells off the map and obstacles are no vertices and hold nobody.
pub(super) struct Occupancy<'a> {
    grid: &'a Grid,
    /// The agents at each vertex, by the vertex's number.
    agents: Vec<Vec<u32>>,
    /// The vertices where somebody is.
    touched: Vec<usize>,
}

impl<'a> Occupancy<'a> {
    pub(super) fn new(grid: &'a Grid) -> Self {
        let vertices = grid.width() as usize * grid.height() as usize;
        Self {
            grid,
            agents: vec![Vec::new(); vertices],
            touched: Vec::new(),
        }
    }

    /// Puts an agent at a cell.
    pub(super) fn put(&mut self, agent: usize, cell: Cell) {
        if let Some(number) = self.number(cell)
            && let Some(agents) = self.agents.get_mut(number)
        {
            agents.push(agent as u32);
            self.touched.push(number);
        }
    }

    /// The agents at a cell, in the order in which they were put there.
    pub(super) fn at(&self, cell: Cell) -> impl Iterator<Item = usize> + '_ {
        self.number(cell)
            .and_then(|number| self.agents.get(number))
            .into_iter()
            .flatten()
            .map(|&agent| agent as usize)
    }

    /// Takes everybody away.
    pub(super) fn clear(&mut self) {
        for number in self.touched.drain(..) {
            if let Some(agents) = self.agents.get_mut(number) {
                agents.clear();
            }
        }
    }

    fn number(&self, cell: Cell) -> Option<usize> {
        self.grid
            .is_vertex(cell)
            .then(|| cell.y as usize * self.grid.width() as usize + cell.x as usize)
    }
}
