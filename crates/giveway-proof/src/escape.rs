//! Names of agents and instances in sentences, made safe: nothing that a person
//! wrote into a file may look like a sentence of this program, break a line, or
//! steer a terminal.

/// A name as it may stand in a sentence: as it is where it is a plain word, else
/// in quotes, with escapes.
pub(crate) fn name(name: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    if !name.is_empty() && name.chars().all(plain) {
        name.to_owned()
    } else {
        format!("{name:?}")
    }
}

/// Text without control characters, and without those that turn the direction of
/// writing: each as an escape.
pub(crate) fn text(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        if c.is_control() || turns {
            out.extend(c.escape_unicode());
        } else {
            out.push(c);
        }
    }
    out
}

/// Text in which no mark of Markdown is one.
pub(crate) fn markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in self::text(text).chars() {
        if matches!(
            c,
            '\\' | '*' | '`' | '_' | '<' | '>' | '[' | ']' | '#' | '|'
        ) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_words_or_quoted() {
        assert_eq!(name("A1"), "A1");
        assert_eq!(name("b-2.x"), "b-2.x");
        assert_eq!(name("A arrives"), "\"A arrives\"");
        assert_eq!(name("a\u{1b}[2K\n"), "\"a\\u{1b}[2K\\n\"");
        assert_eq!(name(""), "\"\"");
    }

    #[test]
    fn nothing_breaks_a_line() {
        assert_eq!(text("a\nb\u{202e}"), "a\\u{a}b\\u{202e}");
        assert_eq!(markdown("a `b`"), "a \\`b\\`");
    }
}
