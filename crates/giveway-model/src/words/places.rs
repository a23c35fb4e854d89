//! The places of a sentence, `{name}`: that they fit their values is checked when a `tr!`
//! is compiled, and they are filled when it is said.

use std::fmt::{Display, Write as _};

/// A value of a sentence: one with letters that are written from right to left stands between
/// marks of its own, so that it does not turn round what stands beside it (Unicode UAX 9).
fn isolated(value: String) -> String {
    const FIRST: char = '\u{590}';
    let turns = |letter: char| {
        letter >= FIRST
            && matches!(letter, '\u{590}'..='\u{8ff}' | '\u{fb1d}'..='\u{fdff}' | '\u{fe70}'..='\u{fefc}'
                | '\u{10800}'..='\u{10fff}' | '\u{1e800}'..='\u{1efff}')
    };
    if value.chars().any(turns) && !value.contains('\u{2068}') {
        format!("\u{2068}{value}\u{2069}")
    } else {
        value
    }
}

/// A form with values in its places. `named` is the English text, whose places tell
/// which name is which value; where things are counted, `n` is the first value.
pub(super) fn filled(form: &str, named: &str, values: &[&dyn Display], is_counted: bool) -> String {
    let mut names: Vec<&str> = Vec::with_capacity(values.len());
    if is_counted {
        names.push("n");
    }
    for (_, name) in places(named) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let mut told = String::with_capacity(form.len() + 16);
    let mut rest = form;
    for (before, name) in places(form) {
        told.push_str(before);
        // A place that the English text does not have stands as it is: a test keeps
        // catalogues free of them.
        match names.iter().position(|other| *other == name) {
            Some(i) if i < values.len() => told.push_str(&isolated(values[i].to_string())),
            _ => drop(write!(told, "{{{name}}}")),
        }
        rest = &rest[before.len() + name.len() + 2..];
    }
    told.push_str(rest);
    told
}

/// The places `{name}` of a text, each with the text before it.
pub(super) fn places(text: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let (before, behind) = rest.split_once('{')?;
        let (name, after) = behind.split_once('}')?;
        rest = after;
        Some((before, name))
    })
}

/// A text whose places are these names in this order; no other compiles.
pub const fn checked(key: &'static str, names: &[&str]) -> &'static str {
    assert!(
        fits(key, names, 0),
        "each place has its value, in the order of the text"
    );
    key
}

/// A text and the one for more, whose places are these names in this order, but for the
/// first, which is the number.
pub const fn checked_forms(
    key: &'static str,
    plural: &'static str,
    names: &[&str],
) -> (&'static str, &'static str) {
    assert!(
        fits(plural, names, 1),
        "each place has its value, in the order of the text"
    );
    assert!(
        is_within(key, names),
        "the form for one has no place of its own"
    );
    (key, plural)
}

/// Whether the places of a text, each at its first mention, are these names in this
/// order, behind so many that may stand anywhere.
const fn fits(text: &str, names: &[&str], anywhere: usize) -> bool {
    let text = text.as_bytes();
    let (mut i, mut seen) = (0, anywhere);
    while i < text.len() {
        if text[i] != b'{' {
            i += 1;
            continue;
        }
        let from = i + 1;
        while i < text.len() && text[i] != b'}' {
            i += 1;
        }
        if is_among(text, from, i, names, seen) {
            continue;
        }
        if seen >= names.len() || !is_name(text, from, i, names[seen]) {
            return false;
        }
        seen += 1;
    }
    seen == names.len()
}

/// Whether every place of a text is one of the names.
const fn is_within(text: &str, names: &[&str]) -> bool {
    let text = text.as_bytes();
    let mut i = 0;
    while i < text.len() {
        if text[i] == b'{' {
            let from = i + 1;
            while i < text.len() && text[i] != b'}' {
                i += 1;
            }
            if !is_among(text, from, i, names, names.len()) {
                return false;
            }
        }
        i += 1;
    }
    true
}

const fn is_among(text: &[u8], from: usize, to: usize, names: &[&str], seen: usize) -> bool {
    let mut i = 0;
    while i < seen {
        if is_name(text, from, to, names[i]) {
            return true;
        }
        i += 1;
    }
    false
}

const fn is_name(text: &[u8], from: usize, to: usize, name: &str) -> bool {
    let name = name.as_bytes();
    if to - from != name.len() {
        return false;
    }
    let mut i = 0;
    while i < name.len() {
        if text[from + i] != name[i] {
            return false;
        }
        i += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::{fits, is_within};

    #[test]
    fn places_are_those_of_the_values_in_their_order() {
        assert!(fits("{a} and {b} and {a}", &["a", "b"], 0));
        assert!(fits("{n} of {a}", &["n", "a"], 1));
        assert!(fits("nothing", &[], 0));
        assert!(!fits("{b} and {a}", &["a", "b"], 0));
        assert!(!fits("{a}", &["a", "b"], 0));
        assert!(!fits("{a} and {b}", &["a"], 0));
        assert!(!fits("{ab}", &["a"], 0));
        assert!(is_within("one of {a}", &["n", "a"]));
        assert!(!is_within("one of {b}", &["n", "a"]));
    }
}
