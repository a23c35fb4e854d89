//! Pointers on the board: to paint, to select, to move the map, to pinch it.

mod act;
mod edge;
mod framing;
mod hover;
mod look;
mod place;
mod pointer;

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::Action;
use giveway_page::board::{Cast, Frame};
use gloo::timers::callback::Timeout;
use web_sys::{PointerEvent, WheelEvent};
use yew::prelude::*;

use super::pointer::Pointer;
use super::viewport::Look;
use crate::held::use_held;
use crate::{Clock, Shown};
use place::Px;

/// What the pointers act on.
pub(super) struct Surface {
    pub(super) svg: NodeRef,
    pub(super) hover: NodeRef,
    pub(super) state: Shown,
    pub(super) send: Callback<Action>,
    pub(super) cast: Rc<Cast>,
    pub(super) look: Callback<Look>,
    pub(super) pointer: Rc<Pointer>,
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
    /// A browser sends it after a tap, too.
    pub(super) mouse_down: Callback<MouseEvent>,
    pub(super) menu: Callback<MouseEvent>,
}

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
    /// Whether a finger came down last.
    is_touch: bool,
    /// Ends when the finger has rested for a while, and then tells of the cell below it.
    resting: Option<Timeout>,
    /// The zone whose tab is under the pointer.
    tab: Option<String>,
    /// What a finger that stays comes to.
    hold: Option<Timeout>,
    /// Where the pointer of an area came to last.
    at: Px,
    /// Moves the map while that is at the edge of the board.
    scroll: Option<edge::Scroll>,
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
    {
        // The map has moved below a pointer that rests.
        let (hand, surface) = (Rc::clone(&hand), Rc::clone(&surface));
        let Frame { x, y, .. } = surface.0.frame;
        use_effect_with((x.to_bits(), y.to_bits()), move |_| {
            let mut now = hand.take();
            surface.0.follow_scroll(&mut now);
            hand.set(now);
        });
    }
    let wheel = {
        let surface = Rc::clone(&surface);
        Callback::from(move |event: WheelEvent| surface.0.wheel(&event))
    };
    let mouse_down = {
        let hand = Rc::clone(&hand);
        Callback::from(move |event: MouseEvent| {
            let now = hand.take();
            // The board has had the focus since the finger came down; what the tap did may have
            // moved it on.
            if now.is_touch {
                event.prevent_default();
            }
            hand.set(now);
        })
    };
    let menu = {
        let surface = Rc::clone(&surface);
        Callback::from(move |event: MouseEvent| surface.0.menu(&event))
    };
    Gestures {
        mouse_down,
        menu,
        down: listen(Surface::down),
        moved: listen(Surface::moved),
        up: listen(Surface::up),
        cancel: listen(|surface, hand, event, _| surface.cancel(hand, event)),
        leave: listen(|surface, hand, event, _| {
            surface.hide_hover();
            surface.light_tab(hand, None);
            // A finger that told of a cell may go.
            if event.pointer_type() != "touch" {
                surface.pointer.set(None);
            }
        }),
        wheel,
    }
}
