//! What a press with the tool that selects comes to on the floor itself: a part of the floor is
//! framed, or the one that is selected is moved.

use giveway_page::Action;
use giveway_page::area::{AreaAction, Frame};
use gloo::timers::callback::Timeout;
use web_sys::{MouseEvent, PointerEvent};

use super::Surface;
use super::place::Px;

/// How long a finger stays before it frames its cell, in milliseconds.
const LONG_MS: u32 = 500;

impl Surface {
    /// What a drag from a pixel does with an area; `None` where it does something else. On a map
    /// that is larger than the board a drag without Shift and Alt moves the map.
    pub(super) fn framing(&self, from: Px, event: &PointerEvent, time: f64) -> Option<AreaAction> {
        if !self.state.can_select_area() {
            return None;
        }
        let cell = self.cell(self.frame.point(from))?;
        let is_touch = event.pointer_type() == "touch";
        if is_touch && self.state.is_framed(cell) {
            // The finger that framed its cell goes on.
            return Some(AreaAction::Begin(cell, Frame::Replace));
        }
        let frame = match (event.alt_key(), event.shift_key()) {
            (true, _) => Frame::Take,
            (false, true) => Frame::Add,
            (false, false) if self.state.is_in_area(cell) => return Some(AreaAction::Grab(cell)),
            (false, false) => Frame::Replace,
        };
        let is_free = self.is_fit
            && !is_touch
            && !self.state.can_move(cell)
            && self.agent_at(from, time).is_none();
        (is_free || frame != Frame::Replace).then_some(AreaAction::Begin(cell, frame))
    }

    /// Selects the column or row whose number is at a pixel; with Shift it comes to the area, with
    /// Alt it goes from it.
    #[inline(never)]
    pub(super) fn select_line(&self, at: Px, event: &MouseEvent) -> bool {
        let grid = self.state.document.draft.grid();
        let line = self.frame.line_at(at, (grid.width(), grid.height()));
        let line = line.filter(|_| self.state.can_select_area());
        if let Some((axis, line)) = line {
            let frame = match (event.alt_key(), event.shift_key()) {
                (true, _) => Frame::Take,
                (false, true) => Frame::Add,
                (false, false) => Frame::Replace,
            };
            let select = AreaAction::Line(axis, line, frame);
            self.send.emit(Action::Area(select));
        }
        line.is_some()
    }

    /// The other button on a number selects its column or row, too: the bar beside it is the menu.
    pub(super) fn menu(&self, event: &MouseEvent) {
        if self.select_line(self.px(event), event) {
            event.prevent_default();
        }
    }

    /// A finger that stays frames its cell: then handles stretch it.
    pub(super) fn long_press(&self, at: Px) -> Option<Timeout> {
        let cell = self.cell(self.frame.point(at))?;
        let can = self.state.can_select_area() && !self.state.is_in_area(cell);
        let send = self.send.clone();
        can.then(|| {
            Timeout::new(LONG_MS, move || {
                let begin = AreaAction::Begin(cell, Frame::Replace);
                send.emit(Action::Area(begin));
                send.emit(Action::Board(giveway_page::BoardAction::Release));
            })
        })
    }

    /// Whether a finger that is lifted has framed its cell.
    pub(super) fn has_framed(&self, at: Px, event: &PointerEvent) -> bool {
        let cell = self.cell(self.frame.point(at));
        event.pointer_type() == "touch" && cell.is_some_and(|cell| self.state.is_framed(cell))
    }
}
