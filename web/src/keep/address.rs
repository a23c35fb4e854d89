//! Links: the part of the address after `#`.

use giveway_page::{Action, State, link};
use wasm_bindgen::JsValue;

use crate::embed::is_embedded;

/// Opens the scene of the address, once: the address is then as it was before,
/// so that what is changed from now on is not lost by loading the page anew.
/// Inside another page nothing is changed, and loading it anew shows the same.
pub(super) fn opened() -> Option<Action> {
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
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
    Some(link::open(text))
}

/// The address of the page with the state in it.
pub(crate) fn address(state: &State) -> String {
    let location = gloo::utils::window().location();
    let part = |part: Result<String, JsValue>| part.unwrap_or_default();
    let host = part(location.origin()) + &part(location.pathname());
    format!("{host}#{}", link::write(state))
}
