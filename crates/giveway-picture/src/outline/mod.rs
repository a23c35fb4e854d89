//! The outlines of sets of cells: neighbouring cells join into one shape.
//!
//! A map is outlined tile by tile, so that a change of one cell draws little anew.
//! A shape that goes on in the next tile is cut at the border: its fill reaches a
//! little over it, and so does the line around it, so that no seam is seen.

mod edge;
mod fill;
mod path;
#[cfg(test)]
mod tests;
mod walk;

use std::collections::BTreeSet;

use giveway_model::Cell;

use path::Units;
use walk::{At, Cells};

/// How an outline is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pen {
    /// How far it stays inside of the cells, in units.
    pub inset: i64,
    /// The radius of its corners, in units; 0 draws them sharp.
    pub radius: i64,
    /// How far a shape that is cut reaches over the border of its tile, in units;
    /// at most the side of a cell.
    pub overlap: i64,
}

/// A part of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// The first column and row.
    pub first: Cell,
    /// Columns and rows.
    pub size: (u32, u32),
}

impl Area {
    /// Its cells, row by row.
    pub fn cells(self) -> impl Iterator<Item = Cell> {
        let Cell { x, y } = self.first;
        let (width, height) = self.size;
        (y..y + height).flat_map(move |y| (x..x + width).map(move |x| Cell::new(x, y)))
    }

    /// Whether a cell is one of them.
    pub fn contains(self, cell: Cell) -> bool {
        let is_in = |at: u32, first: u32, size: u32| at >= first && at - first < size;
        is_in(cell.x, self.first.x, self.size.0) && is_in(cell.y, self.first.y, self.size.1)
    }
}

/// The `d` of the outline of some cells of a large map, so far inside of them.
pub(crate) fn around(cells: &BTreeSet<Cell>, inset: i64) -> String {
    let all = || cells.iter().copied();
    let first = all().reduce(|a, b| Cell::new(a.x.min(b.x), a.y.min(b.y)));
    let last = all().reduce(|a, b| Cell::new(a.x.max(b.x), a.y.max(b.y)));
    let (Some(first), Some(last)) = (first, last) else {
        return String::new();
    };
    let size = (last.x - first.x + 1, last.y - first.y + 1);
    let pen = Pen {
        inset,
        radius: 12,
        overlap: 0,
    };
    Region::new(Area { first, size }, |cell| cells.contains(&cell)).fill(pen)
}

/// A set of cells in an area and one cell around it: that much tells where a
/// shape goes on.
pub struct Region {
    area: Area,
    cells: Cells,
}

impl Region {
    /// The cells of an area that are in a set.
    pub fn new(area: Area, contains: impl Fn(Cell) -> bool) -> Self {
        let mut cells = Cells {
            width: area.size.0 as usize + 2,
            height: area.size.1 as usize + 2,
            has: Vec::new(),
        };
        let is_in = |(x, y): At| {
            let x = (area.first.x as usize + x).checked_sub(1)?;
            let y = (area.first.y as usize + y).checked_sub(1)?;
            Some(contains(Cell::new(x as u32, y as u32)))
        };
        cells.has = cells.all().map(|at| is_in(at) == Some(true)).collect();
        Self { area, cells }
    }

    const fn is_inside(&self, (x, y): At) -> bool {
        x > 0 && y > 0 && x + 1 < self.cells.width && y + 1 < self.cells.height
    }

    /// Where a side of a cell ends: of the upper side that is the upper right
    /// corner, and so on; in units of the map.
    fn end(&self, (x, y): At, side: usize) -> Units {
        let (across, down) = [(1, 0), (1, 1), (0, 1), (0, 0)][side];
        let place =
            |first: u32, at: usize, end: i64| 100 * (i64::from(first + at as u32) - 1 + end);
        (
            place(self.area.first.x, x, across),
            place(self.area.first.y, y, down),
        )
    }
}
