//! The parts of a map that hang together.

use crate::{Cell, Grid};

/// The parts of a map, numbered; obstacles are in none.
pub struct Parts {
    width: u32,
    /// The number of each cell's part; 0 for obstacles.
    numbers: Vec<u32>,
    /// How many cells each part has.
    sizes: Vec<usize>,
}

impl Parts {
    /// The parts of a map.
    pub fn of(grid: &Grid) -> Self {
        let cells = grid.width() as usize * grid.height() as usize;
        let mut parts = Self {
            width: grid.width(),
            numbers: vec![0; cells],
            sizes: vec![0],
        };
        let mut reached = Vec::new();
        for (cell, ground) in grid.cells() {
            if !ground.is_vertex() || parts.number(cell) != 0 {
                continue;
            }
            let number = parts.sizes.len() as u32;
            let mut size = 0;
            parts.enter(cell, number, &mut reached);
            while let Some(cell) = reached.pop() {
                size += 1;
                for next in grid.neighbours(cell) {
                    if parts.number(next) == 0 {
                        parts.enter(next, number, &mut reached);
                    }
                }
            }
            parts.sizes.push(size);
        }
        parts
    }

    fn enter(&mut self, cell: Cell, number: u32, reached: &mut Vec<Cell>) {
        let index = self.index(cell);
        if let Some(part) = self.numbers.get_mut(index) {
            *part = number;
            reached.push(cell);
        }
    }

    fn index(&self, cell: Cell) -> usize {
        cell.y as usize * self.width as usize + cell.x as usize
    }

    /// The number of a cell's part; 0 where there is none.
    pub fn number(&self, cell: Cell) -> u32 {
        self.numbers.get(self.index(cell)).copied().unwrap_or(0)
    }

    /// How many cells a cell's part has.
    pub fn size(&self, cell: Cell) -> usize {
        let size = self.sizes.get(self.number(cell) as usize);
        size.copied().unwrap_or(0)
    }

    /// The cells of the largest part, the first of those that are alike.
    pub fn largest(&self, grid: &Grid) -> Vec<Cell> {
        let largest = self.sizes.iter().max().copied().unwrap_or(0);
        let number = self.sizes.iter().position(|&size| size == largest);
        let cells = grid.cells().filter(|&(cell, ground)| {
            ground.is_vertex() && Some(self.number(cell) as usize) == number
        });
        cells.map(|(cell, _)| cell).collect()
    }
}
