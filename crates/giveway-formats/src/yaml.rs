//! Reads YAML 1.2 value by value, in the order of the text, without making a tree
//! of it.
//!
//! Every fault has a line, a column and the path of keys. What is nested deeper than any
//! format does is refused, and so are aliases that stand for too many values (`events`).

use std::borrow::Cow;
use std::fmt::Display;
use std::str::FromStr;

use saphyr_parser::{Event, ScalarStyle};

use super::events::{Broken, Events, Why};
use crate::unknown_keys::UnknownKeys;
use giveway_model::format::json::place;
use giveway_model::format::locate::Segment;
use giveway_model::format::text::shorten;
use giveway_model::words::Later;
use giveway_model::{Fault, tr, tr_later};

/// The deepest nesting of lists and objects that is read.
const MAX_DEPTH: usize = 32;

/// The kind of the next value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A text, a number, or nothing at all.
    Scalar,
    List,
    Object,
}

/// Values of a YAML text, one after the other.
pub(super) struct Yaml<'a> {
    events: Events<'a>,
    /// The keys and indices on the way to the value that comes next.
    way: Vec<Segment>,
    /// The line and column at which the last event began.
    at: (usize, usize),
}

impl<'a> Yaml<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            events: Events::new(text),
            way: Vec::new(),
            at: (1, 1),
        }
    }

    /// Goes to the next document (`---`), whose value comes next; `false` where
    /// there is none. Call it once before the first value.
    pub(super) fn document(&mut self) -> Result<bool, Fault> {
        loop {
            match self.event()? {
                Event::DocumentStart(_) => return Ok(true),
                Event::StreamEnd => return Ok(false),
                _ => {}
            }
        }
    }

    /// The kind of the value that comes next.
    pub(super) fn kind(&mut self) -> Result<Kind, Fault> {
        let (kind, at) = match self.events.peek() {
            Ok(Some((event, at))) => {
                let kind = match event {
                    Event::SequenceStart(..) => Kind::List,
                    Event::MappingStart(..) => Kind::Object,
                    _ => Kind::Scalar,
                };
                (kind, at)
            }
            Ok(None) => return Ok(Kind::Scalar),
            Err(broken) => return Err(self.broken(broken)),
        };
        self.at = at;
        Ok(kind)
    }

    /// Reads an object; `each` is given every key and must read its value.
    pub(super) fn object(
        &mut self,
        expected: Later,
        mut each: impl FnMut(&mut Self, &str) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        match self.event()? {
            Event::MappingStart(..) => self.deeper()?,
            other => return Err(self.instead(&other, expected)),
        }
        // Objects whose keys are merged into this one by `<<`.
        let mut merged = 0_usize;
        loop {
            let key = match self.event()? {
                Event::MappingEnd if merged > 0 => {
                    merged -= 1;
                    continue;
                }
                Event::MappingEnd => return Ok(()),
                Event::Scalar(key, ..) => key,
                other => return Err(self.instead(&other, tr_later!("a key"))),
            };
            if key == "<<" && self.kind()? == Kind::Object {
                self.event()?;
                merged += 1;
                continue;
            }
            self.way.push(Segment::Key(key.clone().into_owned()));
            each(self, &key)?;
            self.way.pop();
        }
    }

    /// Reads a list; `each` is given every index from 0 and must read the entry.
    pub(super) fn list(
        &mut self,
        expected: Later,
        mut each: impl FnMut(&mut Self, usize) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        match self.event()? {
            Event::SequenceStart(..) => self.deeper()?,
            other => return Err(self.instead(&other, expected)),
        }
        for index in 0.. {
            if let Ok(Some((Event::SequenceEnd, _))) = self.events.peek() {
                self.event()?;
                break;
            }
            self.way.push(Segment::Index(index));
            each(self, index)?;
            self.way.pop();
        }
        Ok(())
    }

    /// Reads a text, or a number as it is written.
    pub(super) fn text(&mut self, expected: Later) -> Result<Cow<'a, str>, Fault> {
        match self.event()? {
            Event::Scalar(text, ..) => Ok(text),
            other => Err(self.instead(&other, expected)),
        }
    }

    /// Reads a text that may be left out: `None` for `null`, `~` and nothing.
    pub(super) fn optional(&mut self, expected: Later) -> Result<Option<Cow<'a, str>>, Fault> {
        match self.event()? {
            Event::Scalar(text, ScalarStyle::Plain, ..)
                if matches!(&*text, "" | "~" | "null" | "Null" | "NULL") =>
            {
                Ok(None)
            }
            Event::Scalar(text, ..) => Ok(Some(text)),
            other => Err(self.instead(&other, expected)),
        }
    }

    /// Reads a number.
    pub(super) fn number<T: FromStr>(&mut self, expected: Later) -> Result<T, Fault> {
        let text = self.text(expected)?;
        text.parse().map_err(|_| self.unlike(&text, expected))
    }

    /// Notes a key that is not known, with the keys on the way to it, and passes over its value.
    pub(super) fn skip_unknown(
        &mut self,
        unknown: &mut UnknownKeys,
        (way, key): (&str, &str),
    ) -> Result<(), Fault> {
        unknown.note(way, key);
        self.skip()
    }

    /// Passes over a value, whatever it is.
    pub(super) fn skip(&mut self) -> Result<(), Fault> {
        let mut depth = 0_usize;
        loop {
            match self.event()? {
                Event::SequenceStart(..) | Event::MappingStart(..) => depth += 1,
                Event::SequenceEnd | Event::MappingEnd => depth = depth.saturating_sub(1),
                Event::Scalar(..) => {}
                other => return Err(self.instead(&other, tr_later!("a value"))),
            }
            if depth == 0 {
                return Ok(());
            }
            if depth + self.way.len() > MAX_DEPTH {
                return Err(self.too_deep());
            }
        }
    }

    /// A fault at the value that was read last.
    pub(super) fn fault(&self, found: impl Into<String>, expected: impl Into<String>) -> Fault {
        let (line, column) = self.at;
        Fault::at(place(&self.way), found, expected).in_text(line, column)
    }

    /// A fault at the text that was read last, which is not as it should be.
    pub(super) fn unlike(&self, text: &str, expected: Later) -> Fault {
        self.fault(quoted(text), expected)
    }

    /// Line and column, both from 1, of the value that was read last.
    pub(super) const fn at(&self) -> (usize, usize) {
        self.at
    }

    fn event(&mut self) -> Result<Event<'a>, Fault> {
        match self.events.next() {
            Ok(Some((event, at))) => {
                self.at = at;
                Ok(event)
            }
            Ok(None) => Ok(Event::StreamEnd),
            Err(broken) => Err(self.broken(broken)),
        }
    }

    fn deeper(&self) -> Result<(), Fault> {
        if self.way.len() < MAX_DEPTH {
            Ok(())
        } else {
            Err(self.too_deep())
        }
    }

    fn too_deep(&self) -> Fault {
        let expected = tr!("at most {most}", most = MAX_DEPTH);
        self.fault(
            tr!(
                "over {most} lists and objects in each other",
                most = MAX_DEPTH
            ),
            expected,
        )
    }

    fn broken(&mut self, broken: Broken) -> Fault {
        self.at = broken.at;
        match broken.why {
            Why::Text(info) => {
                let info = shorten(&info);
                self.fault(tr!("broken YAML ({info})", info), "YAML")
            }
            Why::Aliases => self.fault(
                tr!("aliases (*) that stand for too many values"),
                tr!("the values themselves"),
            ),
        }
    }

    fn instead(&self, event: &Event<'_>, expected: Later) -> Fault {
        let found = match event {
            Event::Scalar(text, ScalarStyle::Plain, ..) if text.is_empty() => {
                tr!("nothing").to_owned()
            }
            Event::Scalar(text, ..) => quoted(text),
            Event::SequenceStart(..) => tr!("a list").to_owned(),
            Event::MappingStart(..) => tr!("an object").to_owned(),
            _ => tr!("the end of the value").to_owned(),
        };
        self.fault(found, expected)
    }
}

fn quoted(text: impl Display) -> String {
    format!("\"{}\"", shorten(&text.to_string()))
}

/// The keys of the object that a text of YAML is; `None` where it is something else.
pub(super) fn keys(text: &str) -> Option<Vec<String>> {
    let mut keys = Vec::new();
    let mut yaml = Yaml::new(text);
    yaml.document().ok().filter(|there| *there)?;
    // Faults further down are left to the reader.
    let read = yaml.object(tr_later!("an object"), |yaml, key| {
        keys.push(key.to_owned());
        yaml.skip()
    });
    (read.is_ok() || !keys.is_empty()).then_some(keys)
}
