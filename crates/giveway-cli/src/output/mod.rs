//! How answers are written: for people as text, for programs as JSON.

mod compared;
pub(crate) mod files;
mod json;
mod map;
mod marks;
pub(crate) mod plain;
pub(crate) mod report;
pub(crate) mod stream;
mod table;
pub(crate) mod text;
pub(crate) mod words;

pub(crate) use compared::{Compared, ComparedPlan};
pub(crate) use json::text as json_text;

use serde::Serialize;

use crate::{args::Format, failure::Failure};

/// Writes an answer in the format asked for.
///
/// `text` gets the columns that a line may take.
pub(crate) fn answer(
    format: Format,
    answer: &impl Serialize,
    text: impl FnOnce(usize) -> String,
) -> Result<(), Failure> {
    match format {
        Format::Json => stream::file(json::text(answer)?.as_bytes()),
        Format::Text => stream::result(&text(stream::columns())),
    }
}
