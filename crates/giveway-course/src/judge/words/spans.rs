//! The parts of a sentence: words, and links to robots and cells.

use giveway_model::Cell;

use crate::lesson::{Span, Target, Value};

pub(super) fn plain(words: impl Into<String>) -> Vec<Span> {
    vec![Span::Plain(words.into())]
}

pub(super) fn text(words: &str) -> Span {
    Span::Plain(words.to_owned())
}

pub(super) fn robot(name: &str) -> Span {
    Span::Link {
        label: name.to_owned(),
        target: Target::Robot(name.to_owned()),
    }
}

pub(super) fn cell(cell: Cell) -> Span {
    Span::Link {
        label: cell.to_string(),
        target: Target::Cell(cell),
    }
}

pub(super) fn shown(value: &Value) -> Span {
    match value {
        Value::Number(number) => text(&number.to_string()),
        Value::Robot(name) => robot(name),
        Value::Cell(at) => cell(*at),
    }
}
