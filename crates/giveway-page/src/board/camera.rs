//! Which part of the map is in sight, and how large.

use giveway_model::Cell;

use super::{CELL, Detail, whole};
use crate::Point;

/// The largest side of a cell, in pixels.
pub const MAX_CELL_PX: f64 = 148.0;

/// The space around the map where the axis stands, in units: left and above,
/// then right and below.
const AXIS: (f64, f64) = (34.0, 10.0);
/// The space around the map without an axis, in pixels.
const RIM_PX: f64 = 3.0;

/// What a person looks at: as much as fits, or nearer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// How much larger than what fits; at least 1.
    zoom: f64,
    /// The point in the middle, in cells; it matters only where not all is in
    /// sight.
    middle: Point,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            zoom: 1.0,
            middle: Point { x: 0.0, y: 0.0 },
        }
    }
}

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

/// The side of a cell where all fits, in pixels.
fn fit_px(board: (u32, u32), screen: (f64, f64)) -> f64 {
    let least = |space: f64, px: f64| {
        let across = (screen.0 - px).max(1.0) / (f64::from(board.0) + space);
        let down = (screen.1 - px).max(1.0) / (f64::from(board.1) + space);
        across.min(down).min(MAX_CELL_PX)
    };
    let with_axis = least((AXIS.0 + AXIS.1) / CELL, 0.0);
    if Detail::of(with_axis) == Detail::All {
        return with_axis;
    }
    // Not so large that the axis would be there after all.
    least(0.0, 2.0 * RIM_PX).min(47.9)
}

impl Camera {
    /// What is in sight of a map of some cells on a screen of some pixels.
    pub fn frame(&self, board: (u32, u32), screen: (f64, f64)) -> Frame {
        let cell_px = self.cell_px(board, screen);
        let unit = CELL / cell_px;
        let (before, after) = match Detail::of(cell_px) {
            Detail::All => AXIS,
            _ => (RIM_PX * unit, RIM_PX * unit),
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
        (fit_px(board, screen) * self.zoom).min(MAX_CELL_PX)
    }

    /// Whether all is in sight.
    pub fn is_fit(&self) -> bool {
        self.zoom <= 1.0
    }

    /// Whether cells are as large as they get.
    pub fn is_nearest(&self, board: (u32, u32), screen: (f64, f64)) -> bool {
        self.cell_px(board, screen) >= MAX_CELL_PX
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
        let nearest = (MAX_CELL_PX / fit_px(board, screen)).max(1.0);
        let stays = self.frame(board, screen).point(at_px);
        let zoom = (self.zoom * factor).clamp(1.0, nearest);
        let cell_px = fit_px(board, screen) * zoom;
        let middle = Point {
            x: stays.x + (screen.0 / 2.0 - at_px.0) / cell_px,
            y: stays.y + (screen.1 / 2.0 - at_px.1) / cell_px,
        };
        Self { zoom, middle }.settled(board, screen)
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
        Self {
            zoom: self.zoom,
            middle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOARD: (u32, u32) = (10, 3);
    const SCREEN: (f64, f64) = (898.0, 440.0);

    fn fit() -> Frame {
        Camera::default().frame(BOARD, SCREEN)
    }

    #[track_caller]
    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-6, "{a} {b}");
    }

    #[test]
    fn all_fits_with_its_axis() {
        let frame = fit();
        near(frame.cell_px, 898.0 / 10.44);
        near(frame.x, -34.0);
        near(frame.width, 1044.0);
        near(frame.y + frame.height / 2.0, 138.0);
        assert_eq!(frame.detail(), Detail::All);
    }

    #[test]
    fn a_small_map_is_not_stretched() {
        let frame = Camera::default().frame((2, 2), (1000.0, 1000.0));
        near(frame.cell_px, 148.0);
        near(frame.x + frame.width / 2.0, 88.0);
        assert!(Camera::default().is_nearest((2, 2), (1000.0, 1000.0)));
    }

    #[test]
    fn small_cells_have_no_axis() {
        let frame = Camera::default().frame(BOARD, (358.0, 240.0));
        near(frame.cell_px, 35.2);
        near(frame.x, -RIM_PX * CELL / 35.2);
    }

    #[test]
    fn an_area_without_size_does_no_harm() {
        let frame = Camera::default().frame((256, 256), (0.0, 0.0));
        assert!(frame.cell_px > 0.0 && frame.x.is_finite());
    }

    #[test]
    fn zoom_keeps_the_point_under_the_pointer() {
        let at = (700.0, 200.0);
        let before = fit().point(at);
        let camera = Camera::default().zoom(1.5, at, BOARD, SCREEN);
        let after = camera.frame(BOARD, SCREEN);
        near(after.cell_px, 898.0 / 10.44 * 1.5);
        near(after.point(at).x, before.x);
        let back = camera.zoom(0.1, at, BOARD, SCREEN);
        assert!(back.is_fit());
        assert_eq!(back.frame(BOARD, SCREEN), fit());
    }

    #[test]
    fn cells_grow_to_their_largest_only() {
        let camera = Camera::default().zoom(100.0, (0.0, 0.0), BOARD, SCREEN);
        near(camera.frame(BOARD, SCREEN).cell_px, 148.0);
        assert!(camera.is_nearest(BOARD, SCREEN));
    }

    #[test]
    fn nothing_is_dragged_beyond_the_edge() {
        let near_by = Camera::default().zoom(1.6, (449.0, 220.0), BOARD, SCREEN);
        let left = near_by.pan((9999.0, 0.0), BOARD, SCREEN);
        near(left.frame(BOARD, SCREEN).x, -34.0);
        let back = left.pan((-10.0, 0.0), BOARD, SCREEN);
        let moved = back.frame(BOARD, SCREEN);
        near(moved.x, -34.0 + moved.units(10.0));
        assert_eq!(
            Camera::default()
                .pan((50.0, 50.0), BOARD, SCREEN)
                .frame(BOARD, SCREEN),
            fit()
        );
    }

    #[test]
    fn a_cell_out_of_sight_is_shown() {
        let camera = Camera::default().zoom(1.7, (0.0, 220.0), BOARD, SCREEN);
        let shown = camera.show(Cell::new(9, 2), BOARD, SCREEN);
        let frame = shown.frame(BOARD, SCREEN);
        near(frame.x + frame.width, 1000.0);
        assert_eq!(
            shown
                .show(Cell::new(8, 1), BOARD, SCREEN)
                .frame(BOARD, SCREEN),
            frame
        );
    }

    #[test]
    fn a_point_is_in_the_middle_as_far_as_the_map_goes() {
        let near_by = Camera::default().zoom(1.7, (0.0, 220.0), BOARD, SCREEN);
        let middle = |x| {
            let camera = near_by.centred(Point { x, y: 1.0 }, BOARD, SCREEN);
            let frame = camera.frame(BOARD, SCREEN);
            frame.x + frame.width / 2.0
        };
        near(middle(4.25), 475.0);
        near(
            middle(9.0),
            1010.0 - near_by.frame(BOARD, SCREEN).width / 2.0,
        );
        assert!(
            Camera::default()
                .centred(Point { x: 4.0, y: 1.0 }, BOARD, SCREEN)
                .is_fit()
        );
    }

    #[test]
    fn the_cells_in_sight() {
        assert_eq!(fit().cells(BOARD), ((0, 9), (0, 2)));
        let camera = Camera::default().zoom(1.7, (0.0, 220.0), BOARD, SCREEN);
        assert_eq!(camera.frame(BOARD, SCREEN).cells(BOARD).0, (0, 5));
    }
}
