//! The card and the ring go with the thing that they are about, frame by frame: the page
//! may scroll, zoom, or lay itself out anew.

use std::cell::Cell;
use std::rc::Rc;

use giveway_course::tour::Target;
use gloo::render::{AnimationFrame, request_animation_frame};
use web_sys::{DomRect, Element, HtmlElement, ScrollIntoViewOptions, ScrollLogicalPosition};
use yew::prelude::*;

use super::target::find;
use crate::held::Held;

/// How far the card stays from the edge of the window, and from the thing, in pixels.
const MARGIN: f64 = 16.0;
const GAP: f64 = 20.0;
/// How far the tip is from the left end of the card, where there is room.
const TIP: f64 = 44.0;
/// The least room between the tip and the ends of the card.
const END: f64 = 22.0;
/// How far the ring is around the thing.
const AROUND: f64 = 5.0;

/// The card and the ring, as long as they follow.
pub(super) struct Follow(Rc<Inner>);

struct Inner {
    card: NodeRef,
    ring: NodeRef,
    target: Target,
    frame: Held<Option<AnimationFrame>>,
    /// Whether the thing was brought into sight.
    is_sought: Cell<bool>,
}

impl Follow {
    /// Begins to follow a thing, which is brought into sight first.
    pub(super) fn begin(card: NodeRef, ring: NodeRef, target: Target) -> Self {
        let inner = Rc::new(Inner {
            card,
            ring,
            target,
            frame: Held::default(),
            is_sought: Cell::new(false),
        });
        inner.put();
        Inner::next(&inner);
        Self(inner)
    }

    /// Follows no longer.
    pub(super) fn end(self) {
        self.0.frame.set(None);
    }
}

impl Inner {
    fn next(this: &Rc<Self>) {
        let inner = Rc::clone(this);
        let frame = request_animation_frame(move |_| {
            inner.put();
            Self::next(&inner);
        });
        this.frame.set(Some(frame));
    }

    fn put(&self) {
        let (Some(card), Some(ring)) = (
            self.card.cast::<HtmlElement>(),
            self.ring.cast::<HtmlElement>(),
        ) else {
            return;
        };
        let Some((element, area)) = find(self.target) else {
            ring.set_hidden(true);
            point(&card, None);
            return;
        };
        if !self.is_sought.replace(true) {
            let options = ScrollIntoViewOptions::new();
            options.set_block(ScrollLogicalPosition::Nearest);
            element.scroll_into_view_with_scroll_into_view_options(&options);
        }
        let is_cell = matches!(self.target, Target::Cell(_));
        surround(&ring, &area, is_cell);
        point(&card, Some(&area));
    }
}

/// Puts the ring around the thing.
fn surround(ring: &HtmlElement, area: &DomRect, is_cell: bool) {
    let around = if is_cell { 0.0 } else { AROUND };
    ring.set_hidden(false);
    // It fails for a name that is none.
    let _ = ring.toggle_attribute_with_force("data-round", is_cell);
    set(
        ring,
        &[
            ("left", area.left() - around),
            ("top", area.top() - around),
            ("width", area.width() + 2.0 * around),
            ("height", area.height() + 2.0 * around),
        ],
    );
}

/// Puts the card below the thing, or above it where there is no room; always within the
/// window. On a phone it lies as low as it can, so that the board and the answer that is
/// read stay in sight. Without a thing it stays where it is.
fn point(card: &HtmlElement, area: Option<&DomRect>) {
    let tip = card.query_selector(".tip").ok().flatten();
    let tip = tip.as_ref().and_then(as_html);
    let Some(area) = area else {
        if let Some(tip) = tip {
            tip.set_hidden(true);
        }
        return;
    };
    let own = card.get_bounding_client_rect();
    let (width, height) = window();
    let middle = area.left() + area.width() / 2.0;
    let left = (middle - TIP).min(width - own.width() - MARGIN).max(MARGIN);
    let below = area.bottom() + GAP;
    let is_below = below + own.height() <= height - MARGIN / 2.0;
    let beside = if is_below {
        below
    } else {
        area.top() - GAP - own.height()
    };
    let lowest = height - own.height() - MARGIN;
    let is_phone = width < height && own.width() > width / 2.0;
    let wanted = if is_below && is_phone { lowest } else { beside };
    let top = wanted.min(lowest).max(MARGIN / 2.0);
    // Elsewhere the tip would point at something else.
    let is_beside = (top - beside).abs() < 1.0;
    if let Some(tip) = tip {
        tip.set_hidden(!is_beside);
    }
    let _ = card.toggle_attribute_with_force("data-below", is_below);
    let x = (middle - left).min(own.width() - END).max(END);
    set(card, &[("left", left), ("top", top), ("--x", x)]);
}

fn as_html(element: &Element) -> Option<&HtmlElement> {
    wasm_bindgen::JsCast::dyn_ref(element)
}

/// Sets lengths in pixels.
fn set(element: &HtmlElement, lengths: &[(&str, f64)]) {
    let style = element.style();
    for (name, value) in lengths {
        // It fails for a name that is none.
        let _ = style.set_property(name, &format!("{value:.1}px"));
    }
}

/// How wide and high the window is.
fn window() -> (f64, f64) {
    let window = gloo::utils::window();
    let length = |length: Result<wasm_bindgen::JsValue, _>| {
        length
            .ok()
            .and_then(|length| length.as_f64())
            .unwrap_or_default()
    };
    (length(window.inner_width()), length(window.inner_height()))
}
