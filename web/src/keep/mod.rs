//! What the browser keeps: the document of each tab with its past, preferences,
//! scenes by name. A browser may refuse all of it, which is told.

mod address;
mod elsewhere;
mod keeper;
mod lost;
mod opening;
mod scenes;
mod storage;
mod tabs;

use giveway_page::Action;
use gloo::events::EventListener;
use yew::prelude::*;

use crate::{Shown, broke};
pub(crate) use address::{
    address, address_of_plan, forget_linked_language, learn, lesson, lesson_come, linked_language,
};
pub(crate) use keeper::{Rescued, rescue};
pub(crate) use lost::{download as download_lost, settle as settle_lost};
pub(crate) use opening::opening;
pub(crate) use scenes::{forget_scene, keep_scene, scene, scenes};
pub(crate) use storage::{forget, forget_here, load, remember, remembered, store};
pub(crate) use tabs::{other, others};

use keeper::Keeper;

/// Keeps the page as it changes, and when it is left; opens links that come to
/// the address while it is shown; hears of what other tabs keep.
#[hook]
pub(crate) fn use_keep(state: &Shown, send: &Callback<Action>) {
    let keeper = {
        let send = send.clone();
        use_memo((), move |()| Keeper::new(send))
    };
    {
        let (keeper, send) = (keeper.clone(), send.clone());
        use_effect_with((), move |()| {
            let window = gloo::utils::window();
            let linked = EventListener::new(&window, "hashchange", {
                let send = send.clone();
                move |_| {
                    if let Some(action) = address::opened() {
                        send.emit(action);
                    }
                }
            });
            let listening = (!crate::embed::is_embedded()).then(|| {
                let told = elsewhere::listen(&keeper, send);
                (told, leaving(&keeper))
            });
            move || drop((linked, listening))
        });
    }
    use_effect_with(state.clone(), move |state| keeper.saw(state));
}

/// The name that the chosen language is kept under.
const LANGUAGE: &str = "language";

/// The language that was chosen, by its tag; `None`, if the browser decides.
pub(crate) fn language() -> Option<String> {
    storage::load(LANGUAGE)
}

/// Keeps which language was chosen; an empty tag leaves it to the browser.
pub(crate) fn keep_language(tag: &str) {
    if tag.is_empty() {
        storage::forget(LANGUAGE);
    } else {
        // A browser that keeps nothing forgets it: it speaks as it would.
        let _ = storage::store(LANGUAGE, tag);
    }
}

/// Keeps the page when it is left or hidden: it may never be shown again.
fn leaving(keeper: &Keeper) -> [EventListener; 3] {
    let window = gloo::utils::window();
    let document = gloo::utils::document();
    let leave = |keeper: &Keeper| {
        // What is broken must not be kept.
        if !broke::is_broken() {
            keeper.keep();
            opening::went_well();
        }
        tabs::leave();
    };
    let (left, hidden) = (keeper.clone(), keeper.clone());
    [
        EventListener::new(&window, "pagehide", move |_| leave(&left)),
        EventListener::new(&window, "pageshow", |_| tabs::come_back()),
        EventListener::new(&document, "visibilitychange", move |_| {
            if gloo::utils::document().hidden() {
                leave(&hidden);
            } else {
                tabs::come_back();
            }
        }),
    ]
}
