//! The numbers of columns and rows: where they stand, and which one is pressed.

use super::Frame;
use crate::Axis;
use crate::board::{CELL, Detail, whole};

/// How far from the middle of a number counts as on it, in pixels.
const REACH_PX: f64 = 12.0;

/// Where the numbers stand, in units of the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisPlace {
    /// The size of their letters.
    pub size: f64,
    /// The foot of the numbers of columns.
    pub top: f64,
    /// The middle of the numbers of rows.
    pub left: f64,
}

impl Frame {
    /// Where the numbers stand: beside the map, or at the edge of the screen that it reaches beyond.
    pub fn axis_place(&self) -> AxisPlace {
        let beside = if self.detail() == Detail::All {
            (-18.0, -12.0)
        } else {
            (-self.units(11.0), -self.units(6.0))
        };
        AxisPlace {
            // As large as a sixth of a cell, but always to be read and never loud.
            size: 17.0_f64.clamp(self.units(11.0), self.units(15.0)),
            top: (self.y + self.units(14.0)).max(beside.1),
            left: (self.x + self.units(13.0)).max(beside.0),
        }
    }

    /// The column or row whose number is at a pixel, on a map of some cells. Beside the map it is
    /// as wide as the column; on the map only what is written there can be pressed.
    pub fn line_at(&self, px: (f64, f64), board: (u32, u32)) -> Option<(Axis, u32)> {
        let every = self.axis()?;
        let (x, y) = (self.x + self.units(px.0), self.y + self.units(px.1));
        let place = self.axis_place();
        let is_near = |at: f64, to: f64| (at - to).abs() <= self.units(REACH_PX);
        let line = |at: f64, side: u32, is_beside: bool| {
            let is_on = at >= 0.0 && at < f64::from(side) * CELL;
            let index = is_on.then(|| whole(at / CELL))?;
            let middle = (f64::from(index) + 0.5) * CELL;
            let is_written = index.is_multiple_of(every) && is_near(at, middle);
            (is_beside || is_written).then_some(index)
        };
        if is_near(y, place.top - 0.36 * place.size)
            && let Some(column) = line(x, board.0, y < 0.0)
        {
            return Some((Axis::Columns, column));
        }
        let row = is_near(x, place.left).then(|| line(y, board.1, x < 0.0));
        Some((Axis::Rows, row.flatten()?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_pressed_where_it_stands() {
        // All of a floor of 8 by 6 cells of 50 pixels, with its numbers beside it.
        let all = Frame {
            x: -34.0,
            y: -34.0,
            width: 900.0,
            height: 700.0,
            cell_px: 50.0,
        };
        let px = |at: f64, from: f64| (at - from) * all.cell_px / CELL;
        let at = |x: f64, y: f64| all.line_at((px(x, all.x), px(y, all.y)), (8, 6));
        assert_eq!(at(350.0, -18.0), Some((Axis::Columns, 3)));
        assert_eq!(
            at(310.0, -18.0),
            Some((Axis::Columns, 3)),
            "its whole width"
        );
        assert_eq!(at(-18.0, 550.0), Some((Axis::Rows, 5)));
        assert_eq!(at(-18.0, -18.0), None, "the corner");
        assert_eq!(at(350.0, 50.0), None, "a cell");
        assert_eq!(at(850.0, -18.0), None, "right of the map");
    }

    #[test]
    fn on_the_map_only_what_is_written_is_pressed() {
        // The middle of a large floor of cells of 20 pixels: every fifth number stands at the edge.
        let near = Frame {
            x: 2000.0,
            y: 1000.0,
            width: 4000.0,
            height: 3000.0,
            cell_px: 20.0,
        };
        assert_eq!(near.axis(), Some(5));
        let at = |x: f64, y: f64| near.line_at((x, y), (200, 200));
        // Column 25 has its middle at 2550 units, 110 pixels from the left.
        assert_eq!(at(110.0, 10.0), Some((Axis::Columns, 25)));
        assert_eq!(at(130.0, 10.0), None, "26 is not written");
        assert_eq!(at(110.0, 60.0), None, "a cell");
        // Row 15 has its middle at 1550 units, 110 pixels from above.
        assert_eq!(at(13.0, 110.0), Some((Axis::Rows, 15)));
    }
}
