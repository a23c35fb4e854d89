//! An area that is drawn or moved to the edge of the board moves the map, where that is larger.

use giveway_page::{Action, BoardAction};
use gloo::timers::callback::Interval;

use super::place::Px;
use super::{Act, Hand, Surface};
use crate::board::viewport::Look;

/// How near the edge is, in pixels, how far the map goes at once, and how often, in milliseconds.
const NEAR_PX: f64 = 24.0;
const STEP_PX: f64 = 12.0;
const EVERY_MS: u32 = 30;

/// The map moves by so many pixels, again and again.
pub(super) struct Scroll {
    by: Px,
    /// Ends with it.
    _ticks: Interval,
}

impl Surface {
    /// The map begins or ends to move as the pointer of an area comes to a pixel.
    pub(super) fn scroll(&self, hand: &mut Hand, at: Px) {
        hand.at = at;
        let px = self.frame.cell_px / 100.0;
        let side = |at: f64, units: f64| {
            if at < NEAR_PX {
                STEP_PX
            } else if at > units * px - NEAR_PX {
                -STEP_PX
            } else {
                0.0
            }
        };
        let by = (side(at.0, self.frame.width), side(at.1, self.frame.height));
        let is_still = self.is_fit || by == (0.0, 0.0) || !self.state.has_area();
        if is_still {
            hand.scroll = None;
        } else if hand.scroll.as_ref().is_none_or(|scroll| scroll.by != by) {
            let look = self.look.clone();
            hand.scroll = Some(Scroll {
                by,
                _ticks: Interval::new(EVERY_MS, move || look.emit(Look::Pan(by))),
            });
        }
    }

    /// The area goes on to the cell that has come below the pointer.
    pub(super) fn follow_scroll(&self, hand: &mut Hand) {
        let (Act::Paint(last), true) = (hand.act, hand.scroll.is_some()) else {
            hand.scroll = None;
            return;
        };
        let cell = self.nearest_cell(self.frame.point(hand.at));
        if cell != last {
            self.send.emit(Action::Board(BoardAction::Drag(vec![cell])));
            hand.act = Act::Paint(cell);
        }
    }
}
