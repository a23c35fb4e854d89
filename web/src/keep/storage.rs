//! The browser's storage: texts under names. Names of other pages of the same host
//! are none of ours.

use giveway_page::slot::Unkept;
use web_sys::Storage;

use crate::embed::is_embedded;

/// What all names begin with.
const OURS: &str = "giveway.";

/// What is kept for as long as the browser likes. Inside another page there is none:
/// it must not keep its plan in the place of what a person left on the page itself.
fn lasting() -> Option<Storage> {
    if is_embedded() {
        return None;
    }
    gloo::utils::window().local_storage().ok()?
}

/// What is kept for as long as the tab is there.
fn passing() -> Option<Storage> {
    if is_embedded() {
        return None;
    }
    gloo::utils::window().session_storage().ok()?
}

fn ours(name: &str) -> String {
    format!("{OURS}{name}")
}

/// What is kept under a name.
pub(crate) fn load(name: &str) -> Option<String> {
    lasting()?.get_item(&ours(name)).ok()?
}

/// Keeps a text under a name.
///
/// # Errors
/// Why the browser does not keep it.
pub(crate) fn store(name: &str, text: &str) -> Result<(), Unkept> {
    let storage = lasting().ok_or(Unkept::Refused)?;
    storage
        .set_item(&ours(name), text)
        .map_err(|_| match storage.length() {
            Ok(1..) => Unkept::Full,
            _ => Unkept::Refused,
        })
}

/// The name under which it is kept that nobody needs a welcome any more.
const WELCOME: &str = "welcome";

/// Whether a person was welcomed before.
pub(super) fn is_welcomed() -> bool {
    load(WELCOME).is_some()
}

/// Nobody needs a welcome any more.
pub(super) fn welcomed() {
    // A browser that keeps nothing welcomes again.
    let _ = store(WELCOME, "seen");
}

/// Forgets what is kept under a name.
pub(crate) fn forget(name: &str) {
    if let Some(storage) = lasting() {
        // What is not there need not be forgotten.
        let _ = storage.remove_item(&ours(name));
    }
}

/// The rest of all names that begin so.
pub(super) fn names(begin: &str) -> Vec<String> {
    let Some(storage) = lasting() else {
        return Vec::new();
    };
    let keys = (0..storage.length().unwrap_or(0)).filter_map(|n| storage.key(n).ok()?);
    keys.filter_map(|key| rest(&key, begin)).collect()
}

/// The rest of the name of a key that begins so.
pub(super) fn rest(key: &str, begin: &str) -> Option<String> {
    let rest = key.strip_prefix(OURS)?.strip_prefix(begin)?;
    Some(rest.to_owned())
}

/// What this tab alone keeps under a name.
pub(crate) fn remembered(name: &str) -> Option<String> {
    passing()?.get_item(&ours(name)).ok()?
}

/// Keeps a text for this tab alone, if the browser lets it; whether it does.
pub(crate) fn remember(name: &str, text: &str) -> bool {
    passing().is_some_and(|storage| storage.set_item(&ours(name), text).is_ok())
}

/// Forgets what this tab alone keeps.
pub(crate) fn forget_here(name: &str) {
    if let Some(storage) = passing() {
        let _ = storage.remove_item(&ours(name));
    }
}
