//! Facts of a logic program: tokens and terms.
//!
//! ```text
//! program   = { fact "." | "#" ... "." }          a blank instead of the "." where clingo prints answers
//! fact      = term
//! term      = number | text | name [ "(" [ terms ] ")" ] | "(" [ terms ] ")"
//! comment   = "%" ... end of line | "%*" ... "*%"
//! ```

use crate::cursor::Cursor;
use giveway_model::format::text::{at_byte, shorten};
use giveway_model::{Fault, tr};

/// How deep terms may be nested; facts of asprilo need four levels.
const MAX_DEPTH: usize = 16;

/// A term, and the byte where it begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Term<'a> {
    pub(super) offset: usize,
    pub(super) kind: Kind<'a>,
}

/// The kind of a term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind<'a> {
    Number(i32),
    Text,
    /// `name`, `name(..)`, or a tuple, which has no name.
    Compound(&'a str, Vec<Term<'a>>),
}

impl<'a> Term<'a> {
    /// The name and arguments; of a tuple the name is empty.
    pub(super) fn parts(&self) -> Option<(&'a str, &[Self])> {
        match &self.kind {
            Kind::Compound(name, arguments) => Some((name, arguments)),
            _ => None,
        }
    }

    /// The number that this is.
    pub(super) const fn number(&self) -> Option<i32> {
        match self.kind {
            Kind::Number(number) => Some(number),
            _ => None,
        }
    }

    /// The two numbers or more of a tuple.
    pub(super) fn pair(&self) -> Option<(i32, i32)> {
        match self.parts()? {
            ("", [first, second]) => Some((first.number()?, second.number()?)),
            _ => None,
        }
    }
}

/// The length of a directive up to its full stop, which may not be in a text.
pub(super) fn directive(text: &str) -> Option<usize> {
    let mut is_text = false;
    let stop = text.bytes().position(|byte| {
        is_text ^= byte == b'"';
        byte == b'.' && !is_text
    });
    stop.map(|at| at + 1)
}

/// The facts of a text, one after the other.
pub(super) struct Facts<'a> {
    text: &'a str,
    cursor: Cursor<'a>,
}

impl<'a> Facts<'a> {
    pub(super) const fn new(text: &'a str) -> Self {
        let cursor = Cursor::new(text);
        Self { text, cursor }
    }

    /// A fault at a byte of the text.
    pub(super) fn fault(
        &self,
        offset: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Fault {
        at_byte(self.text, offset, Fault::at("", found, expected))
    }

    /// A fault at a byte whose line is quoted.
    pub(super) fn unexpected(&self, offset: usize, expected: impl Into<String>) -> Fault {
        let rest = self.text.get(offset..).unwrap_or("");
        let line = rest.lines().next().unwrap_or("").trim_end();
        let found = if rest.is_empty() {
            tr!("the end of the file").to_owned()
        } else {
            format!("\"{}\"", shorten(line))
        };
        self.fault(offset, found, expected)
    }

    /// The next fact; `None` at the end.
    pub(super) fn next(&mut self) -> Result<Option<Term<'a>>, Fault> {
        self.skip_directives()?;
        if self.cursor.peek().is_none() {
            return Ok(None);
        }
        let fact = self.term(0)?;
        if fact.parts().is_none_or(|(name, _)| name.is_empty()) {
            return Err(self.unexpected(fact.offset, tr!("a fact such as init(..).")));
        }
        self.blank()?;
        match self.cursor.peek() {
            Some(b'.') => self.cursor.skip(1),
            None => {}
            Some(byte) if byte.is_ascii_lowercase() => {}
            Some(_) => {
                return Err(
                    self.unexpected(self.cursor.offset(), tr!("a full stop after the fact"))
                );
            }
        }
        Ok(Some(fact))
    }

    /// Skips blanks and comments.
    fn blank(&mut self) -> Result<(), Fault> {
        while let Some(byte) = self.cursor.peek() {
            if byte.is_ascii_whitespace() {
                self.cursor.skip(1);
            } else if self.cursor.rest().starts_with("%*") {
                let Some(length) = self.cursor.rest().find("*%") else {
                    let found = tr!("a comment without end");
                    return Err(self.fault(self.cursor.offset(), found, tr!("*% after it")));
                };
                self.cursor.skip(length + 2);
            } else if byte == b'%' {
                let rest = self.cursor.rest();
                self.cursor.skip(rest.find('\n').unwrap_or(rest.len()));
            } else {
                break;
            }
        }
        Ok(())
    }

    /// Skips blanks, and what begins with `#` up to its full stop.
    fn skip_directives(&mut self) -> Result<(), Fault> {
        self.blank()?;
        while self.cursor.peek() == Some(b'#') {
            match directive(self.cursor.rest()) {
                Some(length) => self.cursor.skip(length),
                None => {
                    return Err(self.unexpected(self.cursor.offset(), tr!("a full stop after it")));
                }
            }
            self.blank()?;
        }
        Ok(())
    }

    fn term(&mut self, depth: usize) -> Result<Term<'a>, Fault> {
        self.blank()?;
        let offset = self.cursor.offset();
        if depth > MAX_DEPTH {
            return Err(self.fault(
                offset,
                tr!("terms nested very deeply"),
                tr!("the few levels of the format"),
            ));
        }
        let kind = match self.cursor.peek() {
            Some(b'0'..=b'9' | b'-') => self.number()?,
            Some(b'"') => self.quoted()?,
            Some(b'(') => {
                let mut terms = self.arguments(depth)?;
                let read = self.text.get(..self.cursor.offset()).unwrap_or("");
                if terms.len() == 1 && !read.ends_with(",)") {
                    return Ok(terms.swap_remove(0));
                }
                Kind::Compound("", terms)
            }
            Some(b'a'..=b'z' | b'_') => {
                let is_name = |c: char| c.is_ascii_alphanumeric() || "_'".contains(c);
                let rest = self.cursor.rest();
                let length = rest.find(|c| !is_name(c)).unwrap_or(rest.len());
                self.cursor.skip(length);
                let name = rest.get(..length).unwrap_or("");
                let terms = match self.cursor.peek() {
                    Some(b'(') => self.arguments(depth)?,
                    _ => Vec::new(),
                };
                Kind::Compound(name, terms)
            }
            _ => return Err(self.unexpected(offset, tr!("a fact, since rules are not read"))),
        };
        Ok(Term { offset, kind })
    }

    fn number(&mut self) -> Result<Kind<'a>, Fault> {
        let rest = self.cursor.rest();
        let sign = usize::from(rest.starts_with('-'));
        let digits = rest.bytes().skip(sign).take_while(u8::is_ascii_digit);
        let length = sign + digits.count();
        let number = rest.get(..length).and_then(|number| number.parse().ok());
        let number = number.ok_or_else(|| {
            let expected = tr!(
                "a whole number from {least} to {most}",
                least = i32::MIN,
                most = i32::MAX
            );
            self.unexpected(self.cursor.offset(), expected)
        })?;
        self.cursor.skip(length);
        Ok(Kind::Number(number))
    }

    fn quoted(&mut self) -> Result<Kind<'a>, Fault> {
        let begin = self.cursor.offset();
        let mut is_escaped = false;
        for (i, byte) in self.cursor.rest().bytes().enumerate().skip(1) {
            match byte {
                b'\n' => break,
                _ if is_escaped => is_escaped = false,
                b'\\' => is_escaped = true,
                b'"' => {
                    self.cursor.skip(i + 1);
                    return Ok(Kind::Text);
                }
                _ => {}
            }
        }
        Err(self.unexpected(begin, tr!("a closing quote in its line")))
    }

    /// The arguments between parentheses.
    fn arguments(&mut self, depth: usize) -> Result<Vec<Term<'a>>, Fault> {
        self.cursor.skip(1);
        let mut terms = Vec::new();
        loop {
            self.blank()?;
            if self.cursor.peek() == Some(b')') {
                break;
            }
            terms.push(self.term(depth + 1)?);
            self.blank()?;
            match self.cursor.peek() {
                Some(b',') => self.cursor.skip(1),
                Some(b')') => break,
                _ => {
                    return Err(
                        self.unexpected(self.cursor.offset(), tr!("a comma or a closing )"))
                    );
                }
            }
        }
        self.cursor.skip(1);
        Ok(terms)
    }
}
