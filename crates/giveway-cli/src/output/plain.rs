//! Text from files, made safe for a terminal.

use unicode_width::UnicodeWidthStr;

/// The text with control characters written as escapes, so that a name in a
/// file can neither break a line nor steer the terminal.
///
/// Marks that keep a name in its own direction of writing stay, where each one that begins
/// has its end.
pub(crate) fn text(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let are_isolates_whole = are_isolates_whole(text);
    for c in text.chars() {
        let is_isolate = matches!(c, ISOLATE | END_OF_ISOLATE) && are_isolates_whole;
        if is_unsafe(c) && !is_isolate {
            out.extend(c.escape_default());
        } else {
            out.push(c);
        }
    }
    out
}

/// The text, cut in its middle to so many columns: names of one fleet differ at their ends.
pub(crate) fn cut_middle(text: &str, columns: usize) -> String {
    if width(text) <= columns {
        return text.to_owned();
    }
    let room = columns.saturating_sub(1);
    let part = |letters: &mut dyn Iterator<Item = char>, room: usize| {
        let mut part = String::new();
        for letter in letters {
            if width(&part) + width(letter.encode_utf8(&mut [0; 4])) > room {
                break;
            }
            part.push(letter);
        }
        part
    };
    let end = part(&mut text.chars().rev(), room.div_ceil(2));
    let begin = part(&mut text.chars(), room - width(&end));
    let end: String = end.chars().rev().collect();
    format!("{begin}…{end}")
}

/// Begins and ends a part with a direction of writing of its own (Unicode UAX 9).
const ISOLATE: char = '\u{2068}';
const END_OF_ISOLATE: char = '\u{2069}';

/// Whether each isolate has its end, and each end its isolate.
fn are_isolates_whole(text: &str) -> bool {
    let mut open = 0_u32;
    for c in text.chars() {
        match c {
            ISOLATE => open += 1,
            END_OF_ISOLATE if open == 0 => return false,
            END_OF_ISOLATE => open -= 1,
            _ => {}
        }
    }
    open == 0
}

/// Control characters, and those that turn the direction of writing.
fn is_unsafe(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// How many columns of a terminal the text takes.
pub(crate) fn width(text: &str) -> usize {
    text.width()
}

/// The text, cut to so many columns; `…` says that it was cut.
pub(crate) fn cut(text: &str, columns: usize) -> String {
    if width(text) <= columns {
        return text.to_owned();
    }
    let mut out = String::new();
    for c in text.chars() {
        if width(&out) + width(c.encode_utf8(&mut [0; 4])) + 1 > columns {
            break;
        }
        out.push(c);
    }
    out.push('…');
    out
}

/// The text with blanks after it, to so many columns.
pub(crate) fn pad_right(text: &str, columns: usize) -> String {
    format!("{text}{}", blanks(text, columns))
}

/// The text with blanks before it, to so many columns.
pub(crate) fn pad_left(text: &str, columns: usize) -> String {
    format!("{}{text}", blanks(text, columns))
}

fn blanks(text: &str, columns: usize) -> String {
    " ".repeat(columns.saturating_sub(width(text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_escaped() {
        assert_eq!(text("a\u{1b}[31m\tb\u{202e}"), "a\\u{1b}[31m\\tb\\u{202e}");
        assert_eq!(text("Zoë 猫"), "Zoë 猫");
        assert_eq!(
            text("a \u{2068}\u{5d0}\u{2069}"),
            "a \u{2068}\u{5d0}\u{2069}"
        );
        assert_eq!(text("\u{2069}\u{2068}"), "\\u{2069}\\u{2068}");
    }

    #[test]
    fn cutting_and_padding_count_columns() {
        assert_eq!(cut("robot", 5), "robot");
        assert_eq!(cut("robots", 5), "robo…");
        assert_eq!(cut("猫猫猫", 5), "猫猫…");
        assert_eq!(
            cut_middle("Transporter_in_hall_East_01", 16),
            "Transpo…_East_01"
        );
        assert_eq!(cut_middle("猫猫猫猫", 6), "猫…猫");
        assert_eq!(cut_middle("robot", 5), "robot");
        assert_eq!(pad_left("猫", 3), " 猫");
        assert_eq!(pad_right("ab", 3), "ab ");
    }
}
