//! Where a file writes something, for a fault that only shows when the whole is put
//! together.

use super::Pair;
use giveway_model::Fault;
use giveway_model::format::locate::{Locator, segments};
use giveway_model::format::text::{Positions, without_mark};

/// A place in the text of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WrittenAt {
    /// The file as a whole.
    Whole,
    /// A byte, from 0, behind a byte order mark.
    Byte(usize),
    /// A line and a column, both from 1.
    Line(usize, usize),
    /// An entry of a list in JSON, from 0: of the keys on the way to the list.
    Entry(&'static str, usize),
}

/// A cell that a file tells of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrittenCell {
    /// The cell as it is written.
    pub pair: Pair,
    /// Where it is written.
    pub at: WrittenAt,
}

/// Gives faults their lines and columns in one text, quickest in ascending order.
pub(super) struct Places<'a> {
    text: &'a str,
    positions: Positions<'a>,
    /// Only for JSON, which it has to read again.
    locator: Option<Locator<'a>>,
}

impl<'a> Places<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let text = without_mark(text);
        Self {
            text,
            positions: Positions::new(text),
            locator: None,
        }
    }

    /// The fault with its line and column; in JSON with the keys of the file, too.
    pub(super) fn place(&mut self, at: WrittenAt, fault: Fault) -> Fault {
        let (fault, (line, column)) = match at {
            WrittenAt::Whole => (fault, (1, 1)),
            WrittenAt::Line(line, column) => (fault, (line, column)),
            WrittenAt::Byte(offset) => (fault, self.positions.of(offset)),
            WrittenAt::Entry(list, index) => {
                let place = format!("{list}[{index}]");
                let text = self.text;
                let locator = self.locator.get_or_insert_with(|| Locator::new(text));
                let offset = locator.find(&segments(&place), false);
                let position = self.positions.of(offset.unwrap_or_default());
                (Fault { place, ..fault }, position)
            }
        };
        fault.in_text(line, column)
    }
}
