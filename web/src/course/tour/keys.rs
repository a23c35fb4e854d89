//! The keyboard in the tour: Escape, and where the focus goes.

use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, HtmlElement, KeyboardEvent};
use yew::prelude::*;

use crate::keys::dialog_is_open;

/// The board, which takes the focus where nothing else can.
const BOARD: &str = "svg[role=grid]";

/// Where the focus was.
pub(super) struct Back(Option<Element>);

/// Brings the focus to the card.
pub(super) fn enter(card: &NodeRef) -> Back {
    let was = focused();
    if let Some(card) = card.cast::<Element>() {
        focus(card);
    }
    Back(was)
}

impl Back {
    /// Brings the focus back, where it is on the card, or was before that went.
    pub(super) fn give(self, card: &NodeRef) {
        let is_on = |it: &Element| {
            card.get()
                .is_some_and(|card| card.contains(Some(it.as_ref())))
        };
        if focused().is_some_and(|it| !is_on(&it)) {
            return;
        }
        let was = self.0.filter(|was| was.is_connected());
        let board = || gloo::utils::document().query_selector(BOARD).ok().flatten();
        if let Some(element) = was.or_else(board) {
            focus(element);
        }
    }
}

/// What has the focus, if anything on the page has.
fn focused() -> Option<Element> {
    let document = gloo::utils::document();
    let focused = document.active_element();
    let body = document.body().map(Element::from);
    focused.filter(|it| Some(it) != body.as_ref())
}

fn focus(element: Element) {
    // The board, which is SVG, has the method, too.
    let _ = element.unchecked_into::<HtmlElement>().focus();
}

/// Calls back on Escape, before the page's own keys hear of it.
pub(super) fn listen(end: impl Fn() + 'static) -> EventListener {
    let document = gloo::utils::document();
    let options = EventListenerOptions::enable_prevent_default();
    EventListener::new_with_options(&document, "keydown", options, move |event| {
        let Some(event) = event.dyn_ref::<KeyboardEvent>() else {
            return;
        };
        let is_taken = event.default_prevented() || event.is_composing() || dialog_is_open();
        if event.key() == "Escape" && !is_taken {
            event.prevent_default();
            end();
        }
    })
}
