//! The sheet that a picture is drawn on: the map, room around it, a strip for the time.

use giveway_model::Grid;

use crate::CELL;

/// The room around the map, in pixels.
const MARGIN: u32 = 12;
/// The strip below the map, in pixels.
const STRIP: u32 = 24;

/// The sizes of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sheet {
    /// Width and height, in pixels.
    pub(crate) size: (u32, u32),
    /// A pixel, in units.
    pub(crate) px: f64,
    /// The map, in units.
    pub(crate) map: (f64, f64),
}

impl Sheet {
    /// The sheet for a map with cells of so many pixels.
    pub(crate) fn new(grid: &Grid, cell: u32) -> Self {
        let side = |cells: u32| cells.saturating_mul(cell).saturating_add(2 * MARGIN);
        let units = |cells: u32| CELL * f64::from(cells);
        Self {
            size: (
                side(grid.width()),
                side(grid.height()).saturating_add(STRIP),
            ),
            px: CELL / f64::from(cell.max(1)),
            map: (units(grid.width()), units(grid.height())),
        }
    }

    /// The first corner, width and height, in units.
    pub(crate) fn view_box(&self) -> [f64; 4] {
        let margin = -f64::from(MARGIN) * self.px;
        let (width, height) = self.size;
        let units = |pixels: u32| f64::from(pixels) * self.px;
        [margin, margin, units(width), units(height)]
    }

    /// The middle of the strip, in units from the top.
    pub(crate) fn strip(&self) -> f64 {
        self.map.1 + self.px * (f64::from(MARGIN) + f64::from(STRIP) / 2.0)
    }
}
