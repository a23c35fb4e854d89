//! Questions as a person types them: `wait A2 --at 3,1 --from 0 --to 2`.

use std::fmt::{self, Write as _};
use std::str::FromStr;

use super::Question;
use super::asked::{Asked, KINDS};
use crate::{Cell, Fault, tr};

/// Why words are no question; told as a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WordsError {
    /// The first word, which may be empty, is no kind of question.
    Kind(String),
    /// Something else is wrong: a sentence.
    Sentence(String),
}

impl WordsError {
    /// Found, and expected.
    pub fn fault(self) -> Fault {
        match self {
            Self::Kind(kind) => {
                let expected = format!("one of {}", KINDS.join(", "));
                Fault::at("question", quoted(&kind), expected)
            }
            Self::Sentence(sentence) => {
                let found = format!("words that ask nothing: {}", sentence.trim_end_matches('.'));
                Fault::at("question", found, "words as `giveway explain` takes them")
            }
        }
    }
}

fn quoted(kind: &str) -> String {
    match kind {
        "" => "no question".to_owned(),
        kind => format!("\"{kind}\""),
    }
}

impl fmt::Display for WordsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Kind(kind) => {
                let kinds = KINDS.join(", ");
                f.write_str(&if kind.is_empty() {
                    tr!("Found no question, expected one of {kinds}.", kinds)
                } else {
                    tr!("Found \"{kind}\", expected one of {kinds}.", kind, kinds)
                })
            }
            Self::Sentence(sentence) => f.write_str(sentence),
        }
    }
}

impl std::error::Error for WordsError {}

/// Reads a question from the words that a person typed.
///
/// # Errors
/// A sentence: the kind is none, an agent or an option is missing, is too many
/// or cannot be read.
///
/// ```
/// use giveway_model::question::{from_words, to_words};
/// let typed = "yield A1 A2 --at 3,1";
/// let words: Vec<&str> = typed.split(' ').collect();
/// assert_eq!(to_words(&from_words(&words).unwrap()), typed);
/// assert!(from_words(&["why"]).is_err());
/// ```
pub fn from_words<S: AsRef<str>>(words: &[S]) -> Result<Question, WordsError> {
    let mut words = words.iter().map(AsRef::as_ref);
    let mut asked = Asked {
        kind: words.next().unwrap_or_default().to_owned(),
        ..Asked::default()
    };
    while let Some(word) = words.next() {
        let Some(option) = word.strip_prefix("--") else {
            asked.agents.push(word.to_owned());
            continue;
        };
        let value = words.next().ok_or_else(|| {
            WordsError::Sentence(tr!("Found --{option} without a value.", option))
        })?;
        asked.set(option, value)?;
    }
    asked.question()
}

/// The shortest words for a question: what [`from_words`] reads. (A name with
/// blanks would have to be quoted.)
pub fn to_words(question: &Question) -> String {
    let asked = Asked::of(question);
    let mut words = asked.kind.clone();
    for agent in &asked.agents {
        let _ = write!(words, " {agent}");
    }
    for (option, value) in asked.options() {
        let _ = write!(words, " --{option} {value}");
    }
    words
}

impl Asked {
    /// Takes an option in: its name without `--`, and its value as it is typed.
    ///
    /// # Errors
    /// A sentence: there is no such option, or the value cannot be read.
    pub fn set(&mut self, option: &str, value: &str) -> Result<(), WordsError> {
        let cell = |place: &mut Option<Cell>| {
            *place =
                Some(read_cell(value).ok_or_else(|| unread(option, value, tr!("a cell X,Y")))?);
            Ok(())
        };
        let number = |place: &mut Option<u32>| {
            let read = u32::from_str(value);
            *place = Some(read.map_err(|_| unread(option, value, tr!("a whole number")))?);
            Ok(())
        };
        match option {
            "at" => cell(&mut self.at),
            "from-cell" => cell(&mut self.from_cell),
            "to-cell" => cell(&mut self.to_cell),
            "first" => cell(&mut self.first),
            "second" => cell(&mut self.second),
            "from" => number(&mut self.from),
            "to" => number(&mut self.to),
            "time" => number(&mut self.time),
            "at-least" => number(&mut self.at_least),
            "fewer-than" => number(&mut self.fewer_than),
            _ => Err(WordsError::Sentence(tr!(
                "There is no option --{option}.",
                option
            ))),
        }
    }

    /// The options that are given, with their values, in a fixed order.
    pub fn options(&self) -> Vec<(&'static str, String)> {
        let cell = |cell: Option<Cell>| cell.map(|cell| format!("{},{}", cell.x, cell.y));
        let number = |number: Option<u32>| number.map(|number| number.to_string());
        [
            ("at", cell(self.at)),
            ("from-cell", cell(self.from_cell)),
            ("to-cell", cell(self.to_cell)),
            ("first", cell(self.first)),
            ("second", cell(self.second)),
            ("from", number(self.from)),
            ("to", number(self.to)),
            ("time", number(self.time)),
            ("at-least", number(self.at_least)),
            ("fewer-than", number(self.fewer_than)),
        ]
        .into_iter()
        .filter_map(|(option, value)| Some((option, value?)))
        .collect()
    }
}

fn unread(option: &str, value: &str, expected: &str) -> WordsError {
    WordsError::Sentence(tr!(
        "--{option}: found \"{value}\", expected {expected}.",
        option,
        value,
        expected
    ))
}

/// Reads `3,1`, or `(3, 1)` as sentences write it.
fn read_cell(text: &str) -> Option<Cell> {
    let text = text.trim();
    let bare = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let (x, y) = bare.unwrap_or(text).split_once(',')?;
    let read = |number: &str| number.trim().parse().ok();
    Some(Cell::new(read(x)?, read(y)?))
}

impl FromStr for Cell {
    type Err = WordsError;

    /// Reads `3,1`.
    fn from_str(text: &str) -> Result<Self, WordsError> {
        let unread = || WordsError::Sentence(format!("found \"{text}\", expected a cell X,Y"));
        read_cell(text).ok_or_else(unread)
    }
}
