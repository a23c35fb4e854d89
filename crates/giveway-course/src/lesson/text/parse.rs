//! Reads the markup of a paragraph.
//!
//! `*words*` is emphasis, `[words](robot:A1)` a link to a robot, and `cell:3,1`,
//! `term:makespan`, `time:3` are those to other things. A backslash takes the meaning
//! from the sign behind it.

use std::fmt;
use std::iter::Peekable;
use std::str::{CharIndices, FromStr};

use giveway_model::{Cell, tr};

use super::{MAX_CHARACTERS, Span, Target, Text};

/// What is wrong with the markup of a paragraph, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MarkupError {
    /// The character, from 1.
    pub at: usize,
    /// What was found, as a phrase.
    pub found: String,
    /// What was expected, as a phrase.
    pub expected: &'static str,
}

impl fmt::Display for MarkupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            at,
            found,
            expected,
        } = self;
        // In the words that a reader of JSON tells apart.
        let found = tr!("{found} at character {at}", found, at);
        write!(f, "found {found}, expected {expected}")
    }
}

impl std::error::Error for MarkupError {}

impl FromStr for Text {
    type Err = MarkupError;

    fn from_str(source: &str) -> Result<Self, MarkupError> {
        let length = source.chars().count();
        if length > MAX_CHARACTERS {
            let found = tr!("a paragraph of {length} characters", length);
            return Err(error(MAX_CHARACTERS, found, tr!("at most 1200")));
        }
        let mut reader = Reader {
            source,
            rest: source.char_indices().peekable(),
        };
        reader.paragraph().map(Self)
    }
}

fn error(at: usize, found: impl Into<String>, expected: &'static str) -> MarkupError {
    MarkupError {
        at,
        found: found.into(),
        expected,
    }
}

struct Reader<'a> {
    source: &'a str,
    rest: Peekable<CharIndices<'a>>,
}

impl Reader<'_> {
    fn paragraph(&mut self) -> Result<Vec<Span>, MarkupError> {
        let mut spans = Vec::new();
        let mut plain = String::new();
        while let Some((byte, c)) = self.rest.next() {
            match c {
                '*' => {
                    push_plain(&mut spans, &mut plain);
                    let words = self.until('*', byte, tr!("a closing *"))?;
                    spans.push(Span::Emphasis(self.filled(words, byte)?));
                }
                '[' => {
                    push_plain(&mut spans, &mut plain);
                    spans.push(self.link(byte)?);
                }
                ']' => {
                    return Err(error(
                        self.at(byte),
                        tr!("a ] alone"),
                        tr!("a [ before it, or \\]"),
                    ));
                }
                '<' if self.begins_tag() => {
                    return Err(error(self.at(byte), "HTML", tr!("plain text, or \\<")));
                }
                '\\' => plain.push(self.escaped(byte)?),
                c if c.is_control() => {
                    return Err(error(
                        self.at(byte),
                        tr!("a control character"),
                        tr!("one line of text"),
                    ));
                }
                c => plain.push(c),
            }
        }
        push_plain(&mut spans, &mut plain);
        Ok(spans)
    }

    fn link(&mut self, begin: usize) -> Result<Span, MarkupError> {
        let label = self.until(']', begin, tr!("a closing ]"))?;
        let label = self.filled(label, begin)?;
        let at = self.at(begin);
        if self.rest.next_if(|(_, c)| *c == '(').is_none() {
            return Err(error(
                at,
                tr!("[words] alone"),
                tr!("what they name, as (robot:A1)"),
            ));
        }
        let source = self.until(')', begin, tr!("a closing )"))?;
        match target(&source) {
            Some(target) => Ok(Span::Link { label, target }),
            None => Err(error(
                at,
                tr!(
                    "a link to {what}",
                    what = format!("{:?}", source.chars().take(40).collect::<String>())
                ),
                tr!("robot:NAME, cell:X,Y, term:TERM or time:N"),
            )),
        }
    }

    /// The text up to a sign, which is taken, too.
    fn until(
        &mut self,
        end: char,
        begin: usize,
        expected: &'static str,
    ) -> Result<String, MarkupError> {
        let mut words = String::new();
        while let Some((byte, c)) = self.rest.next() {
            match c {
                c if c == end => return Ok(words),
                '\\' => words.push(self.escaped(byte)?),
                '*' | '[' => {
                    return Err(error(
                        self.at(byte),
                        tr!("a {sign} within words", sign = c),
                        expected,
                    ));
                }
                '<' if self.begins_tag() => {
                    return Err(error(self.at(byte), "HTML", tr!("plain text, or \\<")));
                }
                c if c.is_control() => {
                    return Err(error(
                        self.at(byte),
                        tr!("a control character"),
                        tr!("one line of text"),
                    ));
                }
                c => words.push(c),
            }
        }
        Err(error(self.at(begin), tr!("the end of the text"), expected))
    }

    fn filled(&self, words: String, begin: usize) -> Result<String, MarkupError> {
        if words.trim().is_empty() {
            return Err(error(self.at(begin), tr!("no words"), tr!("at least one")));
        }
        Ok(words)
    }

    fn escaped(&mut self, begin: usize) -> Result<char, MarkupError> {
        match self.rest.next() {
            Some((_, c)) if c.is_ascii_punctuation() => Ok(c),
            _ => Err(error(
                self.at(begin),
                tr!("a backslash alone"),
                tr!("a sign behind it, such as \\*"),
            )),
        }
    }

    fn begins_tag(&mut self) -> bool {
        let next = self.rest.peek();
        next.is_some_and(|(_, c)| c.is_ascii_alphabetic() || matches!(c, '/' | '!' | '?'))
    }

    /// The number of the character at a byte, from 1.
    fn at(&self, byte: usize) -> usize {
        let before = self.source.get(..byte).unwrap_or_default();
        before.chars().count() + 1
    }
}

fn push_plain(spans: &mut Vec<Span>, plain: &mut String) {
    if !plain.is_empty() {
        spans.push(Span::Plain(std::mem::take(plain)));
    }
}

fn target(source: &str) -> Option<Target> {
    let (kind, name) = source.split_once(':')?;
    match kind {
        "robot" if !name.is_empty() => Some(Target::Robot(name.to_owned())),
        "cell" => {
            let (x, y) = name.split_once(',')?;
            Some(Target::Cell(Cell::new(number(x)?, number(y)?)))
        }
        "term" => name.parse().ok().map(Target::Term),
        "time" => number(name).map(Target::Time),
        _ => None,
    }
}

/// A number in the one way in which it is written.
fn number(digits: &str) -> Option<u32> {
    let number: u32 = digits.parse().ok()?;
    (number.to_string() == digits).then_some(number)
}
