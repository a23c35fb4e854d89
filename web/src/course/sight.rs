//! Where a person looks: the focus, and what is to be in sight.

use gloo::timers::callback::Timeout;
use web_sys::{HtmlElement, ScrollIntoViewOptions, ScrollLogicalPosition};
use yew::prelude::*;

/// How long the page may take to lay itself out anew, in milliseconds.
const SETTLED_MS: u32 = 120;

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
        let said = super::place().and_then(|place| {
            let said = place.query_selector(".ex.solved, .judge-at:not(:empty)");
            said.ok().flatten()
        });
        if let Some(said) = said {
            let options = ScrollIntoViewOptions::new();
            options.set_block(ScrollLogicalPosition::Nearest);
            said.scroll_into_view_with_scroll_into_view_options(&options);
        }
    };
    Timeout::new(SETTLED_MS, scroll).forget();
}
