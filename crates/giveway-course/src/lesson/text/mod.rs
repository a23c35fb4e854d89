//! The text of a lesson: a paragraph as a small tree.
//!
//! There is emphasis, and there are links to a robot, a cell, a term and a time; there
//! is nothing else, and no HTML.

mod parse;
mod written;

use std::borrow::Cow;
use std::fmt;

use giveway_model::Cell;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

pub use parse::MarkupError;

use super::Id;

/// The most characters of a paragraph, as it is written.
pub const MAX_CHARACTERS: usize = 1200;

/// A paragraph.
///
/// ```
/// use giveway_course::lesson::{Span, Text};
/// let text: Text = "In the *corridor* [A1](robot:A1) waits.".parse().unwrap();
/// assert_eq!(text.spans()[1], Span::Emphasis("corridor".into()));
/// assert_eq!(text.plain(), "In the corridor A1 waits.");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text(Vec<Span>);

/// A part of a paragraph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Span {
    /// Words.
    Plain(String),
    /// Words that matter.
    Emphasis(String),
    /// Words that name something.
    Link {
        /// The words.
        label: String,
        /// What they name.
        target: Target,
    },
}

/// What words name: it is lit, opened or gone to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// A robot, by its name.
    Robot(String),
    /// A cell.
    Cell(Cell),
    /// A term of the glossary.
    Term(Id),
    /// A time, in steps from 0.
    Time(u32),
}

impl Text {
    /// A paragraph of parts; what follows each other as plain words is joined.
    pub(crate) fn of(spans: Vec<Span>) -> Self {
        let mut joined: Vec<Span> = Vec::new();
        for span in spans {
            match (joined.last_mut(), span) {
                (_, span) if span.words().is_empty() => {}
                (Some(Span::Plain(before)), Span::Plain(words)) => before.push_str(&words),
                (_, span) => joined.push(span),
            }
        }
        Self(joined)
    }

    /// The first sentences of some paragraphs, as one.
    ///
    /// ```
    /// use giveway_course::lesson::Text;
    /// let text = |words: &str| -> Text { words.parse().unwrap() };
    /// let all = [text("One [A1](robot:A1)."), text("Two at 1.5? Three.")];
    /// assert_eq!(Text::opening(&all, 2).plain(), "One A1. Two at 1.5?");
    /// assert_eq!(Text::opening(&all, 9).plain(), "One A1. Two at 1.5? Three.");
    /// ```
    #[must_use]
    pub fn opening(texts: &[Self], sentences: usize) -> Self {
        let mut spans = Vec::new();
        let mut left = sentences;
        for text in texts.iter().filter(|text| !text.is_empty()) {
            if !spans.is_empty() {
                spans.push(Span::Plain(" ".to_owned()));
            }
            for span in text.spans() {
                let Span::Plain(words) = span else {
                    spans.push(span.clone());
                    continue;
                };
                let (kept, ended) = first(words, left);
                left -= ended;
                spans.push(Span::Plain(kept.to_owned()));
                if left == 0 {
                    return Self::of(spans);
                }
            }
        }
        Self::of(spans)
    }

    /// Its parts. No two plain ones follow each other, and none is empty.
    pub fn spans(&self) -> &[Span] {
        &self.0
    }

    /// Its words alone, as they are read aloud.
    pub fn plain(&self) -> String {
        self.0.iter().map(Span::words).collect()
    }

    /// What its links name, in order.
    pub fn targets(&self) -> impl Iterator<Item = &Target> {
        self.0.iter().filter_map(|span| match span {
            Span::Link { target, .. } => Some(target),
            Span::Plain(_) | Span::Emphasis(_) => None,
        })
    }

    /// Whether its links name the same things as those of another text, in any order.
    pub fn names_the_same_as(&self, other: &Self) -> bool {
        let mut left: Vec<&Target> = other.targets().collect();
        let mut own = self.targets();
        let is_within = own.all(|target| {
            let found = left.iter().position(|other| *other == target);
            found.map(|index| left.swap_remove(index)).is_some()
        });
        is_within && left.is_empty()
    }

    /// Whether there is nothing to read.
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(|span| span.words().trim().is_empty())
    }
}

/// The first sentences of some words, and how many end in them.
fn first(words: &str, sentences: usize) -> (&str, usize) {
    let mut ended = 0;
    for (at, _) in words.match_indices(['.', '?', '!']) {
        let rest = &words[at + 1..];
        ended += usize::from(rest.is_empty() || rest.starts_with(' '));
        if ended == sentences {
            return (&words[..=at], ended);
        }
    }
    (words, ended)
}

impl Span {
    /// Its words.
    pub fn words(&self) -> &str {
        match self {
            Self::Plain(words) | Self::Emphasis(words) | Self::Link { label: words, .. } => words,
        }
    }
}

impl fmt::Display for Text {
    /// As it is written in a file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&written::write(&self.0))
    }
}

impl Serialize for Text {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Text {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let source = Cow::<str>::deserialize(deserializer)?;
        source.parse().map_err(de::Error::custom)
    }
}
