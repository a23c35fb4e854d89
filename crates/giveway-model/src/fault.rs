//! A fault of an input, with its place.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::tr;

/// A fault of an input: the place, what was found, what was expected.
///
/// `place` is a path of keys and indices from 0, such as `agents[1].goal`;
/// `line` and `column` (from 1) are there where the input was text. The name of
/// the file is added by whoever opened it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Fault {
    /// Keys and indices, such as `agents[1].goal`; empty for the whole.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub place: String,
    /// The line of the text, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// The column of the text, in characters from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
    /// Found, as a phrase: `the obstacle (2, 1)`.
    pub found: String,
    /// Expected, as a phrase: `a free cell`.
    pub expected: String,
}

impl Fault {
    /// A fault at a place of the data.
    pub fn at(
        place: impl Into<String>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self {
            place: place.into(),
            line: None,
            column: None,
            found: found.into(),
            expected: expected.into(),
        }
    }

    /// The same fault, with its line and column in the text, both from 1.
    #[must_use]
    pub fn in_text(mut self, line: usize, column: usize) -> Self {
        self.line = Some(line);
        self.column = Some(column);
        self
    }

    /// The same fault, with the name of its file before its place.
    #[must_use]
    pub fn in_file(mut self, name: &str) -> Self {
        self.place = match self.place.as_str() {
            "" => name.to_owned(),
            place => format!("{name}: {place}"),
        };
        self
    }

    /// The same fault of a part of something larger, such as the scene of a request.
    #[must_use]
    pub fn of_part(mut self, part: &str) -> Self {
        self.place = match self.place.as_str() {
            "" => part.to_owned(),
            inner => format!("{part}.{inner}"),
        };
        self
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.line, self.column) {
            (Some(line), Some(column)) => {
                f.write_str(&tr!("line {line}, column {column}: ", line, column))?;
            }
            (Some(line), None) => f.write_str(&tr!("line {line}: ", line))?,
            _ => {}
        }
        if !self.place.is_empty() {
            write!(f, "{}: ", self.place)?;
        }
        f.write_str(&tr!(
            "found {found}, expected {expected}",
            found = self.found,
            expected = self.expected
        ))
    }
}

impl std::error::Error for Fault {}
