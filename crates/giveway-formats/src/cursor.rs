//! Walks through a text byte by byte, for formats that are not JSON or YAML. It
//! looks at no byte twice, and knows at every time where it is.

use super::Pair;
use giveway_model::format::text::{at_byte, shorten};
use giveway_model::words::Later;
use giveway_model::{Fault, tr, tr_later};

/// A place in a text.
#[derive(Clone)]
pub(super) struct Cursor<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Cursor<'a> {
    pub(super) const fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// The byte that comes next; `None` at the end of the text.
    pub(super) fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// The byte of the text that comes next.
    pub(super) const fn offset(&self) -> usize {
        self.at
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.at >= self.text.len()
    }

    /// The rest of the text.
    pub(super) fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    /// Passes over a word of ASCII, if it comes next.
    pub(super) fn eat(&mut self, word: &str) -> bool {
        let rest = self.text.as_bytes().get(self.at..).unwrap_or_default();
        let is_next = rest.starts_with(word.as_bytes());
        if is_next {
            self.at += word.len();
        }
        is_next
    }

    /// Passes over a word.
    ///
    /// # Errors
    /// When something else comes.
    pub(super) fn expect(&mut self, word: &str, expected: impl Into<String>) -> Result<(), Fault> {
        if self.eat(word) {
            Ok(())
        } else {
            Err(self.fault(expected))
        }
    }

    /// Passes over some bytes.
    pub(super) const fn skip(&mut self, bytes: usize) {
        self.at += bytes;
    }

    /// The digits that come next, perhaps none.
    pub(super) fn digits(&self) -> &'a str {
        let rest = self.rest();
        let is_digit = |c: char| c.is_ascii_digit();
        rest.get(..rest.find(|c| !is_digit(c)).unwrap_or(rest.len()))
            .unwrap_or("")
    }

    /// Passes over blanks and tabs.
    pub(super) fn blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t')) {
            self.at += 1;
        }
    }

    /// Passes over blanks, tabs and ends of lines.
    pub(super) fn space(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\r' | b'\n')) {
            self.at += 1;
        }
    }

    /// Passes over blanks and the end of the line, or of the text.
    ///
    /// # Errors
    /// When something else comes.
    pub(super) fn end_of_line(&mut self, expected: Later) -> Result<(), Fault> {
        self.blanks();
        if self.eat("\n") || self.eat("\r\n") || self.eat("\r") || self.is_at_end() {
            Ok(())
        } else {
            Err(self.fault(expected))
        }
    }

    /// The rest of the line, without blanks around it; the cursor passes over its end.
    pub(super) fn line(&mut self) -> &'a str {
        let rest = self.rest();
        let end = rest.find('\n').unwrap_or(rest.len());
        self.at += (end + 1).min(rest.len());
        rest.get(..end).unwrap_or("").trim()
    }

    /// Reads a number, with or without a sign.
    ///
    /// # Errors
    /// When there is none, or one that 32 bits do not hold.
    pub(super) fn number(&mut self, expected: Later) -> Result<i32, Fault> {
        let begin = self.at;
        let is_negative = self.eat("-");
        let mut number: Option<i64> = None;
        while let Some(digit @ b'0'..=b'9') = self.peek() {
            let next = number.unwrap_or(0) * 10 + i64::from(digit - b'0');
            if next > i64::from(i32::MAX) + i64::from(is_negative) {
                self.at = begin;
                return Err(self.fault(tr!("a number of at most 2147483647")));
            }
            number = Some(next);
            self.at += 1;
        }
        let number = number.map(|number| if is_negative { -number } else { number });
        number
            .and_then(|number| i32::try_from(number).ok())
            .ok_or_else(|| {
                self.at = begin;
                self.fault(expected)
            })
    }

    /// Reads two numbers of a cell such as `(3,1)`, up to the bracket that closes it,
    /// since some write more before it.
    ///
    /// # Errors
    /// When something else comes.
    pub(super) fn pair(&mut self) -> Result<Pair, Fault> {
        self.blanks();
        self.expect("(", tr_later!("a cell, such as (3,1)"))?;
        self.blanks();
        let first = self.number(tr_later!("a number"))?;
        self.blanks();
        self.expect(",", "\",\"")?;
        self.blanks();
        let second = self.number(tr_later!("a number"))?;
        self.blanks();
        Ok(Pair::new(first, second))
    }

    /// A fault at what comes next.
    pub(super) fn fault(&self, expected: impl Into<String>) -> Fault {
        self.fault_saying(self.found(), expected)
    }

    /// A fault at what comes next, with words of its own for what was found.
    pub(super) fn fault_saying(
        &self,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Fault {
        self.place(Fault::at("", found, expected))
    }

    /// The fault, with the line and column of what comes next.
    pub(super) fn place(&self, fault: Fault) -> Fault {
        at_byte(self.text, self.at, fault)
    }

    fn found(&self) -> String {
        match self.peek() {
            None => tr!("the end of the file").to_owned(),
            Some(b'\n' | b'\r') => tr!("the end of the line").to_owned(),
            Some(_) => {
                let rest = self.rest();
                let mut letters = rest.char_indices();
                let end = letters.find(|&(at, c)| c.is_whitespace() && at > 0 || at > 200);
                let word = rest.get(..end.map_or(rest.len(), |(at, _)| at));
                format!("\"{}\"", shorten(word.unwrap_or(rest)))
            }
        }
    }
}
