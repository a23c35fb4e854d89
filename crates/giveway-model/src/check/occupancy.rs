//! Occupancy: the agents at each vertex at one time.

use crate::{Cell, Grid};

/// Lists of agents by vertex, cleared in the time that it took to fill them.
///
/// Cells off the map and obstacles are no vertices and hold nobody. A large map costs little: each list is
/// a chain of entries.
pub(super) struct Occupancy<'a> {
    grid: &'a Grid,
    /// The first entry at each vertex, counted from 1, by the vertex's number; 0 where nobody is.
    first: Vec<u32>,
    /// The last one, likewise.
    last: Vec<u32>,
    entries: Vec<Entry>,
}

struct Entry {
    agent: u32,
    /// The vertex's number.
    vertex: usize,
    /// The next entry at the vertex, counted from 1; 0 for none.
    next: u32,
}

impl<'a> Occupancy<'a> {
    pub(super) fn new(grid: &'a Grid) -> Self {
        let vertices = grid.width() as usize * grid.height() as usize;
        Self {
            grid,
            first: vec![0; vertices],
            last: vec![0; vertices],
            entries: Vec::new(),
        }
    }

    /// Puts an agent at a cell.
    pub(super) fn put(&mut self, agent: usize, cell: Cell) {
        let Some(vertex) = self.number(cell) else {
            return;
        };
        self.entries.push(Entry {
            agent: agent as u32,
            vertex,
            next: 0,
        });
        let new = self.entries.len() as u32;
        let before = std::mem::replace(&mut self.last[vertex], new);
        match self.entries.get_mut((before as usize).wrapping_sub(1)) {
            Some(before) => before.next = new,
            None => self.first[vertex] = new,
        }
    }

    /// The agents at a cell, in the order in which they were put there.
    pub(super) fn at(&self, cell: Cell) -> impl Iterator<Item = usize> + '_ {
        let entry = |number: u32| self.entries.get((number as usize).wrapping_sub(1));
        let first = self
            .number(cell)
            .and_then(|vertex| entry(self.first[vertex]));
        let all = std::iter::successors(first, move |it| entry(it.next));
        all.map(|it| it.agent as usize)
    }

    /// Takes everybody away.
    pub(super) fn clear(&mut self) {
        for entry in self.entries.drain(..) {
            self.first[entry.vertex] = 0;
            self.last[entry.vertex] = 0;
        }
    }

    fn number(&self, cell: Cell) -> Option<usize> {
        self.grid
            .is_vertex(cell)
            .then(|| cell.y as usize * self.grid.width() as usize + cell.x as usize)
    }
}
