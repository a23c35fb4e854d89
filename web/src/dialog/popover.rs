//! Menus and cards that hang on a button: closed by a press elsewhere, by
//! Escape, and when the focus leaves.

use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, Event, HtmlElement, KeyboardEvent, Node};
use yew::prelude::*;

/// Calls back when what is open inside an element should close. The button that
/// opened it is inside, too; it gets the focus back after Escape.
#[hook]
pub(crate) fn use_dismiss(around: &NodeRef, open: bool, close: &Callback<()>) {
    let (around, close) = (around.clone(), close.clone());
    use_effect_with(open, move |&open| {
        let listening = open.then(|| listen(&around, &close));
        move || drop(listening)
    });
}

fn listen(around: &NodeRef, close: &Callback<()>) -> [EventListener; 3] {
    let document = gloo::utils::document();
    let leaving = |kind| {
        let (around, close) = (around.clone(), close.clone());
        let options = EventListenerOptions::run_in_capture_phase();
        EventListener::new_with_options(&document, kind, options, move |event| {
            if !is_inside(&around, event) && !is_in_dialog(event) {
                close.emit(());
            }
        })
    };
    let escape = {
        let (around, close) = (around.clone(), close.clone());
        let mut options = EventListenerOptions::run_in_capture_phase();
        options.passive = false;
        EventListener::new_with_options(&document, "keydown", options, move |event| {
            let key = event.dyn_ref().map(KeyboardEvent::key);
            if key.as_deref() == Some("Escape") {
                event.prevent_default();
                event.stop_propagation();
                close.emit(());
                focus_opener(&around);
            }
        })
    };
    [leaving("pointerdown"), leaving("focusin"), escape]
}

fn is_inside(around: &NodeRef, event: &Event) -> bool {
    let target = event.target().and_then(|t| t.dyn_into::<Node>().ok());
    around
        .get()
        .is_some_and(|node| node.contains(target.as_ref()))
}

/// A dialog that is opened from a menu takes its place, and the focus, before
/// the menu is gone.
fn is_in_dialog(event: &Event) -> bool {
    let target = event.target().and_then(|t| t.dyn_into::<Element>().ok());
    let dialog = target.map(|target| target.closest("dialog"));
    dialog.is_some_and(|dialog| dialog.is_ok_and(|dialog| dialog.is_some()))
}

fn focus_opener(around: &NodeRef) {
    let opener = around.cast::<Element>().and_then(|element| {
        element
            .query_selector("[aria-expanded=true]")
            .ok()
            .flatten()
    });
    if let Some(opener) = opener.and_then(|opener| opener.dyn_into::<HtmlElement>().ok()) {
        // An element that cannot take the focus leaves it where it is.
        let _ = opener.focus();
    }
}
