//! From words in fields to the values of a file.

use giveway_model::change::Changes;
use giveway_model::format::native;
use giveway_model::question::from_words;
use giveway_model::words::Later;
use giveway_model::{Cell, Fault, tr, tr_later};
use serde_json::{Map, Value};

use super::field::Shape;
use super::{Field, Words};
use crate::lesson::{Span, Text};

/// What is found in a field in which nothing is.
const NOTHING: Later = tr_later!("nothing");

/// The object of some fields, as far as they can be read, with what is wrong in them.
pub(super) fn object(fields: &[Field], words: &Words, faults: &mut Vec<Fault>) -> Value {
    let mut whole = Value::Object(Map::new());
    for field in fields {
        let text = field.value(words).trim();
        if text.is_empty() {
            if field.must {
                faults.push(Fault::at(&field.name, NOTHING, expected(field.shape)));
            }
            continue;
        }
        if let Some(value) = value(field, text, faults) {
            put(&mut whole, &field.name, value);
        }
    }
    whole
}

/// Whether a fault only says that nothing is written yet.
pub(super) fn is_missing(fault: &Fault) -> bool {
    fault.found == NOTHING.text() || fault.found == NOTHING.english()
}

fn expected(shape: Shape) -> &'static str {
    match shape {
        Shape::Text | Shape::Paragraphs => tr!("a sentence"),
        Shape::Number => tr!("a number"),
        Shape::Words => tr!("at least one"),
        Shape::Cell | Shape::Cells => tr!("a cell, such as 3,1"),
        Shape::Question => tr!("a question"),
        Shape::Changes => tr!("changes"),
        Shape::Word | Shape::Flag | Shape::None => tr!("a few words"),
    }
}

fn value(field: &Field, text: &str, faults: &mut Vec<Fault>) -> Option<Value> {
    let mut wrong = |found: String, expected: &str| {
        faults.push(Fault::at(&field.name, found, expected));
        None
    };
    match field.shape {
        Shape::None => None,
        Shape::Word => Some(text.into()),
        Shape::Flag => Some(true.into()),
        Shape::Text => Some(paragraph(&field.name, &one_line(text), faults)),
        Shape::Paragraphs => Some(paragraphs(&field.name, text, faults)),
        Shape::Number => match text.parse::<u32>() {
            Ok(number) => Some(number.into()),
            Err(_) => wrong(quoted(text), tr!("a whole number")),
        },
        Shape::Words => {
            let lines = text.lines().map(str::trim);
            let lines = lines.filter(|line| !line.is_empty());
            Some(lines.map(Value::from).collect())
        }
        Shape::Cell => match cells(text).as_deref() {
            Some([cell]) => Some(pair(*cell)),
            _ => wrong(quoted(text), tr!("a cell, such as 3,1")),
        },
        Shape::Cells => match cells(text) {
            Some(cells) => Some(cells.into_iter().map(pair).collect()),
            None => wrong(quoted(text), tr!("cells, such as 3,1 4,1")),
        },
        Shape::Question => {
            let words: Vec<&str> = text.split_whitespace().collect();
            match from_words(&words) {
                Ok(question) => serde_json::to_value(question).ok(),
                Err(why) => wrong(quoted(text), &tr!("a question: {why}", why)),
            }
        }
        Shape::Changes => match native::read_object::<Changes>(text) {
            Ok(changes) => serde_json::to_value(changes).ok(),
            Err(fault) => {
                faults.push(fault.of_part(&field.name));
                None
            }
        },
    }
}

fn quoted(text: &str) -> String {
    let short: String = text.chars().take(40).collect();
    format!("{short:?}")
}

/// Words on one line, as markup has them.
fn one_line(text: &str) -> String {
    let lines = text.lines().map(str::trim);
    lines.collect::<Vec<_>>().join(" ")
}

fn paragraphs(name: &str, text: &str, faults: &mut Vec<Fault>) -> Value {
    let mut all: Vec<String> = Vec::new();
    let mut is_open = false;
    for line in text.lines().map(str::trim) {
        match (line.is_empty(), is_open, all.last_mut()) {
            (true, ..) => is_open = false,
            (false, true, Some(last)) => {
                last.push(' ');
                last.push_str(line);
            }
            (false, ..) => {
                all.push(line.to_owned());
                is_open = true;
            }
        }
    }
    let all = all.iter().enumerate();
    all.map(|(index, text)| paragraph(&format!("{name}[{index}]"), text, faults))
        .collect()
}

/// A paragraph; one whose markup is broken has its words as they are.
fn paragraph(name: &str, text: &str, faults: &mut Vec<Fault>) -> Value {
    match text.parse::<Text>() {
        Ok(text) => text.to_string().into(),
        Err(error) => {
            let found = tr!(
                "{found} at character {at}",
                found = error.found,
                at = error.at
            );
            faults.push(Fault::at(name, found, error.expected));
            let most = crate::lesson::text::MAX_CHARACTERS / 2;
            let plain = text.chars().filter(|c| !c.is_control()).take(most);
            Text::of(vec![Span::Plain(plain.collect())])
                .to_string()
                .into()
        }
    }
}

fn pair(cell: Cell) -> Value {
    [cell.x, cell.y].into_iter().collect()
}

/// Cells as they are typed: `3,1 4,1`, or `(3, 1), (4, 1)`.
fn cells(text: &str) -> Option<Vec<Cell>> {
    let is_between = |c: char| c.is_whitespace() || matches!(c, ',' | ';' | '(' | ')' | '[' | ']');
    let numbers = text.split(is_between).filter(|part| !part.is_empty());
    let numbers: Vec<u32> = numbers
        .map(|part| part.parse().ok())
        .collect::<Option<_>>()?;
    let pairs = numbers.chunks(2).map(|pair| match pair {
        [x, y] => Some(Cell::new(*x, *y)),
        _ => None,
    });
    pairs.collect()
}

/// Puts a value at a place, and what is around it where that is not there yet.
fn put(whole: &mut Value, place: &str, value: Value) {
    let parts: Vec<&str> = place.split(['.', '[']).collect();
    put_in(whole, &parts, value);
}

/// Those of a list follow each other: one that is left out leaves no gap.
fn put_in(at: &mut Value, parts: &[&str], value: Value) {
    let Some((part, rest)) = parts.split_first() else {
        *at = value;
        return;
    };
    if let Some(index) = part.strip_suffix(']') {
        if !at.is_array() {
            *at = Value::Array(Vec::new());
        }
        if let Value::Array(list) = at {
            let index = index.parse().unwrap_or(0).min(list.len());
            if index == list.len() {
                list.push(Value::Null);
            }
            if let Some(inner) = list.get_mut(index) {
                put_in(inner, rest, value);
            }
        }
    } else {
        if !at.is_object() {
            *at = Value::Object(Map::new());
        }
        if let Value::Object(object) = at {
            let inner = object.entry(*part).or_insert(Value::Null);
            put_in(inner, rest, value);
        }
    }
}
