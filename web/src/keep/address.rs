//! Links: the part of the address after `#`.

use giveway_page::{Action, PlayAction, State, link, reduce};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Event, HashChangeEvent};

use crate::embed::is_embedded;

/// Opens the scene of the address, once: the address is then as it was before,
/// so that what is changed from now on is not lost by loading the page anew.
/// Inside another page nothing is changed, and loading it anew shows the same.
pub(super) fn opened() -> Option<Action> {
    // What else stands there is nothing of this page's.
    let text = taken(|text| link::is_link(text).then(|| text.to_owned()))?;
    Some(link::open(&text))
}

/// How the part of the address begins that names a lesson.
const LESSON: &str = "lesson=";

/// Whether the address names something to be opened.
pub(super) fn is_link() -> bool {
    let hash = gloo::utils::window().location().hash();
    hash.is_ok_and(|hash| !hash.is_empty())
}

/// Opens the contents of the course, or what has this name in it, as a link does that is
/// followed; the browser's way back stays as it is.
pub(crate) fn learn(what: &str) {
    let location = gloo::utils::window().location();
    // It fails only for an address that is none.
    let _ = location.replace(&format!("#{LESSON}{what}"));
}

/// The lesson that the address names, or a step of it (`room-to-pass.2`), once.
pub(crate) fn lesson() -> Option<String> {
    taken(link::lesson)
}

/// The lesson of the address that has just come, once: by the time this is heard, an open
/// lesson may have put its own address in its place.
pub(crate) fn lesson_come(event: &Event) -> Option<String> {
    let come = event.dyn_ref::<HashChangeEvent>()?.new_url();
    let asked = come
        .split_once('#')
        .and_then(|(_, text)| link::lesson(text));
    let here = lesson();
    asked.or(here)
}

/// What is read of the text behind `#`; the address is then without it.
fn taken(read: impl FnOnce(&str) -> Option<String>) -> Option<String> {
    let window = gloo::utils::window();
    let hash = window.location().hash().ok()?;
    let text = read(hash.strip_prefix('#')?)?;
    if let (Ok(path), Ok(query), Ok(history)) = (
        window.location().pathname(),
        window.location().search(),
        window.history(),
    ) && !is_embedded()
    {
        let address = path + &query;
        // Where it is refused the link is just opened anew the next time.
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
    Some(text)
}

/// The address of the page with the state in it, for a reader's own language.
pub(crate) fn address(state: &State) -> String {
    let location = gloo::utils::window().location();
    let part = |part: Result<String, JsValue>| part.unwrap_or_default();
    let host = part(location.origin()) + &part(location.pathname());
    format!("{host}#{}", link::write(state))
}

/// The address of the page with its plan from the beginning: the same whenever a report is made.
pub(crate) fn address_of_plan(state: &State) -> String {
    address(&reduce(state, Action::Play(PlayAction::Seek(0))))
}

/// The language that the address of the page names.
pub(crate) fn linked_language() -> Option<String> {
    let query = gloo::utils::window().location().search().ok()?;
    link::language(&query).map(str::to_owned)
}

/// Takes the language out of the address: a person has chosen another one, which holds
/// after a reload.
pub(crate) fn forget_linked_language() {
    let window = gloo::utils::window();
    let location = window.location();
    if let (Ok(path), Ok(query), Ok(hash), Ok(history)) = (
        location.pathname(),
        location.search(),
        location.hash(),
        window.history(),
    ) && link::language(&query).is_some()
    {
        let address = path + &link::without_language(&query) + &hash;
        // Where it is refused a reload speaks the language of the link again.
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}
