//! A side of the floor: what it is called, how far it may go, and where a hand has dragged it.

use giveway_model::{Grid, tr};
use giveway_picture::whole;

use crate::edit::Sides;
use crate::{MAX_SIDE, Point};

/// A side of the floor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The first columns.
    Left,
    /// The first rows.
    Top,
    /// The last columns.
    Right,
    /// The last rows.
    Bottom,
}

impl Side {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Top, Self::Left, Self::Right, Self::Bottom];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => tr!("Columns at the left"),
            Self::Top => tr!("Rows above"),
            Self::Right => tr!("Columns at the right"),
            Self::Bottom => tr!("Rows below"),
        }
    }

    /// How many more there are, or less.
    pub const fn of(self, sides: Sides) -> i32 {
        match self {
            Self::Left => sides.left,
            Self::Top => sides.top,
            Self::Right => sides.right,
            Self::Bottom => sides.bottom,
        }
    }

    /// Whether columns come and go at it, not rows.
    pub const fn is_across(self) -> bool {
        matches!(self, Self::Left | Self::Right)
    }

    /// So many rows or columns more or less at it, in words.
    pub fn told(self, more: i32) -> String {
        let n = more.unsigned_abs();
        match (self.is_across(), more < 0) {
            (true, false) => tr!("{n} column more" | "{n} columns more" % n),
            (true, true) => tr!("{n} column less" | "{n} columns less" % n),
            (false, false) => tr!("{n} row more" | "{n} rows more" % n),
            (false, true) => tr!("{n} row less" | "{n} rows less" % n),
        }
    }

    /// The side across the floor from it.
    const fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Top => Self::Bottom,
            Self::Right => Self::Left,
            Self::Bottom => Self::Top,
        }
    }

    /// How many rows or columns the floor has in its direction.
    pub(super) const fn length(self, grid: &Grid) -> u32 {
        if self.is_across() {
            grid.width()
        } else {
            grid.height()
        }
    }

    /// The least and the most rows or columns more at it, beside what is at the other sides: one
    /// row and one column are kept, and there are at most [`MAX_SIDE`].
    pub(crate) fn limits(self, sides: Sides, grid: &Grid) -> (i32, i32) {
        let number = |n: u32| i32::try_from(n).unwrap_or(i32::MAX);
        let (length, other) = (number(self.length(grid)), self.opposite().of(sides));
        (1 - length - other.min(0), number(MAX_SIDE) - length - other)
    }

    /// How many rows or columns more there are where it is dragged to a point of the map.
    pub(crate) fn dragged(self, to: Point, grid: &Grid) -> i32 {
        let number = |n: u32| i32::try_from(n).unwrap_or(i32::MAX);
        let at = 0.5 + if self.is_across() { to.x } else { to.y };
        let at = number(whole(at.round())) - number(whole(-at.round()));
        match self {
            Self::Left | Self::Top => -at,
            Self::Right | Self::Bottom => at - number(self.length(grid)),
        }
    }
}
