//! Where a person looks: the focus, and what is to be in sight.

use giveway_course::tour::Target;
use gloo::timers::callback::Timeout;
use wasm_bindgen::JsCast as _;
use web_sys::{HtmlElement, ScrollIntoViewOptions, ScrollLogicalPosition};
use yew::prelude::*;

use super::tour::find;
use super::tutor::Msg;

/// How long the page may take to lay itself out anew, in milliseconds.
const SETTLED_MS: u32 = 120;

/// Whether a press is the second of a double one, or a later one of several.
pub(super) fn is_again(event: &MouseEvent) -> bool {
    event.detail() > 1
}

/// Sends a message at a press, but not at the second of a double one, which is not meant
/// for what has come under the pointer meanwhile.
pub(super) fn once(send: &Callback<Msg>, msg: impl Fn() -> Msg + 'static) -> Callback<MouseEvent> {
    let send = send.clone();
    Callback::from(move |event: MouseEvent| {
        if !is_again(&event) {
            send.emit(msg());
        }
    })
}

/// Whether something of the course has the focus.
pub(super) fn has_focus() -> bool {
    let active = gloo::utils::document().active_element();
    let place = super::place();
    matches!((active, place), (Some(active), Some(place)) if place.contains(Some(&active)))
}

/// Whether nothing has the focus: what had it is gone.
fn is_lost() -> bool {
    let document = gloo::utils::document();
    let body = document.body().map(Into::into);
    document
        .active_element()
        .is_none_or(|active| Some(active) == body)
}

/// Where the focus goes when what had it is gone: the first of these that is there.
const INSTEAD: [&str; 5] = [
    // In the editor, the step that is shown.
    "dialog[open] .asteps .on",
    // In the contents, what undoes it, or goes on.
    "dialog[open] .gone .btn",
    "dialog[open] .sh .btn",
    // In a lesson, what else helps with the task, or goes on.
    ".lesson :is(.ex, .ask-it):not(.checks) > .exa .btn",
    ".lesson .foot .btn:last-child",
];

/// Brings the focus back where it was lost: to the next thing in the course, and to
/// what opens the course where nothing of it is left.
pub(super) fn refocus() {
    if !is_lost() {
        return;
    }
    let place = super::place();
    let found = |instead: &&str| {
        let found = place.as_ref()?.query_selector(instead);
        found.ok().flatten()
    };
    let opener = || find(Target::Course).map(|(element, _)| element);
    let element = INSTEAD.iter().find_map(found).or_else(opener);
    if let Some(element) = element.and_then(|it| it.dyn_into::<HtmlElement>().ok()) {
        let _ = element.focus();
    }
}

/// Brings the focus to an element; one that is not there leaves it where it is.
pub(super) fn focus(node: &NodeRef) {
    if let Some(element) = node.cast::<HtmlElement>() {
        let _ = element.focus();
    }
}

/// Scrolls what the judge says into sight, where it is not: what is done above it, or a
/// plan that is shown, may have moved it away.
pub(super) fn bring_into_view() {
    let scroll = || {
        let Some(place) = super::place() else {
            return;
        };
        // What is being pressed stays under the finger until it is let go.
        if place
            .query_selector(".lesson :active")
            .ok()
            .flatten()
            .is_some()
        {
            return bring_into_view();
        }
        if let Some(said) = place
            .query_selector(".ex.solved, .judge-at:not(:empty)")
            .ok()
            .flatten()
        {
            let options = ScrollIntoViewOptions::new();
            options.set_block(ScrollLogicalPosition::Nearest);
            said.scroll_into_view_with_scroll_into_view_options(&options);
        }
    };
    Timeout::new(SETTLED_MS, scroll).forget();
}
