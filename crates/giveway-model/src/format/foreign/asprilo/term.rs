//! Facts of a logic program: tokens and terms.
//!
//! ```text
//! program   = { fact "." | "#" ... "." }          a blank instead of the "." where clingo prints answers
//! fact      = term
//! term      = number | text | name [ "(" [ terms ] ")" ] | "(" [ terms ] ")"
//! comment   = "%" ... end of line | "%*" ... "*%"
//! ```

use crate::format::text::{position, shorten};
use crate::{Fault, tr};

/// How deep terms may be nested; facts of asprilo need four levels.
const MAX_DEPTH: usize = 16;

/// A term, and the byte where it begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Term<'a> {
    pub(super) offset: usize,
    pub(super) kind: Kind<'a>,
}

/// What a term is.
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
    at: usize,
}

impl<'a> Facts<'a> {
    pub(super) const fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// A fault at a byte of the text.
    pub(super) fn fault(
        &self,
        offset: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Fault {
        let (line, column) = position(self.text, offset);
        Fault::at("", found, expected).in_text(line, column)
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
        if self.peek().is_none() {
            return Ok(None);
        }
        let fact = self.term(0)?;
        if fact.parts().is_none_or(|(name, _)| name.is_empty()) {
            return Err(self.unexpected(fact.offset, tr!("a fact such as init(..).")));
        }
        self.blank()?;
        match self.peek() {
            Some(b'.') => self.at += 1,
            None => {}
            Some(byte) if byte.is_ascii_lowercase() => {}
            Some(_) => return Err(self.unexpected(self.at, tr!("a full stop after the fact"))),
        }
        Ok(Some(fact))
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    /// Skips blanks and comments.
    fn blank(&mut self) -> Result<(), Fault> {
        while let Some(byte) = self.peek() {
            if byte.is_ascii_whitespace() {
                self.at += 1;
            } else if self.rest().starts_with("%*") {
                let begin = self.at;
                match self.rest().find("*%") {
                    Some(length) => self.at += length + 2,
                    None => {
                        return Err(self.fault(
                            begin,
                            tr!("a comment without end"),
                            tr!("*% after it"),
                        ));
                    }
                }
            } else if byte == b'%' {
                let rest = self.rest();
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else {
                break;
            }
        }
        Ok(())
    }

    /// Skips blanks, and what begins with `#` up to its full stop.
    fn skip_directives(&mut self) -> Result<(), Fault> {
        self.blank()?;
        while self.peek() == Some(b'#') {
            match directive(self.rest()) {
                Some(length) => self.at += length,
                None => return Err(self.unexpected(self.at, tr!("a full stop after it"))),
            }
            self.blank()?;
        }
        Ok(())
    }

    fn term(&mut self, depth: usize) -> Result<Term<'a>, Fault> {
        self.blank()?;
        let offset = self.at;
        if depth > MAX_DEPTH {
            return Err(self.fault(
                offset,
                tr!("terms nested very deeply"),
                tr!("the few levels of the format"),
            ));
        }
        let kind = match self.peek() {
            Some(b'0'..=b'9' | b'-') => self.number()?,
            Some(b'"') => self.quoted()?,
            Some(b'(') => {
                let mut terms = self.arguments(depth)?;
                match terms.len() {
                    1 if !self
                        .text
                        .get(..self.at)
                        .is_some_and(|it| it.ends_with(",)")) =>
                    {
                        return Ok(terms.swap_remove(0));
                    }
                    _ => Kind::Compound("", terms),
                }
            }
            Some(b'a'..=b'z' | b'_') => {
                let is_name = |c: char| c.is_ascii_alphanumeric() || "_'".contains(c);
                let rest = self.rest();
                let length = rest.find(|c| !is_name(c)).unwrap_or(rest.len());
                self.at += length;
                let name = rest.get(..length).unwrap_or("");
                let is_compound = self.peek() == Some(b'(');
                let terms = if is_compound {
                    self.arguments(depth)?
                } else {
                    Vec::new()
                };
                Kind::Compound(name, terms)
            }
            _ => return Err(self.unexpected(offset, tr!("a fact, since rules are not read"))),
        };
        Ok(Term { offset, kind })
    }

    fn number(&mut self) -> Result<Kind<'a>, Fault> {
        let rest = self.rest();
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
            self.unexpected(self.at, expected)
        })?;
        self.at += length;
        Ok(Kind::Number(number))
    }

    fn quoted(&mut self) -> Result<Kind<'a>, Fault> {
        let begin = self.at;
        let mut is_escaped = false;
        for (i, byte) in self.rest().bytes().enumerate().skip(1) {
            match byte {
                b'\n' => break,
                _ if is_escaped => is_escaped = false,
                b'\\' => is_escaped = true,
                b'"' => {
                    self.at += i + 1;
                    return Ok(Kind::Text);
                }
                _ => {}
            }
        }
        Err(self.unexpected(begin, tr!("a closing quote in its line")))
    }

    /// What stands between parentheses.
    fn arguments(&mut self, depth: usize) -> Result<Vec<Term<'a>>, Fault> {
        self.at += 1;
        let mut terms = Vec::new();
        loop {
            self.blank()?;
            if self.peek() == Some(b')') {
                break;
            }
            terms.push(self.term(depth + 1)?);
            self.blank()?;
            match self.peek() {
                Some(b',') => self.at += 1,
                Some(b')') => break,
                _ => return Err(self.unexpected(self.at, tr!("a comma or a closing )"))),
            }
        }
        self.at += 1;
        Ok(terms)
    }
}
