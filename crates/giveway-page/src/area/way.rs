//! Where the cells of an area go: moved, mirrored or turned.

use giveway_model::Cell;

/// A map of cells to cells. Each new coordinate is one of the old ones, added to or taken from
/// a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// Whether columns become rows.
    turns: bool,
    /// The new column and row of the cell (0, 0).
    origin: (i64, i64),
    /// Whether a coordinate grows (1) or falls (-1) with the old one.
    sign: (i64, i64),
}

impl Way {
    /// So many cells right and down.
    pub(crate) fn by((dx, dy): (i32, i32)) -> Self {
        Self {
            turns: false,
            origin: (dx.into(), dy.into()),
            sign: (1, 1),
        }
    }

    /// Mirrored within a frame: left and right change places (`across`), or above and below.
    pub(crate) fn mirror([x0, y0, x1, y1]: [u32; 4], across: bool) -> Self {
        let sum = |one: u32, other: u32| i64::from(one) + i64::from(other);
        Self {
            turns: false,
            origin: if across {
                (sum(x0, x1), 0)
            } else {
                (0, sum(y0, y1))
            },
            sign: if across { (-1, 1) } else { (1, -1) },
        }
    }

    /// Turned right by a quarter, so that a frame keeps its upper left corner, but for a map of
    /// `width` and `height` that it would leave.
    pub(crate) fn turn([x0, y0, x1, y1]: [u32; 4], (width, height): (u32, u32)) -> Self {
        let [x0, y0, x1, y1, width, height] = [x0, y0, x1, y1, width, height].map(i64::from);
        let (across, down) = (y1 - y0, x1 - x0);
        let left = x0.min(width - 1 - across);
        let top = y0.min(height - 1 - down);
        Self {
            turns: true,
            origin: (left + y1, top - x0),
            sign: (-1, 1),
        }
    }

    /// Where a cell goes; `None` where no cell can be.
    pub(crate) fn of(&self, cell: Cell) -> Option<Cell> {
        let (x, y) = if self.turns {
            (cell.y, cell.x)
        } else {
            (cell.x, cell.y)
        };
        let x = self.origin.0 + self.sign.0 * i64::from(x);
        let y = self.origin.1 + self.sign.1 * i64::from(y);
        Some(Cell::new(u32::try_from(x).ok()?, u32::try_from(y).ok()?))
    }
}
