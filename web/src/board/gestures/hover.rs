//! What follows a pointer that is not down: the frame of the brush, the goal of an
//! agent that is placed.

use std::rc::Rc;

use giveway_page::rules::RuleAction;
use giveway_page::{Action, BoardAction};
use gloo::timers::callback::Timeout;
use web_sys::{Element, PointerEvent};

use super::place::Px;
use super::{Hand, Surface};
use crate::board::pointer::At;
use crate::board::tip::has_tips;

/// How long a finger rests before the cell below it is told of, in milliseconds.
const REST_MS: u32 = 500;

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

    /// The zone is lit whose tab is under a pointer that selects.
    pub(super) fn look_at_tab(&self, hand: &mut Hand, at: Px, event: &PointerEvent, time: f64) {
        let is_idle = hand.fingers.is_empty() && event.pointer_type() != "touch";
        if is_idle {
            let tab = (!self.paints()).then(|| self.zone_at(at, time));
            self.light_tab(hand, tab.flatten());
        }
    }

    /// Lights the zone of another tab than before, or of none.
    pub(super) fn light_tab(&self, hand: &mut Hand, tab: Option<String>) {
        if hand.tab == tab {
            return;
        }
        let over = |zone: &String, is_over| {
            let action = RuleAction::OverZone(zone.clone(), is_over);
            self.send.emit(Action::Rules(action));
        };
        if let Some(before) = &hand.tab {
            over(before, false);
        }
        if let Some(now) = &tab {
            over(now, true);
        }
        hand.tab = tab;
    }

    /// What is under a pointer that rests on the board, for those who tell of it.
    pub(super) fn point(&self, hand: &Hand, at: Px, event: &PointerEvent, time: f64) {
        if event.pointer_type() != "touch" {
            let is_up = hand.fingers.is_empty();
            self.pointer
                .set(is_up.then(|| self.under(at, time)).flatten());
        }
    }

    /// What is at a pixel; `None` off the map.
    fn under(&self, at: Px, time: f64) -> Option<At> {
        let cell = self.cell(self.frame.point(at))?;
        let agent = self.agent_at(at, time);
        Some(At { cell, agent })
    }

    /// Tells of the cell under a finger that rests for a while.
    pub(super) fn rest(&self, hand: &mut Hand, at: Px, time: f64) {
        self.pointer.rests.set(false);
        let pointer = Rc::clone(&self.pointer);
        let under = self
            .under(at, time)
            .filter(|_| hand.is_touch && has_tips(&self.state));
        hand.resting = under.map(|under| {
            Timeout::new(REST_MS, move || {
                pointer.rests.set(true);
                pointer.set(Some(under));
            })
        });
    }

    fn set_hover(&self, name: &str, value: &str) {
        if let Some(hover) = self.hover.cast::<Element>() {
            // The names are valid, so that it cannot fail.
            let _ = hover.set_attribute(name, value);
        }
    }
}
