//! The keys of a lesson: a figure picks the answer that has it; before a room, those of
//! a clicker go through its steps.

use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use web_sys::{HtmlElement, KeyboardEvent};

use crate::keys::{FIELDS, dialog_is_open, is_in};

/// Listens before the page's own keys do.
pub(super) fn listen() -> EventListener {
    let document = gloo::utils::document();
    let options = EventListenerOptions::enable_prevent_default();
    EventListener::new_with_options(&document, "keydown", options, |event| {
        let Some(event) = event.dyn_ref::<KeyboardEvent>() else {
            return;
        };
        let is_plain = !event.ctrl_key() && !event.meta_key() && !event.alt_key();
        if !is_plain || event.default_prevented() || dialog_is_open() || is_in(event, FIELDS) {
            return;
        }
        let key = event.key();
        if let Some(pressed) = answer(&key).or_else(|| turn(&key)) {
            event.prevent_default();
            pressed.click();
        }
    })
}

/// What a clicker presses while the lesson is shown to a room.
fn turn(key: &str) -> Option<HtmlElement> {
    if !matches!(key, "PageUp" | "PageDown") {
        return None;
    }
    let document = gloo::utils::document();
    let found = document.query_selector(&format!("[data-presents] [data-turn='{key}']"));
    found.ok().flatten()?.dyn_into().ok()
}

/// The answer that a key picks.
fn answer(key: &str) -> Option<HtmlElement> {
    let figure: u8 = key.parse().ok()?;
    let place = super::place()?;
    let room = format!("[data-presents] [data-room-key='{figure}']:not(:disabled)");
    if let Some(found) = gloo::utils::document().query_selector(&room).ok().flatten() {
        return found.dyn_into().ok();
    }
    // Where a search by hand has its place, figures are for that.
    if place.closest(".covers-lesson").ok().flatten().is_some() {
        return None;
    }
    let found = place.query_selector(&format!("[data-key='{figure}']"));
    found.ok().flatten()?.dyn_into().ok()
}
