//! What the browser keeps: the page as it is, and scenes by name. A browser may
//! refuse all of it, and then the page just begins anew every time.

use giveway_model::sorting;
use giveway_page::{Action, Draft, FileAction, Place, State, link, reduce};
use gloo::events::EventListener;
use gloo::timers::callback::Timeout;
use web_sys::Storage;
use yew::prelude::*;

use crate::embed::is_embedded;
use crate::held::use_held;
use crate::{Shown, opening};

/// The names under which things are kept; others of the same host have theirs.
const PAGE: &str = "giveway.page";
const PREFERENCES: &str = "giveway.preferences";
const SCENE: &str = "giveway.scene.";
/// The most scenes that are kept by name.
const SCENES: usize = 100;
/// How long nothing must change before the page is kept, in milliseconds.
const CALM_MS: u32 = 400;

/// Inside another page there is none: it must not keep its plan in the place of
/// what a person left on the page itself.
fn storage() -> Option<Storage> {
    if is_embedded() {
        return None;
    }
    gloo::utils::window().local_storage().ok()?
}

fn load(name: &str) -> Option<String> {
    storage()?.get_item(name).ok()?
}

/// Whether it was kept.
fn store(name: &str, text: &str) -> bool {
    text.len() <= link::LONGEST && storage().is_some_and(|s| s.set_item(name, text).is_ok())
}

/// The page as it was left, or a draft with its plan; in either case with the
/// scene of a link, if the address has one.
pub(crate) fn opening(otherwise: impl FnOnce() -> Draft) -> State {
    let kept = load(PAGE).and_then(|text| link::kept(&text).ok());
    let is_kept = kept.is_some();
    let mut state = kept.unwrap_or_else(|| State::new(otherwise()));
    if let Some(text) = load(PREFERENCES) {
        link::prefer(&mut state, &text);
    }
    if is_embedded() {
        state.view.place = Place::Embedded;
    }
    match from_address() {
        Some(action @ Action::File(FileAction::OpenLink(_))) => reduce(&state, action),
        // A link that is refused is told beside the page as it opens without it.
        refused => {
            if !is_kept {
                state = opening::solved(&state);
            }
            refused.map_or_else(|| state.clone(), |action| reduce(&state, action))
        }
    }
}

/// Opens the scene of the address, once: the address is then as it was before,
/// so that what is changed from now on is not lost by loading the page anew.
/// Inside another page nothing is changed, and loading it anew shows the same.
fn from_address() -> Option<Action> {
    let window = gloo::utils::window();
    let hash = window.location().hash().ok()?;
    // What else stands there is nothing of this page's.
    let text = hash
        .strip_prefix('#')
        .filter(|text| text.starts_with("giveway="))?;
    if let (Ok(path), Ok(query), Ok(history)) = (
        window.location().pathname(),
        window.location().search(),
        window.history(),
    ) && !is_embedded()
    {
        let address = path + &query;
        // Where it is refused the link is just opened anew the next time.
        let _ = history.replace_state_with_url(&wasm_bindgen::JsValue::NULL, "", Some(&address));
    }
    Some(link::open(text))
}

/// The address of the page with the state in it.
pub(crate) fn address(state: &State) -> String {
    let location = gloo::utils::window().location();
    let part = |part: Result<String, wasm_bindgen::JsValue>| part.unwrap_or_default();
    let host = part(location.origin()) + &part(location.pathname());
    format!("{host}#{}", link::write(state))
}

/// Keeps the page as it changes, and when it is left; opens links that come to
/// the address while it is shown.
#[hook]
pub(crate) fn use_keep(state: &Shown, send: &Callback<Action>) {
    let latest = use_held(|| state.clone());
    latest.set(state.clone());
    {
        let send = send.clone();
        use_effect_with((), move |()| {
            let window = gloo::utils::window();
            let left = EventListener::new(&window, "pagehide", move |_| keep(&latest.get()));
            let linked = EventListener::new(&window, "hashchange", move |_| {
                if let Some(action) = from_address() {
                    send.emit(action);
                }
            });
            move || drop((left, linked))
        });
    }
    use_effect_with(state.clone(), |state| {
        // While it plays nothing is changed but the time.
        let state = state.clone();
        let is_calm = !state.view.playback.playing;
        let waiting = is_calm.then(|| Timeout::new(CALM_MS, move || keep(&state)));
        move || drop(waiting)
    });
}

fn keep(state: &State) {
    // What does not fit is not kept: the page says nothing of it, as it works on.
    store(PAGE, &link::keep(state));
    store(PREFERENCES, &link::preferences(state));
}

/// The names of the scenes that are kept, in order.
pub(crate) fn scenes() -> Vec<String> {
    let Some(storage) = storage() else {
        return Vec::new();
    };
    let keys = (0..storage.length().unwrap_or(0)).filter_map(|n| storage.key(n).ok()?);
    let mut names: Vec<String> = keys
        .filter_map(|key| Some(key.strip_prefix(SCENE)?.to_owned()))
        .collect();
    sorting::sort(&mut names);
    names
}

/// Keeps the scene under its name, in the place of one of that name; whether
/// there was room.
pub(crate) fn keep_scene(state: &State) -> bool {
    let name = &state.document.draft.scene().name;
    let names = scenes();
    (names.len() < SCENES || names.contains(name))
        && store(&format!("{SCENE}{name}"), &link::write(state))
}

/// Opens a scene that was kept.
pub(crate) fn scene(name: &str) -> Action {
    link::open(&load(&format!("{SCENE}{name}")).unwrap_or_default())
}

/// Forgets a scene that was kept.
pub(crate) fn forget_scene(name: &str) {
    if let Some(storage) = storage() {
        // What is not there need not be forgotten.
        let _ = storage.remove_item(&format!("{SCENE}{name}"));
    }
}
