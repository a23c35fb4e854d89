//! From words in fields to the values of a file.

use giveway_model::Cell;
use giveway_model::change::Changes;
use giveway_model::format::native;
use giveway_model::question::from_words;
use serde_json::{Map, Value};

use super::field::Shape;
use super::{Field, Words, Wrong};
use crate::lesson::{Span, Text};

/// Faults, each with the name of its field.
pub(super) type Faults = Vec<(String, Wrong)>;

/// The object of some fields, as far as they can be read, with what is wrong in them.
pub(super) fn object(fields: &[Field], words: &Words, faults: &mut Faults) -> Value {
    let mut whole = Value::Object(Map::new());
    for field in fields {
        let text = field.value(words).trim();
        if text.is_empty() {
            if field.must {
                faults.push((field.name.clone(), Wrong::Missing));
            }
            continue;
        }
        if let Some(value) = value(field, text, faults) {
            put(&mut whole, &field.name, value);
        }
    }
    whole
}

fn value(field: &Field, text: &str, faults: &mut Faults) -> Option<Value> {
    let mut wrong = |wrong: Wrong| {
        faults.push((field.name.clone(), wrong));
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
            Err(_) => wrong(Wrong::NotNumber),
        },
        Shape::Words => {
            let lines = text.lines().map(str::trim);
            let lines = lines.filter(|line| !line.is_empty());
            Some(lines.map(Value::from).collect())
        }
        Shape::Cell => match cells(text).as_deref() {
            Some([cell]) => Some(pair(*cell)),
            _ => wrong(Wrong::NotCell),
        },
        Shape::Cells => match cells(text) {
            Some(cells) => Some(cells.into_iter().map(pair).collect()),
            None => wrong(Wrong::NotCells),
        },
        Shape::Question => {
            let words: Vec<&str> = text.split_whitespace().collect();
            match from_words(&words) {
                Ok(question) => serde_json::to_value(question).ok(),
                Err(why) => wrong(Wrong::NotQuestion(why.to_string())),
            }
        }
        Shape::Changes => match native::read_object::<Changes>(text) {
            Ok(changes) => serde_json::to_value(changes).ok(),
            Err(fault) => wrong(Wrong::NotChanges(fault)),
        },
    }
}

/// Words on one line, as markup has them.
fn one_line(text: &str) -> String {
    let lines = text.lines().map(str::trim);
    lines.collect::<Vec<_>>().join(" ")
}

fn paragraphs(name: &str, text: &str, faults: &mut Faults) -> Value {
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
fn paragraph(name: &str, text: &str, faults: &mut Faults) -> Value {
    match text.parse::<Text>() {
        Ok(text) => text.to_string().into(),
        Err(error) => {
            faults.push((name.to_owned(), Wrong::Markup(error)));
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
