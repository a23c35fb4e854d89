//! Files as people bring them: read, or refused with what they seem to be.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test stops at the first surprise"
)]

#[path = "brought/encodings.rs"]
mod encodings;
#[path = "brought/grids.rs"]
mod grids;
#[path = "brought/league.rs"]
mod league;
#[path = "brought/notes.rs"]
mod notes;
#[path = "brought/printed.rs"]
mod printed;
#[path = "brought/refusals.rs"]
mod refusals;
#[path = "brought/results.rs"]
mod results;

use std::path::PathBuf;

use giveway_formats::{Combined, Options, Refused, Source, combine};
use giveway_model::format::read_text;

/// The text of a file that people brought.
pub(crate) fn brought(name: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/brought");
    let bytes = std::fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    read_text(&bytes)
        .unwrap_or_else(|fault| panic!("{name}: {fault}"))
        .into_owned()
}

/// Gathers files given by name and text.
pub(crate) fn opened(files: &[(&str, &str)]) -> Result<Combined, Refused> {
    let sources: Vec<Source<'_>> = files
        .iter()
        .map(|&(name, text)| Source { name, text })
        .collect();
    combine(&sources, &Options::default())
}

/// The first fault of a text that is refused, as a sentence.
#[track_caller]
pub(crate) fn refused(text: &str) -> String {
    match giveway_formats::read(text) {
        Ok(held) => panic!("{held:?}"),
        Err(faults) => faults[0].to_string(),
    }
}

/// The sentence why files are no scene.
#[track_caller]
pub(crate) fn apart(files: &[(&str, &str)]) -> String {
    match opened(files) {
        Ok(combined) => panic!("{combined:?}"),
        Err(refused) => match refused {
            Refused::Missing { sentence, .. } | Refused::Apart(sentence) => sentence,
            Refused::File { file, faults } => format!("{file}, {}", faults[0]),
        },
    }
}
