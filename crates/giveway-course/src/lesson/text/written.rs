//! Writes a paragraph as its markup, so that it reads back the same.

use std::fmt::Write as _;

use super::{Span, Target};

pub(super) fn write(spans: &[Span]) -> String {
    let mut text = String::new();
    for span in spans {
        match span {
            Span::Plain(words) => escape(&mut text, words, false),
            Span::Emphasis(words) => {
                text.push('*');
                escape(&mut text, words, false);
                text.push('*');
            }
            Span::Link { label, target } => {
                text.push('[');
                escape(&mut text, label, false);
                text.push_str("](");
                write_target(&mut text, target);
                text.push(')');
            }
        }
    }
    text
}

fn write_target(text: &mut String, target: &Target) {
    // Writing into a string never fails.
    let _ = match target {
        Target::Robot(name) => {
            text.push_str("robot:");
            escape(text, name, true);
            Ok(())
        }
        Target::Cell(cell) => write!(text, "cell:{},{}", cell.x, cell.y),
        Target::Term(term) => write!(text, "term:{term}"),
        Target::Time(time) => write!(text, "time:{time}"),
    };
}

fn escape(text: &mut String, words: &str, in_target: bool) {
    let mut chars = words.chars().peekable();
    while let Some(c) = chars.next() {
        let next = chars.peek();
        let begins_tag = |c: &char| c.is_ascii_alphabetic() || matches!(c, '/' | '!' | '?');
        let is_tag = c == '<' && next.is_some_and(begins_tag);
        if is_tag || matches!(c, '*' | '[' | ']' | '\\') || (c == ')' && in_target) {
            text.push('\\');
        }
        text.push(c);
    }
}
