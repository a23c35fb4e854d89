//! A shape on its way onto the board.

use giveway_model::{Cell, Grid, tr};

use crate::draw::{Drawing, Drawn, Measure, Shape, drawn};
use crate::edit::{Edit, Paint};

/// What a shape does to its cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    /// Paints, or takes away what was painted.
    Paint(Paint, bool),
    /// Takes away what is on them.
    Erase,
}

/// A shape, and what it does to its cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shaped {
    shape: Shape,
    ink: Ink,
    sizes: Drawing,
}

impl Shaped {
    pub(crate) fn new(shape: Shape, ink: Ink, sizes: Drawing) -> Self {
        // Only chargers stand apart from each other.
        let sizes = match ink {
            Ink::Paint(Paint::Charger, true) => sizes,
            Ink::Paint(Paint::Charger | Paint::Obstacle | Paint::Slow, _) | Ink::Erase => {
                sizes.with_measure(Measure::Every, 1)
            }
        };
        Self { shape, ink, sizes }
    }

    /// Whether each cell that the hand comes over is done by itself.
    pub(crate) fn is_free(&self) -> bool {
        self.shape == Shape::Pen
    }

    fn drawn(&self, from: Cell, to: Cell, grid: &Grid) -> Drawn {
        drawn(self.shape, from, to, &self.sizes, grid)
    }

    /// What it does to a cell.
    pub(crate) fn edit(&self, cell: Cell) -> Edit {
        match self.ink {
            Ink::Paint(paint, on) => Edit::Paint(paint, cell, on),
            Ink::Erase => Edit::Erase(cell),
        }
    }

    /// What it does between two cells, on a map as it was before.
    pub(crate) fn edits(&self, from: Cell, to: Cell, grid: &Grid) -> Vec<Edit> {
        let drawn = self.drawn(from, to, grid);
        drawn.cells.iter().map(|&cell| self.edit(cell)).collect()
    }

    /// Its size in words: `25 × 6: 2 racks, 100 cells`.
    pub(crate) fn words(&self, from: Cell, to: Cell, grid: &Grid) -> String {
        let Drawn { cells, pieces } = self.drawn(from, to, grid);
        let cells = tr!("{n} cell" | "{n} cells" % cells.len());
        let size = format!(
            "{} \u{d7} {}",
            from.x.abs_diff(to.x) + 1,
            from.y.abs_diff(to.y) + 1
        );
        match self.shape {
            Shape::Racks => {
                let racks = tr!("{n} rack" | "{n} racks" % pieces);
                tr!("{size}: {racks}, {cells}", size, racks, cells)
            }
            Shape::Blocks => {
                let blocks = tr!("{n} block" | "{n} blocks" % pieces);
                tr!("{size}: {blocks}, {cells}", size, blocks, cells)
            }
            Shape::Rectangle | Shape::Aisle => tr!("{size}: {cells}", size, cells),
            Shape::Pen | Shape::Line | Shape::Fill | Shape::One | Shape::Row => cells,
        }
    }
}
