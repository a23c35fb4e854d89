//! The words of a rule, one by one.

use std::fmt;

/// The words with which rules are said. A robot of such a name stands in quotes.
const KEYWORDS: [&str; 31] = [
    "all", "always", "and", "any", "arrives", "at", "before", "by", "each", "for", "from", "in",
    "is", "never", "no", "none", "not", "of", "on", "once", "one", "robot", "robots", "step",
    "steps", "then", "to", "until", "up", "waits", "way",
];

/// A word of a rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    /// Letters.
    Word(String),
    /// A whole number.
    Number(u32),
    /// A name in single quotes.
    Quoted(String),
    /// `,`, `(`, `)` or what else stands alone.
    Mark(char),
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => write!(f, "\"{word}\""),
            Self::Number(number) => number.fmt(f),
            Self::Quoted(name) => write!(f, "'{name}'"),
            Self::Mark(mark) => write!(f, "\"{mark}\""),
        }
    }
}

/// Whether a name of a robot needs no quotes: it is one word, and no other word of a rule.
pub(super) fn is_plain_name(name: &str) -> bool {
    name.chars().all(is_of_word)
        && name.contains(|c: char| !c.is_ascii_digit())
        && name.ends_with(|c: char| c.is_alphanumeric())
        && !KEYWORDS.contains(&name.to_ascii_lowercase().as_str())
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | '#' | '/')
}

/// Takes a text apart. A number that is too large for any rule is a word.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = text.trim().trim_end_matches('.');
    while let Some(first) = rest.chars().next() {
        let (token, length) = if first == '\'' {
            quoted(rest)
        } else if is_of_word(first) {
            let end = rest.find(|c: char| !is_of_word(c)).unwrap_or(rest.len());
            let word = rest.get(..end).unwrap_or(rest);
            let number = word.parse().map(Token::Number);
            let token = number.unwrap_or_else(|_| Token::Word(word.to_owned()));
            (Some(token), end)
        } else {
            let token = (!first.is_whitespace()).then_some(Token::Mark(first));
            (token, first.len_utf8())
        };
        tokens.extend(token);
        rest = rest.get(length..).unwrap_or_default();
    }
    tokens
}

/// A name in quotes at the begin of a text, and how long it is there. A quote without its
/// end stands alone.
fn quoted(text: &str) -> (Option<Token>, usize) {
    let mut name = String::new();
    let mut chars = text.char_indices().skip(1).peekable();
    while let Some((at, c)) = chars.next() {
        // A quote of its own is doubled.
        let is_end = c == '\'' && chars.next_if(|&(_, next)| next == '\'').is_none();
        if is_end {
            return (Some(Token::Quoted(name)), at + 1);
        }
        name.push(c);
    }
    (Some(Token::Mark('\'')), 1)
}
