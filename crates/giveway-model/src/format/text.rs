//! Places in a text, and parts of it in sentences.

use crate::Fault;

/// The text without a byte order mark.
pub fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Line and column, both from 1, of a byte of the text; columns in characters.
pub fn position(text: &str, offset: usize) -> (usize, usize) {
    Positions::new(text).of(offset)
}

/// The fault with the line and column of a byte of the text.
pub fn at_byte(text: &str, offset: usize, fault: Fault) -> Fault {
    let (line, column) = position(text, offset);
    fault.in_text(line, column)
}

/// Finds the lines and columns of many places, quickest in ascending order.
pub struct Positions<'a> {
    text: &'a str,
    offset: usize,
    line: usize,
    column: usize,
}

impl<'a> Positions<'a> {
    /// At the beginning of a text.
    pub const fn new(text: &'a str) -> Self {
        Self {
            text,
            offset: 0,
            line: 1,
            column: 1,
        }
    }

    /// Line and column, both from 1, of a byte of the text.
    pub fn of(&mut self, offset: usize) -> (usize, usize) {
        let mut offset = offset.min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        if offset < self.offset {
            *self = Self::new(self.text);
        }
        for c in self.text.get(self.offset..offset).unwrap_or("").chars() {
            if c == '\n' {
                self.line += 1;
                self.column = 1;
            } else {
                self.column += 1;
            }
        }
        self.offset = offset;
        (self.line, self.column)
    }
}

/// The found text, cut to a length that fits a sentence.
pub fn shorten(found: &str) -> String {
    const LONGEST: usize = 60;
    let clean = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    if found.chars().nth(LONGEST).is_none() {
        return found.chars().map(clean).collect();
    }
    let head: String = found.chars().take(LONGEST - 10).map(clean).collect();
    format!("{head}...")
}
