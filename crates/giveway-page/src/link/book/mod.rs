//! All that the browser keeps of a page: the document with its past, so that what
//! was done can be undone after the page was loaded again.
//!
//! A line each; what several documents have in common stands in it once:
//!
//! ```text
//! giveway-kept=2
//! =map=10.2f6s...          a part; parts are numbered from 0 as they come
//! +7.agent1:0.1.2          a document: time, selection, its parts; the present one first
//! touched                  something was done to it
//! displaced                a link took the place of the document before
//! ```

mod read;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use giveway_model::Cell;

use super::{From, LONGEST, document};
use crate::history::Moment;
use crate::state::{By, Displaced};
use crate::{Selection, State};

pub use read::{kept, kept_elsewhere, kept_moment};

/// What stands first; another number is another format.
pub(super) const HEAD: &str = "giveway-kept=2";

/// The line that tells of a link.
const DISPLACED: &str = "displaced";

/// The state as this browser keeps it: the document and as much of its past as
/// there is room for.
pub fn keep(state: &State) -> String {
    let state = state.own();
    let mut book = Book {
        text: format!("{HEAD}\n"),
        ..Book::default()
    };
    book.write(&state.moment());
    if let (Some(Displaced { by, moment }), Some(last)) =
        (&state.displaced, state.history.past().last())
        && *by == By::Link
        && moment.document == last.document
    {
        book.text += DISPLACED;
        book.text.push('\n');
    }
    if state.history.is_touched() {
        book.text += "touched\n";
        for moment in state.history.past().iter().rev() {
            let before = book.text.len();
            book.write(moment);
            if book.text.len() > LONGEST {
                book.text.truncate(before);
                break;
            }
        }
    }
    book.text
}

/// A document without its past, as this browser keeps it.
pub fn keep_moment(moment: &Moment) -> String {
    let mut book = Book {
        text: format!("{HEAD}\n"),
        ..Book::default()
    };
    book.write(moment);
    book.text
}

#[derive(Default)]
struct Book {
    text: String,
    parts: BTreeMap<String, usize>,
}

impl Book {
    fn write(&mut self, moment: &Moment) {
        let text = document::write(&moment.document, From::Here);
        let mut places = Vec::new();
        for part in text.split('&') {
            let next = self.parts.len();
            let place = *self.parts.entry(part.to_owned()).or_insert_with(|| {
                self.text.push('=');
                self.text += part;
                self.text.push('\n');
                next
            });
            places.push(place.to_string());
        }
        let selection = match moment.selection {
            Selection::Nothing => "-".to_owned(),
            Selection::Agent(agent) => format!("a{agent}"),
            Selection::Cell(Cell { x, y }) => format!("c{x}:{y}"),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            self.text,
            "+{}.{selection}.{}",
            moment.time,
            places.join(".")
        );
    }
}
