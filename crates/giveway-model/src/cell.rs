//! A cell of the map.

use std::fmt;

use serde::{Deserialize, Serialize};

/// A cell: `x` to the right, `y` down, both from 0 at the top left.
///
/// In JSON it is the pair `[x, y]`; in sentences it is written `(x, y)`.
///
/// ```
/// use giveway_model::Cell;
/// let cell = Cell::new(3, 1);
/// assert_eq!(cell.to_string(), "(3, 1)");
/// assert_eq!(serde_json::to_string(&cell).unwrap(), "[3,1]");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(from = "(u32, u32)", into = "(u32, u32)")]
pub struct Cell {
    /// Column, from 0 at the left.
    pub x: u32,
    /// Row, from 0 at the top.
    pub y: u32,
}

impl Cell {
    /// The cell in column `x` and row `y`.
    pub const fn new(x: u32, y: u32) -> Self {
        Self { x, y }
    }

    /// Whether the two cells share a side.
    pub const fn touches(self, other: Self) -> bool {
        self.x.abs_diff(other.x) + self.y.abs_diff(other.y) == 1
    }
}

impl From<(u32, u32)> for Cell {
    fn from((x, y): (u32, u32)) -> Self {
        Self { x, y }
    }
}

impl From<Cell> for (u32, u32) {
    fn from(cell: Cell) -> Self {
        (cell.x, cell.y)
    }
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", self.x, self.y)
    }
}
