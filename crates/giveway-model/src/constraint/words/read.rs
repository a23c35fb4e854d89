//! A rule read from the words in which it is said.

use super::tokens::{Token, tokens};
use crate::condition::Times;
use crate::{Cell, Constraint, Fault};

impl Constraint {
    /// Reads a rule from English words, as [`Constraint::sentence`] writes them. Capital
    /// letters do not matter but in names.
    ///
    /// # Errors
    /// Where the words stop to be a rule: what was found there, and what was expected.
    ///
    /// ```
    /// use giveway_model::Constraint;
    /// let rule = Constraint::from_words("at most 1 robot in 'aisle 3'").unwrap();
    /// assert_eq!(rule.sentence(), "At most 1 robot in 'aisle 3'");
    /// let fault = Constraint::from_words("at most many robots").unwrap_err();
    /// assert_eq!((&*fault.found, &*fault.expected), ("\"many\"", "a whole number"));
    /// ```
    pub fn from_words(text: &str) -> Result<Self, Fault> {
        let tokens = tokens(text);
        let mut words = Words {
            rest: &tokens,
            agents: None,
        };
        let kind = words.rule()?;
        if !words.rest.is_empty() {
            return words.fault("no more words");
        }
        Ok(Self {
            kind,
            agents: words.agents,
            name: None,
            off: false,
        })
    }
}

/// The words that are still to be read.
pub(super) struct Words<'t> {
    pub(super) rest: &'t [Token],
    /// The robots that the rule binds; `None` for all.
    pub(super) agents: Option<Vec<String>>,
}

pub(super) type Read<T> = Result<T, Fault>;

impl Words<'_> {
    pub(super) fn fault<T>(&self, expected: &str) -> Read<T> {
        let found = match self.rest.first() {
            None => "the end of the rule".to_owned(),
            Some(token) => token.to_string(),
        };
        Err(Fault::at("rule", found, expected))
    }

    /// Takes some words, where they are next.
    pub(super) fn eat(&mut self, words: &str) -> bool {
        let mut rest = self.rest;
        for word in words.split(' ') {
            let Some((Token::Word(next), after)) = rest.split_first() else {
                return false;
            };
            if !next.eq_ignore_ascii_case(word) {
                return false;
            }
            rest = after;
        }
        self.rest = rest;
        true
    }

    pub(super) fn need(&mut self, words: &str) -> Read<()> {
        if self.eat(words) {
            return Ok(());
        }
        self.fault(&format!("\"{words}\""))
    }

    pub(super) fn mark(&mut self, mark: char) -> bool {
        match self.rest.split_first() {
            Some((Token::Mark(next), rest)) if *next == mark => {
                self.rest = rest;
                true
            }
            _ => false,
        }
    }

    pub(super) fn number(&mut self) -> Read<u32> {
        if let Some((&Token::Number(number), rest)) = self.rest.split_first() {
            self.rest = rest;
            return Ok(number);
        }
        self.fault("a whole number")
    }

    /// `(3, 1)` or `3,1`.
    pub(super) fn cell(&mut self) -> Read<Cell> {
        let is_open = self.mark('(');
        if !is_open && !matches!(self.rest.first(), Some(Token::Number(_))) {
            return self.fault("a cell such as (3, 1)");
        }
        let x = self.number()?;
        if !self.mark(',') {
            return self.fault("\",\"");
        }
        let y = self.number()?;
        if is_open && !self.mark(')') {
            return self.fault("\")\"");
        }
        Ok(Cell::new(x, y))
    }

    pub(super) fn zone(&mut self) -> Read<String> {
        if let Some((Token::Quoted(name), rest)) = self.rest.split_first() {
            self.rest = rest;
            return Ok(name.clone());
        }
        self.fault("the name of a zone in single quotes")
    }

    pub(super) fn in_zone(&mut self) -> Read<String> {
        self.need("in")?;
        self.zone()
    }

    pub(super) fn name(&mut self) -> Read<String> {
        if let Some((Token::Quoted(name) | Token::Word(name), rest)) = self.rest.split_first() {
            self.rest = rest;
            return Ok(name.clone());
        }
        self.fault("the name of a robot")
    }

    /// `A1`, `A1 and A2`, `A1, A2 and A3`.
    pub(super) fn names(&mut self) -> Read<Vec<String>> {
        let mut names = vec![self.name()?];
        while self.mark(',') || self.eat("and") {
            names.push(self.name()?);
        }
        Ok(names)
    }

    /// `of A1 and A2`, or `of all robots`, where it is next.
    pub(super) fn of(&mut self) -> Read<bool> {
        if self.eat("of all robots") {
            return Ok(true);
        }
        if !self.eat("of") {
            return Ok(false);
        }
        self.agents = Some(self.names()?);
        Ok(true)
    }

    /// `from 3 on`, `up to 5`, `from 3 to 5`, `always`, or nothing.
    pub(super) fn times(&mut self) -> Read<Times> {
        let mut times = Times::default();
        if self.eat("from") {
            times.from = Some(self.number()?);
            if !self.eat("on") {
                self.need("to")?;
                times.to = Some(self.number()?);
            }
        } else if self.eat("up to") {
            times.to = Some(self.number()?);
        } else {
            self.eat("always");
        }
        Ok(times)
    }

    pub(super) fn steps(&mut self) -> Read<u32> {
        let steps = self.number()?;
        if !self.eat("step") {
            self.need("steps")?;
        }
        Ok(steps)
    }
}
