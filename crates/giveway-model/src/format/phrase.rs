//! The JSON library's messages as phrases for people.
//!
//! The library gives its reasons as text only, so they are told apart by their
//! words; one that is not known here is passed on as it is. Its words are English in
//! every language, so that they can be told apart; what is made of them is not.

use super::text::shorten;
use crate::words::{Later, retold};
use crate::{tr, tr_later};

/// Phrases that come within a message, as values of this project's types say them.
const KNOWN: [Later; 10] = [
    tr_later!("{what} twice"),
    tr_later!("each cost once"),
    tr_later!("each robot once"),
    tr_later!("version {number} of the format"),
    tr_later!("version {number}, the only one known here"),
    tr_later!("small letters, digits and hyphens, at most {most}"),
    tr_later!("a boolean"),
    tr_later!("a number from {least} to {most}"),
    tr_later!("one of {names}"),
    tr_later!("{names} or {last}"),
];

/// Found, and expected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Phrase {
    pub(super) found: String,
    pub(super) expected: String,
}

fn phrase(found: impl Into<String>, expected: impl Into<String>) -> Phrase {
    Phrase {
        found: found.into(),
        expected: expected.into(),
    }
}

/// For text that is no JSON: the message, the text from the fault on, and
/// whether that is all of it.
pub(super) fn of_syntax(message: &str, rest: &str, whole: bool) -> Phrase {
    let found = character(rest);
    match message {
        "EOF while parsing a list" => {
            phrase(tr!("the end of the file inside a list"), tr!("a closing ]"))
        }
        "EOF while parsing an object" => phrase(
            tr!("the end of the file inside an object"),
            tr!("a closing }"),
        ),
        "EOF while parsing a string" => phrase(
            tr!("the end of the file inside a text"),
            tr!("a closing quote"),
        ),
        "EOF while parsing a value" => phrase(tr!("the end of the file"), tr!("a value")),
        "expected value" | "expected ident" if whole => phrase(found, tr!("a JSON object")),
        "expected value" | "expected ident" => phrase(found, tr!("a JSON value")),
        "expected `:`" => phrase(found, tr!("a colon after the key")),
        "expected `,` or `]`" => phrase(found, tr!("a comma or a closing ]")),
        "expected `,` or `}`" => phrase(found, tr!("a comma or a closing }")),
        "key must be a string" => phrase(found, tr!("a key in double quotes")),
        "trailing comma" => phrase(tr!("a comma after the last entry"), tr!("no comma there")),
        "trailing characters" => phrase(found, tr!("the end of the file")),
        "invalid escape" => phrase(
            tr!("an unknown escape in a text"),
            tr!("one that JSON has, such as \\n"),
        ),
        "invalid number" => phrase(
            tr!("a number written in a wrong way"),
            tr!("one such as 12"),
        ),
        "number out of range" => phrase(tr!("a number that is too large"), tr!("a smaller one")),
        "recursion limit exceeded" => phrase(
            tr!("lists or objects nested very deeply"),
            tr!("the few levels of the format"),
        ),
        _ if message.starts_with("control character") => phrase(
            tr!("a line break or another control character inside a text"),
            tr!("a closing quote before it"),
        ),
        other => phrase(shorten(other), tr!("well-formed JSON")),
    }
}

/// The first character of a text, as a phrase.
fn character(rest: &str) -> String {
    match rest.chars().next() {
        None => tr!("the end of the file").to_owned(),
        Some('\n' | '\r') => tr!("the end of the line").to_owned(),
        Some('"') => tr!("a double quote").to_owned(),
        Some(c) if c.is_control() => tr!(
            "the control character U+{code}",
            code = format!("{:04X}", c as u32)
        ),
        Some(c) => format!("\"{c}\""),
    }
}

/// The key that a message is about, when it is unknown or repeated.
pub(super) fn key_of(message: &str) -> Option<&str> {
    let rest = message.strip_prefix("unknown field `").map(|rest| {
        rest.rsplit_once("`, expected ")
            .map_or(rest, |(key, _)| key)
    });
    rest.or_else(|| message.strip_prefix("duplicate field `")?.strip_suffix('`'))
        .or_else(|| {
            let rest = message.strip_prefix("found \"")?;
            rest.strip_suffix("\" twice, expected each robot once")
        })
}

/// For JSON that is not of the format.
pub(super) fn of_data(message: &str) -> Phrase {
    if let Some(key) = message.strip_prefix("missing field ") {
        let key = key.trim_matches('`');
        return phrase(tr!("no key \"{key}\"", key), tr!("one here"));
    }
    if let Some(key) = message.strip_prefix("duplicate field ") {
        let key = shorten(key.trim_matches('`'));
        return phrase(tr!("the key \"{key}\" again", key), tr!("each key once"));
    }
    let Some((found, expected)) = message.rsplit_once(", expected ") else {
        return phrase(shorten(message), tr!("what the format describes"));
    };
    let expected = expectation(expected);
    if let Some(key) = found.strip_prefix("unknown field ") {
        let key = shorten(key.trim_matches('`'));
        return phrase(tr!("the unknown key \"{key}\"", key), expected);
    }
    let found = found
        .strip_prefix("invalid type: ")
        .or_else(|| found.strip_prefix("invalid value: "))
        .or_else(|| found.strip_prefix("found "))
        .or_else(|| found.strip_prefix("unknown variant "))
        .unwrap_or(found);
    phrase(value(found), expected)
}

/// A value that the library names, as a phrase.
fn value(found: &str) -> String {
    match found.split_once(' ') {
        None if found == "map" => tr!("an object").to_owned(),
        None if found == "sequence" => tr!("a list").to_owned(),
        Some(("boolean", word)) => word.trim_matches('`').to_owned(),
        Some(("integer", number)) => tr!("the number {number}", number = number.trim_matches('`')),
        Some(("floating", number)) => {
            let number = number.trim_start_matches("point ").trim_matches('`');
            tr!("the number {number}", number)
        }
        Some(("string", text)) => tr!(
            "the text \"{text}\"",
            text = shorten(text.trim_matches('"'))
        ),
        Some(("invalid", length)) => match length.trim_start_matches("length ") {
            "0" => tr!("an empty list").to_owned(),
            "1" => tr!("a list of one").to_owned(),
            length => tr!("a list of {length}", length),
        },
        _ if found.starts_with('`') => format!("\"{}\"", shorten(found.trim_matches('`'))),
        _ => shorten(&retold(found, &KNOWN)),
    }
}

/// The library's expectation as a phrase.
fn expectation(expected: &str) -> String {
    match expected {
        "u32" => tr!("a whole number from 0 to {most}", most = u32::MAX),
        "u64" | "usize" => tr!("a whole number from 0").to_owned(),
        "f64" => tr!("a number").to_owned(),
        "i32" => tr!(
            "a whole number from {least} to {most}",
            least = i32::MIN,
            most = i32::MAX
        ),
        "a string" => tr!("a text in double quotes").to_owned(),
        "a sequence" => tr!("a list").to_owned(),
        "a map" => tr!("an object").to_owned(),
        "struct Battery" => tr!("an object with capacity and initial").to_owned(),
        "struct Written" => tr!("an object with at and change").to_owned(),
        "struct Agent" => tr!("an object with name and start").to_owned(),
        other if other.starts_with("struct ") => tr!("an object").to_owned(),
        other => retold(&other.replace('`', ""), &KNOWN),
    }
}
