//! How answers are written: for people as text, for programs as JSON.

mod compared;
pub(crate) mod files;
mod json;
mod map;
mod marks;
pub(crate) mod plain;
pub(crate) mod raster;
pub(crate) mod report;
mod said;
pub(crate) mod stream;
mod table;
pub(crate) mod text;
pub(crate) mod words;

pub(crate) use compared::{Compared, ComparedPlan};
use said::Noted;
pub(crate) use said::Said;

use std::path::Path;

use serde::Serialize;

use crate::{args::Format, failure::Failure};

/// Writes how a plan was found into a file of its own.
pub(crate) fn trace(path: &Path, trace: &impl Serialize) -> Result<(), Failure> {
    files::write_all(&[files::NewFile {
        path: path.to_owned(),
        text: json::text(trace)?,
    }])
}

/// Writes an answer in the format asked for, with what is to be said of its input.
///
/// `text` gets the columns that a line may take.
pub(crate) fn answer(
    format: Format,
    said: &Said,
    answer: &impl Serialize,
    text: impl FnOnce(usize) -> String,
) -> Result<(), Failure> {
    match format {
        Format::Json => stream::file(json::text(&Noted { answer, said })?.as_bytes()),
        Format::Text => stream::result(&(said.text() + &text(stream::columns()))),
    }
}
