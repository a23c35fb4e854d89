//! Kept data that could not be opened: it stays under its name, and this tab has
//! another one. It is told until a person has downloaded it or starts afresh; after
//! that it is just not looked at any more.

use giveway_page::slot::Lost;
use gloo::file::Blob;

use super::{storage, tabs};
use crate::files;

/// Where it is noted what could not be opened, and why.
const LOST: &str = "lost";
/// The file that it is downloaded as.
const FILE: &str = "kept.giveway";

const WHYS: [(&str, Lost); 3] = [
    ("newer", Lost::Newer),
    ("damaged", Lost::Damaged),
    ("breaks", Lost::Breaks),
];

/// Notes that what is kept under a name cannot be opened; this tab keeps its document
/// under another name from then on.
pub(super) fn put_aside(name: &str, why: Lost) {
    let word = WHYS.iter().find(|(_, other)| *other == why);
    let word = word.map_or("damaged", |(word, _)| word);
    // Where it is refused, it is told again the next time.
    let _ = storage::store(LOST, &format!("{word} {name}"));
    tabs::renew();
}

/// Why something could not be opened, if there is such a thing.
pub(super) fn why() -> Option<Lost> {
    let (word, name) = noted()?;
    storage::load(&name)?;
    let why = WHYS.iter().find(|(other, _)| *other == word);
    why.map(|(_, why)| *why)
}

/// The name of what could not be opened.
pub(super) fn name() -> Option<String> {
    noted().map(|(_, name)| name)
}

fn noted() -> Option<(String, String)> {
    let noted = storage::load(LOST)?;
    let (word, name) = noted.split_once(' ')?;
    Some((word.to_owned(), name.to_owned()))
}

/// Hands it to the browser to be saved, as it is.
pub(crate) fn download() {
    let text = name().and_then(|name| storage::load(&name));
    let blob = Blob::new_with_options(
        text.unwrap_or_default().as_str(),
        Some("application/octet-stream"),
    );
    files::save_as(FILE, blob);
}

/// It need not be told any longer.
pub(crate) fn settle() {
    storage::forget(LOST);
}
