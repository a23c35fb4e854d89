//! Which part of the map is in sight, and how large.

mod axis;
mod frame;
#[cfg(test)]
mod tests;

use giveway_model::Cell;

pub use axis::AxisPlace;
pub use frame::Frame;

use super::{CELL, Detail};
use crate::Point;

/// The largest side of a cell, in pixels.
pub const MAX_CELL_PX: f64 = 148.0;
/// The same before a room.
pub const PRESENTED_CELL_PX: f64 = 592.0;

/// The side of a cell that was looked for, in pixels, where cells were too small.
const FOUND_PX: f64 = 20.0;

/// The space around the map where the axis stands, in units: left and above,
/// then right and below.
const AXIS: (f64, f64) = (34.0, 10.0);
/// The space of the axis of small cells left and above, in pixels.
const AXIS_PX: f64 = 20.0;
/// The space around the map without an axis, in pixels.
const RIM_PX: f64 = 3.0;
/// The narrowest screen with room for the axis of small cells, in pixels.
const AXIS_FROM_PX: f64 = 480.0;

/// What a person looks at: as much as fits, or nearer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// How much larger than what fits; at least 1.
    zoom: f64,
    /// The point in the middle, in cells; it matters only where not all is in
    /// sight.
    middle: Point,
    /// The largest side of a cell, in pixels.
    largest: f64,
}

impl Default for Camera {
    fn default() -> Self {
        Self::up_to(MAX_CELL_PX)
    }
}

/// The side of a cell where all fits, in pixels.
fn fit_px(board: (u32, u32), screen: (f64, f64), largest: f64) -> f64 {
    let least = |space: f64, px: f64| {
        let across = (screen.0 - px).max(1.0) / (f64::from(board.0) + space);
        let down = (screen.1 - px).max(1.0) / (f64::from(board.1) + space);
        across.min(down).min(largest)
    };
    let with_axis = least((AXIS.0 + AXIS.1) / CELL, 0.0);
    if Detail::of(with_axis) == Detail::All {
        return with_axis;
    }
    // Not so large that the larger axis would be there after all.
    least(0.0, rim_px(screen) + RIM_PX).min(47.9)
}

/// The space left of small cells and above them, in pixels.
fn rim_px(screen: (f64, f64)) -> f64 {
    if screen.0 < AXIS_FROM_PX {
        RIM_PX
    } else {
        AXIS_PX
    }
}

impl Camera {
    /// One that shows all, with cells of at most so many pixels.
    pub const fn up_to(largest: f64) -> Self {
        Self {
            zoom: 1.0,
            middle: Point { x: 0.0, y: 0.0 },
            largest,
        }
    }

    /// What is in sight of a map of some cells on a screen of some pixels.
    pub fn frame(&self, board: (u32, u32), screen: (f64, f64)) -> Frame {
        let cell_px = self.cell_px(board, screen);
        let unit = CELL / cell_px;
        let (before, after) = match Detail::of(cell_px) {
            Detail::All => AXIS,
            _ => (rim_px(screen) * unit, RIM_PX * unit),
        };
        let place = |screen: f64, side: u32, middle: f64| {
            let seen = screen * unit;
            let (from, to) = (-before, f64::from(side) * CELL + after);
            if seen >= to - from {
                return (f64::midpoint(from, to) - seen / 2.0, seen);
            }
            let begin = (middle + 0.5) * CELL - seen / 2.0;
            (begin.clamp(from, to - seen), seen)
        };
        let (x, width) = place(screen.0, board.0, self.middle.x);
        let (y, height) = place(screen.1, board.1, self.middle.y);
        Frame {
            x,
            y,
            width,
            height,
            cell_px,
        }
    }

    fn cell_px(&self, board: (u32, u32), screen: (f64, f64)) -> f64 {
        (self.fit_px(board, screen) * self.zoom).min(self.largest)
    }

    fn fit_px(&self, board: (u32, u32), screen: (f64, f64)) -> f64 {
        fit_px(board, screen, self.largest)
    }

    /// Whether all is in sight.
    pub fn is_fit(&self) -> bool {
        self.zoom <= 1.0
    }

    /// Whether cells are as large as they get.
    pub fn is_nearest(&self, board: (u32, u32), screen: (f64, f64)) -> bool {
        self.cell_px(board, screen) >= self.largest
    }

    /// Larger or smaller by a factor; the point at a pixel stays where it is.
    #[must_use]
    pub fn zoom(
        &self,
        factor: f64,
        at_px: (f64, f64),
        board: (u32, u32),
        screen: (f64, f64),
    ) -> Self {
        let nearest = (self.largest / self.fit_px(board, screen)).max(1.0);
        let stays = self.frame(board, screen).point(at_px);
        let zoom = (self.zoom * factor).clamp(1.0, nearest);
        let cell_px = self.fit_px(board, screen) * zoom;
        let middle = Point {
            x: stays.x + (screen.0 / 2.0 - at_px.0) / cell_px,
            y: stays.y + (screen.1 / 2.0 - at_px.1) / cell_px,
        };
        Self {
            zoom,
            middle,
            ..*self
        }
        .settled(board, screen)
    }

    /// Moved by the way of a pointer, in pixels.
    #[must_use]
    pub fn pan(&self, by_px: (f64, f64), board: (u32, u32), screen: (f64, f64)) -> Self {
        let cell_px = self.cell_px(board, screen);
        let now = self.settled(board, screen);
        let middle = Point {
            x: now.middle.x - by_px.0 / cell_px,
            y: now.middle.y - by_px.1 / cell_px,
        };
        Self { middle, ..now }.settled(board, screen)
    }

    /// Moved just so far that a cell is wholly in sight.
    #[must_use]
    pub fn show(&self, cell: Cell, board: (u32, u32), screen: (f64, f64)) -> Self {
        let frame = self.frame(board, screen);
        let beyond = |from: f64, length: f64, cell: u32| {
            let (begin, end) = (f64::from(cell) * CELL, f64::from(cell + 1) * CELL);
            (begin - from).min(0.0) + (end - from - length).max(0.0)
        };
        let units = (
            beyond(frame.x, frame.width, cell.x),
            beyond(frame.y, frame.height, cell.y),
        );
        let px = frame.cell_px / CELL;
        self.pan((-units.0 * px, -units.1 * px), board, screen)
    }

    /// Moved so that a cell can be found: in the middle, unless it is wholly in sight;
    /// nearer where agents are dots.
    #[must_use]
    pub fn find(&self, cell: Cell, board: (u32, u32), screen: (f64, f64)) -> Self {
        let cell_px = self.cell_px(board, screen);
        let is_seen = self.show(cell, board, screen) == self.settled(board, screen);
        let nearer = match Detail::of(cell_px) {
            Detail::Dots => FOUND_PX / cell_px,
            _ if is_seen => return *self,
            _ => 1.0,
        };
        let middle = Point {
            x: f64::from(cell.x),
            y: f64::from(cell.y),
        };
        self.zoom(nearer, (0.0, 0.0), board, screen)
            .centred(middle, board, screen)
    }

    /// Moved so that a point, in cells, is in the middle, as far as the map goes.
    #[must_use]
    pub fn centred(&self, middle: Point, board: (u32, u32), screen: (f64, f64)) -> Self {
        Self { middle, ..*self }.settled(board, screen)
    }

    /// With the middle that is really shown, so that nothing is dragged beyond
    /// the edge and must be dragged back.
    fn settled(&self, board: (u32, u32), screen: (f64, f64)) -> Self {
        let frame = self.frame(board, screen);
        let middle = frame.point((screen.0 / 2.0, screen.1 / 2.0));
        Self { middle, ..*self }
    }
}
