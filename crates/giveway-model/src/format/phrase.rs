//! The JSON library's messages as phrases for people.
//!
//! The library gives its reasons as text only, so they are told apart by their
//! words; one that is not known here is passed on as it is.

use super::text::shorten;

/// What was found and what was expected.
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
        "EOF while parsing a list" => phrase("the end of the file inside a list", "a closing ]"),
        "EOF while parsing an object" => {
            phrase("the end of the file inside an object", "a closing }")
        }
        "EOF while parsing a string" => {
            phrase("the end of the file inside a text", "a closing quote")
        }
        "EOF while parsing a value" => phrase("the end of the file", "a value"),
        "expected value" | "expected ident" if whole => phrase(found, "a JSON object"),
        "expected value" | "expected ident" => phrase(found, "a JSON value"),
        "expected `:`" => phrase(found, "a colon after the key"),
        "expected `,` or `]`" => phrase(found, "a comma or a closing ]"),
        "expected `,` or `}`" => phrase(found, "a comma or a closing }"),
        "key must be a string" => phrase(found, "a key in double quotes"),
        "trailing comma" => phrase("a comma after the last entry", "no comma there"),
        "trailing characters" => phrase(found, "the end of the file"),
        "invalid escape" => phrase(
            "an unknown escape in a text",
            "one that JSON has, such as \\n",
        ),
        "invalid number" => phrase("a number written in a wrong way", "one such as 12"),
        "number out of range" => phrase("a number that is too large", "a smaller one"),
        "recursion limit exceeded" => phrase(
            "lists or objects nested very deeply",
            "the few levels of the format",
        ),
        _ if message.starts_with("control character") => phrase(
            "a line break or another control character inside a text",
            "a closing quote before it",
        ),
        other => phrase(shorten(other), "well-formed JSON"),
    }
}

/// The first character of a text, as a phrase.
fn character(rest: &str) -> String {
    match rest.chars().next() {
        None => "the end of the file".to_owned(),
        Some('\n' | '\r') => "the end of the line".to_owned(),
        Some('"') => "a double quote".to_owned(),
        Some(c) if c.is_control() => format!("the control character U+{:04X}", c as u32),
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
        return phrase(format!("no key \"{key}\""), "one here");
    }
    if let Some(key) = message.strip_prefix("duplicate field ") {
        let key = shorten(key.trim_matches('`'));
        return phrase(format!("the key \"{key}\" again"), "each key once");
    }
    let Some((found, expected)) = message.rsplit_once(", expected ") else {
        return phrase(shorten(message), "what the format describes");
    };
    let expected = expectation(expected);
    if let Some(key) = found.strip_prefix("unknown field ") {
        let key = shorten(key.trim_matches('`'));
        return phrase(format!("the unknown key \"{key}\""), expected);
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
        None if found == "map" => "an object".to_owned(),
        None if found == "sequence" => "a list".to_owned(),
        Some(("boolean", word)) => word.trim_matches('`').to_owned(),
        Some(("integer", number)) => format!("the number {}", number.trim_matches('`')),
        Some(("floating", number)) => {
            let number = number.trim_start_matches("point ").trim_matches('`');
            format!("the number {number}")
        }
        Some(("string", text)) => format!("the text \"{}\"", shorten(text.trim_matches('"'))),
        Some(("invalid", length)) => match length.trim_start_matches("length ") {
            "0" => "an empty list".to_owned(),
            "1" => "a list of one".to_owned(),
            length => format!("a list of {length}"),
        },
        _ if found.starts_with('`') => format!("\"{}\"", shorten(found.trim_matches('`'))),
        _ => shorten(found),
    }
}

/// What the library expects, as a phrase.
fn expectation(expected: &str) -> String {
    match expected {
        "u32" | "u64" => format!("a whole number from 0 to {}", u32::MAX),
        "i32" => format!("a whole number from {} to {}", i32::MIN, i32::MAX),
        "a string" => "a text in double quotes".to_owned(),
        "a sequence" => "a list".to_owned(),
        "a map" => "an object".to_owned(),
        "struct Battery" => "an object with capacity and initial".to_owned(),
        "struct Written" => "an object with at and change".to_owned(),
        "struct Agent" => "an object with name, start and goal".to_owned(),
        other if other.starts_with("struct ") => "an object".to_owned(),
        other => other.replace('`', ""),
    }
}
