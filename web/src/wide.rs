//! Whether there is room for two boards: side by side, or as pages that a finger swipes.

use giveway_page::{Action, ViewAction};
use gloo::events::EventListener;
use yew::prelude::*;

/// All but a phone that lies: as in the style sheets.
const WIDE: &str = "(min-height: 481px)";

/// Tells the state how much room there is, now and when that changes.
#[hook]
pub(crate) fn use_wide(send: &Callback<Action>) {
    let send = send.clone();
    use_effect_with((), move |()| {
        let query = gloo::utils::window().match_media(WIDE).ok().flatten();
        let listener = query.map(|query| {
            send.emit(Action::View(ViewAction::SetWide(query.matches())));
            let asked = query.clone();
            EventListener::new(&query, "change", move |_| {
                send.emit(Action::View(ViewAction::SetWide(asked.matches())));
            })
        });
        move || drop(listener)
    });
}
