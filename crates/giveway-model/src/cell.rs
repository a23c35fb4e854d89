//! A cell of the map.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::de::{self, IgnoredAny, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::tr;

/// A cell: `x` to the right, `y` down, both from 0 at the top left.
///
/// In JSON it is the pair `[x, y]`; in sentences it is written `(x, y)`. A cell
/// left of or above every map, which only a plan of elsewhere may name, wraps
/// around; sentences write it with the negative number that it was.
///
/// ```
/// use giveway_model::Cell;
/// let cell = Cell::new(3, 1);
/// assert_eq!(cell.to_string(), "(3, 1)");
/// assert_eq!(serde_json::to_string(&cell).unwrap(), "[3,1]");
/// ```
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    Hash,
    PartialOrd,
    Ord,
    Serialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(into = "(u32, u32)")]
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

    /// Column and row, negative where the cell is left of or above every map.
    pub const fn signed(self) -> (i32, i32) {
        (self.x.cast_signed(), self.y.cast_signed())
    }

    /// Whether the two cells share a side.
    pub const fn touches(self, other: Self) -> bool {
        matches!(
            (self.x.abs_diff(other.x), self.y.abs_diff(other.y)),
            (0, 1) | (1, 0)
        )
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

impl<'de> Deserialize<'de> for Cell {
    /// By hand, since a pair with a third number is a mistake worth a clear word.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pair;

        impl<'de> Visitor<'de> for Pair {
            type Value = Cell;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a cell [x, y]"))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Cell, A::Error> {
                let x = list.next_element()?;
                let y = list.next_element()?;
                let (Some(x), Some(y)) = (x, y) else {
                    return Err(de::Error::invalid_length(usize::from(x.is_some()), &self));
                };
                let mut length = 2;
                while list.next_element::<IgnoredAny>()?.is_some() {
                    length += 1;
                }
                if length > 2 {
                    return Err(de::Error::invalid_length(length, &self));
                }
                Ok(Cell { x, y })
            }
        }

        deserializer.deserialize_seq(Pair)
    }
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (x, y) = self.signed();
        write!(f, "({x}, {y})")
    }
}
