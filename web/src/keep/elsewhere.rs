//! What other tabs keep is heard of: what they made of the same scene can be looked
//! at and taken.

use giveway_page::link::{self, Kin};
use giveway_page::slot::Elsewhere;
use giveway_page::{Action, SlotAction};
use gloo::events::EventListener;
use wasm_bindgen::JsCast as _;
use web_sys::StorageEvent;
use yew::Callback;

use super::keeper::Keeper;
use super::{storage, tabs};

/// Listens for what other tabs keep.
pub(super) fn listen(keeper: &Keeper, send: Callback<Action>) -> EventListener {
    let keeper = keeper.clone();
    EventListener::new(&gloo::utils::window(), "storage", move |event| {
        let Some(event) = event.dyn_ref::<StorageEvent>() else {
            return;
        };
        let tab = event.key().and_then(|key| storage::rest(&key, tabs::TAB));
        let (Some(tab), Some(text)) = (tab, event.new_value()) else {
            return;
        };
        if tab == tabs::number() {
            // A tab that was duplicated has the same number: this one takes another,
            // under which nothing of it is lost.
            tabs::renew();
            keeper.keep();
            return;
        }
        if let Some(action) = heard(&keeper, tab, &text) {
            send.emit(Action::Slot(action));
        }
    })
}

fn heard(keeper: &Keeper, tab: String, text: &str) -> Option<SlotAction> {
    let state = keeper.latest()?;
    let is_ahead = match link::kin(&link::keep(&state), text) {
        Kin::Ahead => true,
        Kin::Apart => false,
        Kin::Same | Kin::Behind => return Some(SlotAction::Agree),
        Kin::Strange => return None,
    };
    // What cannot be read is told when it is opened.
    let moment = link::kept_moment(text).ok()?;
    Some(SlotAction::Differ(Box::new(Elsewhere {
        tab,
        moment,
        is_ahead,
    })))
}
