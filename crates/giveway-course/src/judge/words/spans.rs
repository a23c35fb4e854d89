//! The parts of a sentence as the markup of a paragraph: words, and links to robots and
//! cells. A sentence is put together in a language's own order, and then read.

use giveway_model::Cell;

use crate::lesson::{Span, Target, Text, Value};

/// A sentence that was put together; one that is no markup stands as it is.
pub(super) fn text(marked: &str) -> Text {
    let words = || Text::of(vec![Span::Plain(marked.to_owned())]);
    marked.parse().unwrap_or_else(|_| words())
}

/// Words that name nothing.
pub(super) fn plain(words: &str) -> String {
    Text::of(vec![Span::Plain(words.to_owned())]).to_string()
}

pub(super) fn robot(name: &str) -> String {
    link(name.to_owned(), Target::Robot(name.to_owned()))
}

pub(super) fn cell(cell: Cell) -> String {
    link(cell.to_string(), Target::Cell(cell))
}

fn link(label: String, target: Target) -> String {
    Text::of(vec![Span::Link { label, target }]).to_string()
}

pub(super) fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Robot(name) => robot(name),
        Value::Cell(at) => cell(*at),
        Value::Rule { .. } => plain(&value.to_string()),
    }
}
