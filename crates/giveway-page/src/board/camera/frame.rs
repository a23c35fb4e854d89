//! What is in sight on a screen: between units of the map, pixels and cells.

use crate::Point;
use crate::board::{CELL, Detail, whole};

/// What is in sight on a screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The left edge, in units of the map.
    pub x: f64,
    /// The upper edge, in units.
    pub y: f64,
    /// The width, in units.
    pub width: f64,
    /// The height, in units.
    pub height: f64,
    /// The side of a cell, in pixels.
    pub cell_px: f64,
}

impl Frame {
    /// The level of detail.
    pub fn detail(&self) -> Detail {
        Detail::of(self.cell_px)
    }

    /// The numbers on the axis stand at every so many cells; `None` where it has no room.
    ///
    /// ```
    /// use giveway_page::board::Frame;
    /// let of = |cell_px: f64, px: f64| Frame { x: 0.0, y: 0.0, width: px * 100.0 / cell_px, height: 1.0, cell_px };
    /// assert_eq!(of(48.0, 300.0).axis(), Some(1));
    /// assert_eq!(of(18.0, 800.0).axis(), Some(5));
    /// assert_eq!(of(2.0, 800.0).axis(), Some(20));
    /// assert_eq!(of(8.8, 358.0).axis(), None);
    /// ```
    pub fn axis(&self) -> Option<u32> {
        if self.detail() == Detail::All {
            return Some(1);
        }
        if self.width * self.cell_px / CELL < super::AXIS_FROM_PX {
            return None;
        }
        let fits = |every: &u32| f64::from(*every) * self.cell_px >= 24.0;
        Some([5, 10, 20, 50].into_iter().find(fits).unwrap_or(100))
    }

    /// So many pixels, in units.
    pub fn units(&self, px: f64) -> f64 {
        px * CELL / self.cell_px
    }

    /// The point of the map at a pixel, counted from the upper left: in cells,
    /// the middle of the first cell is `(0, 0)`.
    pub fn point(&self, px: (f64, f64)) -> Point {
        Point {
            x: (self.x + self.units(px.0)) / CELL - 0.5,
            y: (self.y + self.units(px.1)) / CELL - 0.5,
        }
    }

    /// Whether some of what stands at a point, which reaches into the cells around
    /// it, is in sight.
    ///
    /// ```
    /// use giveway_page::{Point, board::Frame};
    /// let frame = Frame { x: 200.0, y: 0.0, width: 350.0, height: 800.0, cell_px: 20.0 };
    /// let at = |x| Point { x, y: 3.0 };
    /// assert!(frame.shows(at(2.0)) && frame.shows(at(1.0)) && frame.shows(at(6.0)));
    /// assert!(!frame.shows(at(0.0)) && !frame.shows(at(7.0)));
    /// ```
    pub fn shows(&self, point: Point) -> bool {
        let part = |at: f64, from: f64, length: f64| {
            let middle = (at + 0.5) * CELL;
            middle > from - 1.5 * CELL && middle < from + length + 1.5 * CELL
        };
        part(point.x, self.x, self.width) && part(point.y, self.y, self.height)
    }

    /// The first and last column in sight, then the same of rows, within a map
    /// of some cells.
    pub fn cells(&self, board: (u32, u32)) -> ((u32, u32), (u32, u32)) {
        let part = |from: f64, length: f64, side: u32| {
            let last = side.saturating_sub(1);
            let first = whole(from / CELL);
            let end = whole((from + length) / CELL);
            (first.min(last), end.min(last))
        };
        (
            part(self.x, self.width, board.0),
            part(self.y, self.height, board.1),
        )
    }
}
