//! Pointers on the board: to paint, to select, to move the map, to pinch it.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::board::{Cast, Frame};
use giveway_page::steering::Lead;
use giveway_page::{Action, BoardAction, Point, Selection, Tool};
use web_sys::{Element, PointerEvent, WheelEvent};
use yew::prelude::*;

use super::coalesced::places;
use super::viewport::Look;
use crate::held::use_held;
use crate::{Clock, Shown};

/// How far a pointer goes before that is a drag, in pixels.
const SLOP_PX: f64 = 5.0;
/// How much a pixel of a wheel enlarges, and one of a pinch on a touchpad.
const WHEEL: f64 = 0.0015;
const PINCH: f64 = 0.01;
/// A line of a wheel that counts in lines, in pixels.
const LINE_PX: f64 = 33.0;

/// What the pointers act on.
pub(super) struct Surface {
    pub(super) svg: NodeRef,
    pub(super) hover: NodeRef,
    pub(super) state: Shown,
    pub(super) send: Callback<Action>,
    pub(super) cast: Rc<Cast>,
    pub(super) look: Callback<Look>,
    pub(super) frame: Frame,
    pub(super) is_fit: bool,
}

/// What the board listens with.
pub(super) struct Gestures {
    pub(super) down: Callback<PointerEvent>,
    pub(super) moved: Callback<PointerEvent>,
    pub(super) up: Callback<PointerEvent>,
    pub(super) cancel: Callback<PointerEvent>,
    pub(super) leave: Callback<PointerEvent>,
    pub(super) wheel: Callback<WheelEvent>,
}

type Px = (f64, f64);

/// What the pointers are doing.
#[derive(Clone, Copy, Default)]
enum Act {
    #[default]
    Nothing,
    /// Pressed, and not yet moved: it may become anything.
    Pressed(Px),
    /// Moves the map.
    Pan(Px),
    /// Paints; the cell that it came to last.
    Paint(Cell),
    /// Two fingers.
    Pinch,
    /// What is left of a gesture that is over.
    Spent,
}

/// The pointers that are down, and what they do.
#[derive(Default)]
struct Hand {
    fingers: Vec<(i32, Px)>,
    act: Act,
}

/// The gestures on a surface.
#[hook]
pub(super) fn use_gestures(surface: Surface) -> Gestures {
    let hand = use_held(Hand::default);
    let clock = use_context::<Clock>();
    let surface = Rc::new((surface, clock));
    let listen = |act: fn(&Surface, &mut Hand, &PointerEvent, f64)| {
        let (hand, surface) = (Rc::clone(&hand), Rc::clone(&surface));
        Callback::from(move |event: PointerEvent| {
            let time = surface.1.as_ref().map_or(0.0, Clock::now);
            // Where the browser ends this with an exception, the hand is empty.
            let mut now = hand.take();
            act(&surface.0, &mut now, &event, time);
            hand.set(now);
        })
    };
    let wheel = {
        let surface = Rc::clone(&surface);
        Callback::from(move |event: WheelEvent| surface.0.wheel(&event))
    };
    Gestures {
        down: listen(|surface, hand, event, _| surface.down(hand, event)),
        moved: listen(Surface::moved),
        up: listen(Surface::up),
        cancel: listen(|surface, hand, event, _| surface.cancel(hand, event)),
        leave: listen(|surface, _, _, _| surface.hide_hover()),
        wheel,
    }
}

impl Surface {
    fn down(&self, hand: &mut Hand, event: &PointerEvent) {
        let at = self.px(event);
        if let Some(svg) = self.svg.cast::<Element>() {
            // Without capture a drag ends at the edge of the board.
            let _ = svg.set_pointer_capture(event.pointer_id());
        }
        hand.fingers.push((event.pointer_id(), at));
        if hand.fingers.len() > 1 {
            if let Act::Paint(_) = hand.act {
                self.send.emit(Action::Board(BoardAction::Release));
            }
            hand.act = Act::Pinch;
            self.hide_hover();
            return;
        }
        hand.act = match event.button() {
            0 if self.paints() && event.pointer_type() != "touch" => self.begin_stroke(at),
            0 => Act::Pressed(at),
            1 => {
                event.prevent_default();
                Act::Pan(at)
            }
            _ => Act::Spent,
        };
    }

    fn moved(&self, hand: &mut Hand, event: &PointerEvent, time: f64) {
        let at = self.px(event);
        self.show_hover(at, event);
        self.look_for_goal(hand, at);
        let finger = hand.fingers.iter().position(|f| f.0 == event.pointer_id());
        let Some(finger) = finger else { return };
        let before = std::mem::replace(&mut hand.fingers[finger].1, at);
        if let Act::Pressed(from) = hand.act {
            if distance(from, at) < SLOP_PX {
                return;
            }
            hand.act = if self.paints() || self.holds(from, event) {
                self.begin_stroke(from)
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
            Act::Paint(last) => hand.act = Act::Paint(self.stroke(last, event)),
            Act::Pinch => self.pinch(hand, finger, before, at),
            Act::Nothing | Act::Pressed(_) | Act::Spent => {}
        }
    }

    fn up(&self, hand: &mut Hand, event: &PointerEvent, time: f64) {
        hand.fingers.retain(|f| f.0 != event.pointer_id());
        let act = std::mem::take(&mut hand.act);
        match act {
            Act::Paint(_) => self.send.emit(Action::Board(BoardAction::Release)),
            Act::Pressed(at) if self.paints() => {
                if let Act::Paint(_) = self.begin_stroke(at) {
                    self.send.emit(Action::Board(BoardAction::Release));
                }
            }
            Act::Pressed(at) => self.select(at, time),
            _ => {}
        }
        if !hand.fingers.is_empty() {
            hand.act = Act::Spent;
        }
    }

    fn cancel(&self, hand: &mut Hand, event: &PointerEvent) {
        hand.fingers.retain(|f| f.0 != event.pointer_id());
        if let Act::Paint(_) = std::mem::replace(&mut hand.act, Act::Spent) {
            self.send.emit(Action::Board(BoardAction::Release));
        }
    }

    fn wheel(&self, event: &WheelEvent) {
        let unit = match event.delta_mode() {
            WheelEvent::DOM_DELTA_PIXEL => 1.0,
            _ => LINE_PX,
        };
        let (across, down) = (event.delta_x() * unit, event.delta_y() * unit);
        if event.shift_key() || across.abs() > down.abs() {
            if !self.is_fit {
                event.prevent_default();
                let by = if across == 0.0 {
                    (-down, 0.0)
                } else {
                    (-across, -down)
                };
                self.look.emit(Look::Pan(by));
            }
            return;
        }
        // Where there is nothing to make smaller the page may scroll.
        if down > 0.0 && self.is_fit && !event.ctrl_key() {
            return;
        }
        event.prevent_default();
        let rate = if event.ctrl_key() { PINCH } else { WHEEL };
        let at = self.px(event);
        self.look.emit(Look::Zoom((-down * rate).exp(), Some(at)));
    }

    /// Begins a stroke at a pixel, if that is on the map.
    fn begin_stroke(&self, at: Px) -> Act {
        match self.cell(self.frame.point(at)) {
            Some(cell) => {
                self.send.emit(Action::Board(BoardAction::Press(cell)));
                Act::Paint(cell)
            }
            None => Act::Spent,
        }
    }

    /// Takes a stroke on through all the places that the pointer came to since
    /// the last frame.
    fn stroke(&self, mut last: Cell, event: &PointerEvent) -> Cell {
        let mut cells = Vec::new();
        for place in places(event) {
            let cell = self.nearest_cell(self.frame.point(self.px(&place)));
            if cell != last {
                cells.push(cell);
                last = cell;
            }
        }
        if !cells.is_empty() {
            self.send.emit(Action::DragOver(cells));
        }
        last
    }

    fn pinch(&self, hand: &Hand, finger: usize, before: Px, at: Px) {
        let other = hand.fingers.iter().enumerate().find(|&(i, _)| i != finger);
        let Some((_, &(_, other))) = other else {
            return;
        };
        let half = |a: Px, b: Px| (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1));
        let (from, to) = (half(before, other), half(at, other));
        let factor = distance(at, other) / distance(before, other).max(1.0);
        self.look.emit(Look::Zoom(factor, Some(from)));
        self.look.emit(Look::Pan((to.0 - from.0, to.1 - from.1)));
    }

    fn select(&self, at: Px, time: f64) {
        let cell = self.cell(self.frame.point(at));
        if self.state.document.mode.steering().is_some() {
            if let Some(cell) = cell {
                self.send.emit(Action::Steer(Lead::To(cell)));
            }
            return;
        }
        if let Some(cell) = cell {
            self.send.emit(Action::Board(BoardAction::MoveCursor(cell)));
        }
        let selection = match (self.agent_at(at, time), cell) {
            (Some(agent), _) => Selection::Agent(agent),
            (None, Some(cell)) => Selection::Cell(cell),
            (None, None) => Selection::Nothing,
        };
        self.send
            .emit(Action::Board(BoardAction::Select(selection)));
    }

    /// A frame around the cell that a brush would paint.
    fn show_hover(&self, at: Px, event: &PointerEvent) {
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

    fn hide_hover(&self) {
        self.set_hover("visibility", "hidden");
    }

    fn set_hover(&self, name: &str, value: &str) {
        if let Some(hover) = self.hover.cast::<Element>() {
            // The names are valid, so that it cannot fail.
            let _ = hover.set_attribute(name, value);
        }
    }

    /// An agent that waits for its goal looks where the pointer is.
    fn look_for_goal(&self, hand: &Hand, at: Px) {
        if self.state.placing().is_none() || !hand.fingers.is_empty() {
            return;
        }
        let cell = self.cell(self.frame.point(at));
        if let Some(cell) = cell.filter(|&cell| cell != self.state.view.cursor) {
            self.send.emit(Action::Board(BoardAction::MoveCursor(cell)));
        }
    }

    /// Whether there is something at a pixel that is moved by hand. A finger
    /// moves the page, and on a map that is larger than the board the map is
    /// moved: there only what is selected is held.
    fn holds(&self, at: Px, event: &PointerEvent) -> bool {
        let Some(cell) = self.cell(self.frame.point(at)) else {
            return false;
        };
        let is_selected = match self.state.view.selection {
            Selection::Cell(selected) => selected == cell,
            Selection::Agent(agent) => self.state.agent_at(cell) == Some(agent),
            Selection::Nothing => false,
        };
        let is_loose = self.is_fit && event.pointer_type() != "touch";
        (is_loose || is_selected) && self.state.can_move(cell)
    }

    fn paints(&self) -> bool {
        self.state.view.tool != Tool::Select
    }

    fn agent_at(&self, at: Px, time: f64) -> Option<usize> {
        self.cast.agent_at(self.frame.point(at), time)
    }

    /// The cell at a point; `None` off the map.
    fn cell(&self, point: Point) -> Option<Cell> {
        let grid = self.state.document.draft.grid();
        let is_on = |at: f64, side: u32| at >= -0.5 && at < f64::from(side) - 0.5;
        let is_on = is_on(point.x, grid.width()) && is_on(point.y, grid.height());
        is_on.then(|| self.nearest_cell(point))
    }

    fn nearest_cell(&self, point: Point) -> Cell {
        self.state.document.draft.clamp(point.nearest_cell())
    }

    /// Where an event is, from the upper left of the board.
    fn px(&self, event: &web_sys::MouseEvent) -> Px {
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

fn distance(a: Px, b: Px) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}
