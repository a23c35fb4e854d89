//! What follows a pointer that is not down: the frame of the brush, the goal of an
//! agent that is placed.

use giveway_page::{Action, BoardAction};
use web_sys::{Element, PointerEvent};

use super::place::Px;
use super::{Hand, Surface};

impl Surface {
    /// A frame around the cell that a brush would paint.
    pub(super) fn show_hover(&self, at: Px, event: &PointerEvent) {
        let cell = self.cell(self.frame.point(at));
        let is_seen = self.paints() && event.pointer_type() != "touch";
        let (Some(cell), true) = (cell, is_seen) else {
            self.hide_hover();
            return;
        };
        self.set_hover("x", &(100 * cell.x + 3).to_string());
        self.set_hover("y", &(100 * cell.y + 3).to_string());
        self.set_hover("visibility", "visible");
    }

    pub(super) fn hide_hover(&self) {
        self.set_hover("visibility", "hidden");
    }

    /// An agent that waits for its goal looks where the pointer is.
    pub(super) fn look_for_goal(&self, hand: &Hand, at: Px) {
        if self.state.placing().is_none() || !hand.fingers.is_empty() {
            return;
        }
        let cell = self.cell(self.frame.point(at));
        if let Some(cell) = cell.filter(|&cell| cell != self.state.view.cursor) {
            self.send.emit(Action::Board(BoardAction::MoveCursor(cell)));
        }
    }

    fn set_hover(&self, name: &str, value: &str) {
        if let Some(hover) = self.hover.cast::<Element>() {
            // The names are valid, so that it cannot fail.
            let _ = hover.set_attribute(name, value);
        }
    }
}
