//! Bytes as text, and places in a text.

use crate::{Fault, tr, tr_later};

/// The bytes of a file as text, without the byte order mark that some editors
/// put first.
///
/// # Errors
/// When the bytes are not UTF-8.
pub fn read_text(bytes: &[u8]) -> Result<&str, Fault> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(without_mark(text)),
        Err(error) => {
            let good = bytes.get(..error.valid_up_to()).unwrap_or_default();
            let good = String::from_utf8_lossy(good);
            let (line, column) = position(&good, good.len());
            let byte = bytes.get(error.valid_up_to()).copied().unwrap_or_default();
            Err(Fault::at(
                "",
                tr!("the byte {byte}", byte = format!("0x{byte:02X}")),
                tr_later!("text in UTF-8"),
            )
            .in_text(line, column))
        }
    }
}

/// The text without a byte order mark.
pub(super) fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Line and column, both from 1, of a byte of the text; columns in characters.
pub(super) fn position(text: &str, offset: usize) -> (usize, usize) {
    Positions::new(text).of(offset)
}

/// Finds the lines and columns of many places, quickest in ascending order.
pub(super) struct Positions<'a> {
    text: &'a str,
    offset: usize,
    line: usize,
    column: usize,
}

impl<'a> Positions<'a> {
    pub(super) const fn new(text: &'a str) -> Self {
        Self {
            text,
            offset: 0,
            line: 1,
            column: 1,
        }
    }

    /// Line and column, both from 1, of a byte of the text.
    pub(super) fn of(&mut self, offset: usize) -> (usize, usize) {
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

/// What was found, cut to a length that fits a sentence.
pub(super) fn shorten(found: &str) -> String {
    const LONGEST: usize = 60;
    let clean = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    if found.chars().nth(LONGEST).is_none() {
        return found.chars().map(clean).collect();
    }
    let head: String = found.chars().take(LONGEST - 10).map(clean).collect();
    format!("{head}...")
}
