//! The events of a YAML text, with aliases (`*name`) replaced by what they stand for.
//!
//! An anchored value (`&name`) is kept as its events. A few aliases of aliases may stand for
//! more values than there is memory, so no more events are replayed than any file needs.

use std::collections::{BTreeMap, VecDeque};

use saphyr_parser::{Event, Parser, Span, StrInput};

/// The most events that are kept, and the most that are replayed.
const MAX_EVENTS: usize = 1_000_000;

/// A line and a column, both from 1.
type At = (usize, usize);

/// An event and where it begins.
type Placed<'a> = (Event<'a>, At);

/// Why there is no next event.
pub(super) struct Broken {
    pub(super) at: At,
    pub(super) why: Why,
}

/// The kind of fault.
pub(super) enum Why {
    /// The text is no YAML.
    Text(String),
    /// Aliases stand for too much, or for nothing.
    Aliases,
}

/// The events of a text.
pub(super) struct Events<'a> {
    parser: Parser<'a, StrInput<'a>>,
    /// Events that come before those of the parser: of an alias, or looked at already.
    ahead: VecDeque<Placed<'a>>,
    /// Anchored values that are open: the anchor, how deep it is, its events so far.
    open: Vec<(usize, usize, Vec<Placed<'a>>)>,
    known: BTreeMap<usize, Vec<Placed<'a>>>,
    kept: usize,
    replayed: usize,
}

impl<'a> Events<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            parser: Parser::new_from_str(text),
            ahead: VecDeque::new(),
            open: Vec::new(),
            known: BTreeMap::new(),
            kept: 0,
            replayed: 0,
        }
    }

    /// The next event, which stays the next one.
    ///
    /// # Errors
    /// Where the text is broken.
    pub(super) fn peek(&mut self) -> Result<Option<(&Event<'a>, At)>, Broken> {
        if self.ahead.is_empty()
            && let Some(next) = self.parsed()?
        {
            self.ahead.push_front(next);
        }
        Ok(self.ahead.front().map(|(event, at)| (event, *at)))
    }

    /// The next event.
    ///
    /// # Errors
    /// Where the text is broken.
    pub(super) fn next(&mut self) -> Result<Option<Placed<'a>>, Broken> {
        match self.ahead.pop_front() {
            Some(next) => Ok(Some(next)),
            None => self.parsed(),
        }
    }

    /// The next event of the parser; of an alias the first event of its value.
    fn parsed(&mut self) -> Result<Option<Placed<'a>>, Broken> {
        let (event, at) = match self.parser.next_event() {
            Some(Ok((event, span))) => (event, begin(&span)),
            Some(Err(error)) => {
                let mark = error.marker();
                return Err(Broken {
                    at: (mark.line().max(1), mark.col() + 1),
                    why: Why::Text(error.info().to_owned()),
                });
            }
            None => return Ok(None),
        };
        let Event::Alias(anchor) = event else {
            self.keep(&event, at)?;
            return Ok(Some((event, at)));
        };
        let aliases = Broken {
            at,
            why: Why::Aliases,
        };
        let Some(value) = self.known.get(&anchor) else {
            return Err(aliases);
        };
        self.replayed += value.len();
        if self.replayed > MAX_EVENTS {
            return Err(aliases);
        }
        // Where the alias stands is the place of all of its value.
        let value: Vec<Placed<'a>> = value.iter().map(|(event, _)| (event.clone(), at)).collect();
        for (event, at) in &value {
            self.keep(event, *at)?;
        }
        self.ahead.extend(value);
        Ok(self.ahead.pop_front())
    }

    /// Keeps an event for the anchored values that are open, and opens one at an anchor.
    fn keep(&mut self, event: &Event<'a>, at: At) -> Result<(), Broken> {
        let (anchor, step) = match event {
            Event::Scalar(_, _, anchor, _) => (*anchor, 0),
            Event::SequenceStart(anchor, _) | Event::MappingStart(anchor, _) => (*anchor, 1),
            Event::SequenceEnd | Event::MappingEnd => (0, -1),
            _ => return Ok(()),
        };
        if anchor != 0 {
            self.open.push((anchor, 0, Vec::new()));
        }
        self.kept += self.open.len();
        if self.kept > MAX_EVENTS {
            return Err(Broken {
                at,
                why: Why::Aliases,
            });
        }
        for (_, depth, events) in &mut self.open {
            *depth = depth.saturating_add_signed(step);
            events.push((event.clone(), at));
        }
        while self.open.last().is_some_and(|(_, depth, _)| *depth == 0) {
            if let Some((anchor, _, events)) = self.open.pop() {
                self.known.insert(anchor, events);
            }
        }
        Ok(())
    }
}

fn begin(span: &Span) -> At {
    (span.start.line().max(1), span.start.col() + 1)
}
