//! What the board shows around the floor while its size is changed: room to drag its sides into.

use super::{Growing, Side};
use crate::State;
use crate::board::Frame;
use crate::edit::{Reshape, Sides};

/// How many cells there are around the floor on its way to another size: a part of its length,
/// at least and at most so many.
const PART: u32 = 10;
const CELLS: (u32, u32) = (2, 8);

/// The floor with free room around it, in cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// How many columns there are left of the floor, and rows above it.
    pub before: (u32, u32),
    /// Columns and rows in all.
    pub size: (u32, u32),
}

impl Room {
    /// A floor of so many columns and rows, with nothing around it.
    pub const fn of(size: (u32, u32)) -> Self {
        Self {
            before: (0, 0),
            size,
        }
    }

    /// What is in sight of the floor, from what is in sight of the room.
    #[must_use]
    pub fn frame(self, frame: Frame) -> Frame {
        Frame {
            x: frame.x - 100.0 * f64::from(self.before.0),
            y: frame.y - 100.0 * f64::from(self.before.1),
            ..frame
        }
    }
}

impl State {
    /// What the board shows. It stays while a side is held: the floor does not move under the hand.
    pub fn room(&self) -> Room {
        let grid = self.world().grid();
        let here = Room::of((grid.width(), grid.height()));
        let Some(Growing { to, held, .. }) = self.growing() else {
            return here;
        };
        let Reshape::Sides(sides) = to else {
            return here;
        };
        let around = |side: Side| {
            let more = u32::try_from(side.of(held.unwrap_or(sides))).unwrap_or(0);
            more + (side.length(grid) / PART).clamp(CELLS.0, CELLS.1)
        };
        let [left, top, right, bottom] =
            [Side::Left, Side::Top, Side::Right, Side::Bottom].map(around);
        Room {
            before: (left, top),
            size: (left + grid.width() + right, top + grid.height() + bottom),
        }
    }

    /// The least and the most rows or columns more at a side.
    pub fn side_limits(&self, side: Side) -> (i32, i32) {
        let sides = self.growing().map_or_else(Sides::default, Growing::sides);
        side.limits(sides, self.document.draft.grid())
    }

    /// How many rows or columns more there are at a side that is dragged to a point of the map.
    pub fn side_dragged(&self, side: Side, to: crate::Point) -> i32 {
        side.dragged(to, self.document.draft.grid())
    }
}
