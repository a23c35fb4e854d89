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
    let before = storage::load(LOST).unwrap_or_default();
    // Where it is refused, it is told again the next time.
    let _ = storage::store(LOST, &format!("{word} {name}\n{before}"));
    tabs::renew();
}

/// Why something could not be opened, if there is such a thing.
pub(super) fn why() -> Option<Lost> {
    noted().first().map(|(why, _)| *why)
}

/// Whether what is kept under a name could not be opened.
pub(super) fn is_lost(name: &str) -> bool {
    noted().iter().any(|(_, other)| other == name)
}

/// What could not be opened and is still there, the last one first.
fn noted() -> Vec<(Lost, String)> {
    let noted = storage::load(LOST).unwrap_or_default();
    let read = |line: &str| {
        let (word, name) = line.split_once(' ')?;
        let (_, why) = WHYS.iter().find(|(other, _)| *other == word)?;
        storage::load(name)?;
        Some((*why, name.to_owned()))
    };
    noted.lines().filter_map(read).collect()
}

/// Hands it to the browser to be saved, as it is.
pub(crate) fn download() {
    let text = noted().first().and_then(|(_, name)| storage::load(name));
    let blob = Blob::new_with_options(
        text.unwrap_or_default().as_str(),
        Some("application/octet-stream"),
    );
    files::save_as(FILE, blob);
}

/// It need not be told any longer; what was put aside before it is told the next time.
pub(crate) fn settle() {
    let noted = storage::load(LOST).unwrap_or_default();
    match noted.split_once('\n') {
        Some((_, before)) if !before.is_empty() => {
            // Where it is refused, it is told again the next time.
            let _ = storage::store(LOST, before);
        }
        _ => storage::forget(LOST),
    }
}
