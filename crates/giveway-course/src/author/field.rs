//! A field of the form: its name, what is written into it, and what that becomes.

use super::{Words, YES};

/// A field of the form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its place in the file, from the lesson or from its step on:
    /// `task.answers[1].reply`.
    pub name: String,
    /// What it is called.
    pub label: &'static str,
    /// Where it stands.
    pub part: Part,
    /// How something is written into it.
    pub input: Input,
    /// Whether something must be in it.
    pub must: bool,
    /// What it becomes in the file.
    pub(super) shape: Shape,
}

/// Where a field stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// With the text.
    Text,
    /// With the board.
    Board,
    /// With what may be done on the board.
    Tools,
    /// With the task.
    Task,
    /// With an answer of the task, by its index.
    Answer(usize),
    /// With what helps, and what is said at the end.
    Help,
}

/// How something is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Input {
    /// On one line.
    Line,
    /// On several lines.
    Area,
    /// A number.
    Number,
    /// Yes or no.
    Switch,
    /// One of these.
    One(Vec<Pick>),
    /// Any of these.
    Many(Vec<Pick>),
}

/// Something to choose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pick {
    /// What is written then.
    pub value: String,
    /// What it is called.
    pub label: String,
}

impl Pick {
    pub(super) fn new(value: impl Into<String>, label: impl Into<String>) -> Self {
        Self {
            value: value.into(),
            label: label.into(),
        }
    }
}

/// What the words of a field become.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// The words as they are.
    Word,
    /// A paragraph with markup.
    Text,
    /// Paragraphs, with an empty line between them.
    Paragraphs,
    /// A number.
    Number,
    /// A list of words, a line each.
    Words,
    /// Yes or no.
    Flag,
    /// A cell.
    Cell,
    /// Cells.
    Cells,
    /// A question, as it is typed for the command.
    Question,
    /// Changes, as the page saves them.
    Changes,
    /// Nothing: it says how others are read.
    None,
}

impl Field {
    /// What is in it: what is written, or else the first thing to choose where one
    /// must be.
    pub fn value<'a>(&'a self, words: &'a Words) -> &'a str {
        let written = words.get(&self.name).map(String::as_str);
        match &self.input {
            Input::One(picks) if self.must => written.unwrap_or_else(|| first(picks)),
            _ => written.unwrap_or(""),
        }
    }

    /// What may be chosen, and what was written otherwise.
    pub fn picks(&self, words: &Words) -> Vec<Pick> {
        let (Input::One(picks) | Input::Many(picks)) = &self.input else {
            return Vec::new();
        };
        let mut picks = picks.clone();
        let written = words.get(&self.name).map_or("", String::as_str);
        let one = matches!(self.input, Input::One(_));
        let written: Vec<&str> = if one {
            vec![written]
        } else {
            written.lines().collect()
        };
        for value in written {
            if !value.is_empty() && !picks.iter().any(|pick| pick.value == value) {
                picks.push(Pick::new(value, value.replace('\n', ", ")));
            }
        }
        picks
    }

    /// Whether one of several things is chosen.
    pub fn has(&self, words: &Words, value: &str) -> bool {
        let written = words.get(&self.name).map_or("", String::as_str);
        written.lines().any(|line| line == value)
    }

    /// Whether a switch is on.
    pub fn is_on(&self, words: &Words) -> bool {
        words.get(&self.name).is_some_and(|word| word == YES)
    }

    /// What a switch has written when it is on, or off.
    pub const fn switched(on: bool) -> &'static str {
        if on { YES } else { "" }
    }
}

fn first(picks: &[Pick]) -> &str {
    picks.first().map_or("", |pick| &pick.value)
}
