//! Where cells are once rows and columns have come or gone.

use giveway_model::{Cell, Grid};

use super::{Axis, Lines, Reshape, Sides};
use crate::MAX_SIDE;

impl Reshape {
    /// The columns and rows of a floor then; at least one, at most as many as the page takes.
    pub(crate) fn size(self, grid: &Grid) -> (u32, u32) {
        let side = |length: u32, more: [i32; 2]| {
            let more = i64::from(more[0]) + i64::from(more[1]);
            let length = (i64::from(length) + more).clamp(1, MAX_SIDE.into());
            u32::try_from(length).unwrap_or(1)
        };
        let (across, down) = match self {
            Self::Sides(sides) => ([sides.left, sides.right], [sides.top, sides.bottom]),
            Self::Lines(lines) => match lines.axis {
                Axis::Columns => ([lines.more, 0], [0; 2]),
                Axis::Rows => ([0; 2], [lines.more, 0]),
            },
        };
        (side(grid.width(), across), side(grid.height(), down))
    }

    /// Where a cell is on a floor of `size` then; `None` where it is gone.
    pub(crate) fn moved(self, cell: Cell, size: (u32, u32)) -> Option<Cell> {
        let cell = match self {
            Self::Sides(Sides { left, top, .. }) => Cell::new(
                cell.x.checked_add_signed(left)?,
                cell.y.checked_add_signed(top)?,
            ),
            Self::Lines(lines) => lines.on_axis(cell, |at| lines.moved(at))?,
        };
        (cell.x < size.0 && cell.y < size.1).then_some(cell)
    }

    /// The nearest place on that floor.
    pub(super) fn nearest(self, cell: Cell, size: (u32, u32)) -> Cell {
        let cell = match self {
            Self::Sides(Sides { left, top, .. }) => Cell::new(
                cell.x.saturating_add_signed(left),
                cell.y.saturating_add_signed(top),
            ),
            Self::Lines(lines) => lines
                .on_axis(cell, |at| Some(lines.moved(at).unwrap_or(lines.at)))
                .unwrap_or(cell),
        };
        Cell::new(
            cell.x.min(size.0.saturating_sub(1)),
            cell.y.min(size.1.saturating_sub(1)),
        )
    }

    /// Where a cell of that floor is now; `None` of one that comes.
    pub(super) fn before(self, cell: Cell, grid: &Grid) -> Option<Cell> {
        let cell = match self {
            Self::Sides(Sides { left, top, .. }) => Cell::new(
                cell.x.checked_add_signed(left.saturating_neg())?,
                cell.y.checked_add_signed(top.saturating_neg())?,
            ),
            Self::Lines(lines) => lines.on_axis(cell, |at| lines.before(at))?,
        };
        (cell.x < grid.width() && cell.y < grid.height()).then_some(cell)
    }
}

impl Lines {
    /// How many come or go.
    pub(crate) const fn count(self) -> u32 {
        self.more.unsigned_abs()
    }

    /// How many come.
    pub(super) const fn coming(self) -> u32 {
        if self.more > 0 { self.count() } else { 0 }
    }

    /// A column or row then.
    fn moved(self, at: u32) -> Option<u32> {
        if at < self.at {
            return Some(at);
        }
        if self.more < 0 && at - self.at < self.count() {
            return None;
        }
        at.checked_add_signed(self.more)
    }

    /// The column or row that one of then is now.
    fn before(self, at: u32) -> Option<u32> {
        if at < self.at {
            return Some(at);
        }
        let coming = self.at.checked_add(self.coming())?;
        (at >= coming).then(|| at.checked_add_signed(self.more.saturating_neg()))?
    }

    fn on_axis(self, cell: Cell, to: impl Fn(u32) -> Option<u32>) -> Option<Cell> {
        Some(match self.axis {
            Axis::Columns => Cell::new(to(cell.x)?, cell.y),
            Axis::Rows => Cell::new(cell.x, to(cell.y)?),
        })
    }

    /// The cells that come between two neighbours, from the first to the second.
    pub(super) fn between(self, from: Cell, to: Cell) -> Vec<Cell> {
        let (one, other, is_straight) = match self.axis {
            Axis::Columns => (from.x, to.x, from.y == to.y),
            Axis::Rows => (from.y, to.y, from.x == to.x),
        };
        if !is_straight || one == other || one.max(other) != self.at {
            return Vec::new();
        }
        let cells = (self.at..self.at + self.coming()).map(|at| match self.axis {
            Axis::Columns => Cell::new(at, from.y),
            Axis::Rows => Cell::new(from.x, at),
        });
        if one < other {
            cells.collect()
        } else {
            cells.rev().collect()
        }
    }
}
