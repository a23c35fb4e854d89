//! From a pixel of the board to what is there.

use giveway_model::Cell;
use giveway_page::Point;
use web_sys::Element;

use super::Surface;

/// A place on the board, in pixels from its upper left.
pub(super) type Px = (f64, f64);

impl Surface {
    pub(super) fn agent_at(&self, at: Px, time: f64) -> Option<usize> {
        self.cast.agent_at(self.frame.point(at), time)
    }

    /// The cell at a point; `None` off the map.
    pub(super) fn cell(&self, point: Point) -> Option<Cell> {
        let grid = self.state.document.draft.grid();
        let is_on = |at: f64, side: u32| at >= -0.5 && at < f64::from(side) - 0.5;
        let is_on = is_on(point.x, grid.width()) && is_on(point.y, grid.height());
        is_on.then(|| self.nearest_cell(point))
    }

    pub(super) fn nearest_cell(&self, point: Point) -> Cell {
        self.state.document.draft.clamp(point.nearest_cell())
    }

    /// Where an event is, from the upper left of the board.
    pub(super) fn px(&self, event: &web_sys::MouseEvent) -> Px {
        let rect = self.svg.cast::<Element>();
        let corner = rect.map_or((0.0, 0.0), |svg| {
            let rect = svg.get_bounding_client_rect();
            (rect.left(), rect.top())
        });
        (
            f64::from(event.client_x()) - corner.0,
            f64::from(event.client_y()) - corner.1,
        )
    }
}

pub(super) fn distance(a: Px, b: Px) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}
