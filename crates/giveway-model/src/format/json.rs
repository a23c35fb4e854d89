//! Reads JSON and turns what the JSON library says into faults for people.

use std::fmt::Write as _;

use serde::Deserialize;
use serde_json::error::Category;
use serde_path_to_error::{Path, Segment as PathSegment};

use super::locate::{Locator, Segment, segments};
use super::phrase::{self, Phrase};
use super::text::{at_byte, position, shorten};
use crate::{Fault, tr};

/// Reads one JSON object of type `T` and nothing after it.
///
/// # Errors
/// The first fault of the text, with its line and column.
pub fn read<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, Fault> {
    if text.trim().is_empty() {
        return Err(Fault::at("", tr!("an empty file"), tr!("a JSON object")).in_text(1, 1));
    }
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut deserializer)
        .map_err(|error| fault(text, error.inner(), error.path()))?;
    deserializer
        .end()
        .map_err(|error| syntax_fault(text, &error))?;
    Ok(value)
}

/// The same for a large text: its way of keys is only followed when it is read again,
/// for the fault.
///
/// # Errors
/// The first fault of the text, with its line and column.
pub fn read_large<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, Fault> {
    serde_json::from_str(text).or_else(|_| read(text))
}

fn fault(text: &str, error: &serde_json::Error, path: &Path) -> Fault {
    match error.classify() {
        Category::Syntax | Category::Eof | Category::Io => syntax_fault(text, error),
        Category::Data => data_fault(text, error, path),
    }
}

/// A text that is no JSON.
fn syntax_fault(text: &str, error: &serde_json::Error) -> Fault {
    let offset = match error.classify() {
        Category::Eof => text.len(),
        _ => offset(text, error),
    };
    let offset = word_start(text, offset, error);
    let rest = text.get(offset..).unwrap_or("");
    let Phrase { found, expected } = phrase::of_syntax(&bare(error), rest, offset == 0);
    let (line, column) = position(text, offset);
    Fault::at("", found, expected).in_text(line, column)
}

/// Where a word begins that is taken for `true`, `false` or `null` at first;
/// the library points into the midst of it.
fn word_start(text: &str, offset: usize, error: &serde_json::Error) -> usize {
    if bare(error) != "expected ident" {
        return offset;
    }
    let before = text.as_bytes().get(..offset).unwrap_or_default();
    let letters = before.iter().rev().take_while(|b| b.is_ascii_alphabetic());
    offset - letters.count()
}

/// JSON that is not of the format.
fn data_fault(text: &str, error: &serde_json::Error, path: &Path) -> Fault {
    let message = bare(error);
    let mut way = way(path);
    let about_key = phrase::key_of(&message);
    if let Some(key) = about_key
        && way.last() != Some(&Segment::Key(key.to_owned()))
    {
        way.push(Segment::Key(key.to_owned()));
    }
    let offset = Locator::new(text)
        .find(&way, about_key.is_some())
        .unwrap_or_else(|| offset(text, error));
    // The place of an unknown or repeated key is the object that holds it.
    if about_key.is_some() {
        way.pop();
    }
    let Phrase { found, expected } = phrase::of_data(&message);
    let (line, column) = position(text, offset);
    Fault::at(place(&way), found, expected).in_text(line, column)
}

/// The message without its line and column.
fn bare(error: &serde_json::Error) -> String {
    let message = error.to_string();
    match message.rfind(" at line ") {
        Some(end) => message.get(..end).unwrap_or("").to_owned(),
        None => message,
    }
}

/// The byte that the library points at; it counts columns in bytes from 1.
fn offset(text: &str, error: &serde_json::Error) -> usize {
    let before = error.line().saturating_sub(1);
    let line_start: usize = text.split_inclusive('\n').take(before).map(str::len).sum();
    (line_start + error.column().saturating_sub(1)).min(text.len())
}

fn way(path: &Path) -> Vec<Segment> {
    path.iter()
        .filter_map(|segment| match segment {
            PathSegment::Seq { index } => Some(Segment::Index(*index)),
            PathSegment::Map { key } => Some(Segment::Key(key.clone())),
            PathSegment::Enum { .. } | PathSegment::Unknown => None,
        })
        .collect()
}

/// The fault of a value with the line and column at which its place is in the text.
pub fn placed(text: &str, fault: Fault) -> Fault {
    let offset = Locator::new(text).find(&segments(&fault.place), false);
    at_byte(text, offset.unwrap_or_default(), fault)
}

/// Writes a way as `agents[1].goal`; names that are no plain words are quoted.
pub fn place(way: &[Segment]) -> String {
    let mut place = String::new();
    for segment in way {
        match segment {
            Segment::Index(index) => {
                let _ = write!(place, "[{index}]");
            }
            Segment::Key(key) => {
                let plain = key.chars().all(|c| c.is_alphanumeric() || "_-".contains(c));
                if !plain {
                    let _ = write!(place, "[\"{}\"]", shorten(key));
                    continue;
                }
                if !place.is_empty() {
                    place.push('.');
                }
                place.push_str(&shorten(key));
            }
        }
    }
    place
}
