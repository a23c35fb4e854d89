//! Pointers come down, move and go up: what they do by then is decided here.

use giveway_page::{Action, BoardAction};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, HtmlInputElement, PointerEvent, SvgElement};

use super::place::distance;
use super::{Act, Hand, Surface};
use crate::board::area::side;
use crate::board::viewport::Look;

/// How far a pointer goes before that is a drag, in pixels.
const SLOP_PX: f64 = 5.0;

impl Surface {
    pub(super) fn down(&self, hand: &mut Hand, event: &PointerEvent, time: f64) {
        finish_typing();
        let at = self.px(event);
        self.pointer.set(None);
        if let Some(svg) = self.svg.cast::<Element>() {
            // Without capture a drag ends at the edge of the board.
            let _ = svg.set_pointer_capture(event.pointer_id());
        }
        hand.is_touch = event.pointer_type() == "touch";
        if hand.is_touch
            && let Some(svg) = self.svg.cast::<SvgElement>()
        {
            let _ = svg.focus();
        }
        hand.fingers.push((event.pointer_id(), at));
        if hand.fingers.len() > 1 {
            if let Act::Paint(_) = hand.act {
                self.send.emit(Action::Board(BoardAction::Release));
            }
            hand.act = Act::Pinch;
            (hand.resting, hand.hold) = (None, None);
            self.hide_hover();
            return;
        }
        hand.hold = None;
        if let Some(stretch) = side(event).filter(|_| event.button() == 0) {
            self.send.emit(Action::Area(stretch));
            hand.act = Act::Paint(self.nearest_cell(self.frame.point(at)));
            return;
        }
        if hand.is_touch {
            hand.hold = self.long_press(at);
        }
        hand.act = match event.button() {
            0 if self.paints() && event.pointer_type() != "touch" => self.begin_stroke(at, event),
            0 => Act::Pressed(at),
            1 => {
                event.prevent_default();
                Act::Pan(at)
            }
            _ => Act::Spent,
        };
        self.rest(hand, at, time);
    }

    pub(super) fn moved(&self, hand: &mut Hand, event: &PointerEvent, time: f64) {
        let at = self.px(event);
        self.show_hover(at, event);
        self.point(hand, at, event, time);
        self.look_at_tab(hand, at, event, time);
        self.look_for_goal(hand, at);
        let finger = hand.fingers.iter().position(|f| f.0 == event.pointer_id());
        let Some(finger) = finger else { return };
        let before = std::mem::replace(&mut hand.fingers[finger].1, at);
        if let Act::Pressed(from) = hand.act {
            if distance(from, at) < SLOP_PX {
                return;
            }
            hand.resting = None;
            hand.hold = None;
            hand.act = if let Some(area) = self.framing(from, event, time) {
                let cell = self.nearest_cell(self.frame.point(from));
                self.send.emit(Action::Area(area));
                Act::Paint(cell)
            } else if self.paints() {
                self.begin_stroke(from, event)
            } else if self.holds(from, event) {
                // Selecting it takes most of a frame, so the next event moves it.
                hand.act = self.begin_stroke(from, event);
                return;
            } else if self.agent_at(from, time).is_none() && !self.is_fit {
                Act::Pan(from)
            } else {
                // Too far for a click, and nothing to move.
                Act::Spent
            };
        }
        match hand.act {
            Act::Pan(last) => {
                self.look.emit(Look::Pan((at.0 - last.0, at.1 - last.1)));
                hand.act = Act::Pan(at);
            }
            Act::Paint(last) => {
                hand.act = Act::Paint(self.stroke(last, event));
                self.scroll(hand, at);
            }
            Act::Pinch => self.pinch(hand, finger, before, at),
            Act::Nothing | Act::Pressed(_) | Act::Spent => {}
        }
    }

    pub(super) fn up(&self, hand: &mut Hand, event: &PointerEvent, time: f64) {
        hand.fingers.retain(|f| f.0 != event.pointer_id());
        hand.resting = None;
        hand.hold = None;
        hand.scroll = None;
        let act = std::mem::take(&mut hand.act);
        match act {
            // The finger has been told of the cell.
            Act::Pressed(_) if self.pointer.rests.take() => {}
            Act::Paint(last) => {
                self.stroke(last, event);
                self.send.emit(Action::Board(BoardAction::Release));
            }
            Act::Pressed(at) if self.paints() => {
                if let Act::Paint(_) = self.begin_stroke(at, event) {
                    self.send.emit(Action::Board(BoardAction::Release));
                }
            }
            // A long press has framed its cell.
            Act::Pressed(at) if self.has_framed(at, event) => {}
            Act::Pressed(at) if self.select_line(at, event) => {}
            Act::Pressed(at) => self.select(at, time),
            _ => {}
        }
        if !hand.fingers.is_empty() {
            hand.act = Act::Spent;
        }
    }

    pub(super) fn cancel(&self, hand: &mut Hand, event: &PointerEvent) {
        hand.fingers.retain(|f| f.0 != event.pointer_id());
        hand.resting = None;
        hand.hold = None;
        hand.scroll = None;
        if let Act::Paint(_) = std::mem::replace(&mut hand.act, Act::Spent) {
            self.send.emit(Action::Board(BoardAction::Release));
        }
    }
}

/// What was typed in a field counts from here on: it would else be heard after the stroke began.
fn finish_typing() {
    let active = gloo::utils::document().active_element();
    let field = active.and_then(|active| active.dyn_into::<HtmlInputElement>().ok());
    if let Some(field) = field {
        let _ = field.blur();
    }
}
