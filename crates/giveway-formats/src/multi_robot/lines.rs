//! Reads a schedule line by line, if it is to the letter what the programs of the
//! library print.
//!
//! ```text
//! statistics:          may be missing; a key and a number on each line
//!   cost: 12
//! schedule:
//!   agent0:            then a state at least
//!     - x: 0
//!       y: 0
//!       t: 0
//! ```
//!
//! A large schedule is nearly always that, and is read some thirty times as fast as by
//! a parser of all of YAML. Of anything else this reader knows nothing: blank lines,
//! comments, other blanks, `\r\n`, numbers with a plus, whatever is wrong. Then the
//! file is for the parser, which tells the faults.

use std::collections::BTreeSet;
use std::str::FromStr;

use super::schedule::{Track, claim, gaps};
use crate::limits::Steps;
use crate::unknown_keys::is_harmless;
use crate::{WrittenAgent, WrittenAt};
use giveway_model::compare::Claimed;

/// Where the name of an agent begins in its line.
const COLUMN: usize = 3;

/// The longest number or key that is read, in bytes.
const MAX_RUN: usize = 40;

/// The agents of a schedule, what the file claims, and that times are missing; `None` where the text is not
/// of this shape, or not a schedule that is accepted.
pub(super) fn read(text: &str) -> Option<(Vec<WrittenAgent>, Claimed, Option<String>)> {
    let mut lines = Lines {
        rest: text,
        number: 1,
    };
    let mut claimed = Claimed::default();
    if lines.take("statistics:\n") {
        statistics(&mut lines, &mut claimed)?;
    }
    lines.take("schedule:\n").then_some(())?;
    let mut steps = Steps::default();
    let mut names = BTreeSet::new();
    let mut agents = Vec::new();
    let mut with_gaps = Vec::new();
    while !lines.rest.is_empty() {
        let at = WrittenAt::Line(lines.number, COLUMN);
        lines.take("  agent").then_some(())?;
        let name = lines.digits(":\n")?;
        names.insert(name).then_some(())?;
        let mut track = Track::default();
        while lines.take("    - x: ") {
            let x = lines.whole("\n      y: ")?;
            let y = lines.whole("\n      t: ")?;
            let time = lines.digits("\n")?.parse().ok()?;
            track.push(x, y, time, &mut steps).ok()?;
        }
        if track.has_gaps {
            with_gaps.push(format!("agent{name}"));
        }
        // No state at all is nothing in YAML, and no list.
        let walk = track.walk()?;
        agents.push(WrittenAgent {
            name: Some(format!("agent{name}")),
            ..WrittenAgent::walking(walk, at)
        });
    }
    (!agents.is_empty()).then_some((agents, claimed, gaps(with_gaps)))
}

/// Reads lines of keys with numbers, one at least.
fn statistics(lines: &mut Lines<'_>, claimed: &mut Claimed) -> Option<()> {
    let mut is_empty = true;
    while lines.take("  ") {
        let key = lines.run(|byte| byte.is_ascii_alphabetic(), ": ")?;
        // A key that may mean something is for the parser, which names it.
        let is_known = matches!(key, "cost" | "makespan") || is_harmless(key);
        is_known.then_some(())?;
        let number = lines.run(
            |byte| matches!(byte, b'0'..=b'9' | b'.' | b'e' | b'-'),
            "\n",
        )?;
        number
            .starts_with(|c: char| c.is_ascii_digit())
            .then_some(())?;
        claim(claimed, key, number);
        is_empty = false;
    }
    (!is_empty).then_some(())
}

/// The rest of a text.
struct Lines<'a> {
    rest: &'a str,
    /// The number of its first line, from 1.
    number: usize,
}

impl<'a> Lines<'a> {
    /// Passes over some letters if they come next.
    fn take(&mut self, letters: &str) -> bool {
        match self.rest.strip_prefix(letters) {
            Some(rest) => {
                self.rest = rest;
                self.number += usize::from(letters.contains('\n'));
                true
            }
            None => false,
        }
    }

    /// Bytes of a kind, one at least, and what must follow them. Long ones are left to
    /// the parser: a key of YAML has an end.
    fn run(&mut self, is_of_it: impl Fn(u8) -> bool, then: &str) -> Option<&'a str> {
        let length = self.rest.bytes().position(|byte| !is_of_it(byte))?;
        let (run, rest) = self.rest.split_at_checked(length)?;
        self.rest = rest;
        ((1..=MAX_RUN).contains(&length) && self.take(then)).then_some(run)
    }

    fn digits(&mut self, then: &str) -> Option<&'a str> {
        self.run(|byte| byte.is_ascii_digit(), then)
    }

    /// A number with or without a minus.
    fn whole<T: FromStr>(&mut self, then: &str) -> Option<T> {
        let whole = self.run(|byte| byte.is_ascii_digit() || byte == b'-', then)?;
        whole.parse().ok()
    }
}
