//! What the page opens on: what this tab kept, or else what was kept last.

use giveway_page::slot::Lost;
use giveway_page::{Action, Draft, FileAction, Place, State, link, reduce};

use super::keeper::PREFERENCES;
use super::{address, lost, storage, tabs};
use crate::embed::is_embedded;
use crate::opening::solved;

/// Where a tab remembers what it is about to open: if it is still there the next
/// time, the page broke down on it.
const OPENING: &str = "opening";

/// The page as it was left, or a draft with its plan; in either case with the scene
/// of a link, if the address has one.
pub(crate) fn opening(otherwise: impl FnOnce() -> Draft) -> State {
    let kept = if is_embedded() { None } else { kept() };
    let is_kept = kept.is_some();
    let mut state = kept.unwrap_or_else(|| State::new(otherwise()));
    if let Some(text) = storage::load(PREFERENCES) {
        link::prefer(&mut state, &text);
    }
    if is_embedded() {
        state.view.place = Place::Embedded;
    }
    state.view.waiting.lost = lost::why();
    // Who had work here, or comes by a link, knows what it is about.
    let is_first = !is_embedded()
        && state.view.waiting.lost.is_none()
        && !state.history.is_touched()
        && !address::is_link()
        && !storage::is_welcomed();
    let mut state = match address::opened() {
        Some(action @ Action::File(FileAction::OpenLink(_))) => reduce(&state, action),
        // A link that is refused is told beside the page as it opens without it.
        refused => {
            if !is_kept {
                state = solved(&state);
            }
            refused.map_or_else(|| state.clone(), |action| reduce(&state, action))
        }
    };
    state.view.waiting.welcome = is_first;
    state
}

/// What is kept, if it can be opened; else it is put aside.
fn kept() -> Option<State> {
    let broke_on = storage::remembered(OPENING);
    went_well();
    let name = tabs::begin()?;
    let text = storage::load(&name)?;
    let why = if broke_on.as_ref() == Some(&name) {
        Lost::Breaks
    } else {
        storage::remember(OPENING, &name);
        match link::kept(&text) {
            Ok(state) => return Some(state),
            Err(_) if link::is_newer(&text) => Lost::Newer,
            Err(_) => Lost::Damaged,
        }
    };
    went_well();
    lost::put_aside(&name, why);
    None
}

/// What was opened is shown, and nothing broke down.
pub(super) fn went_well() {
    storage::forget_here(OPENING);
}
