//! The faults of a draft as data, and the field that each belongs to.

use giveway_model::Fault;

use super::Field;
use crate::lesson::read::{Flaw, LessonFault, Place};
use crate::lesson::text::MarkupError;

/// A fault of a draft.
#[derive(Clone, Debug, PartialEq)]
pub struct FormFault {
    /// Where it is.
    pub place: Place,
    /// What is wrong.
    pub wrong: Wrong,
}

/// What is wrong with a draft.
#[derive(Clone, Debug, PartialEq)]
pub enum Wrong {
    /// A field is empty that must not be.
    Missing,
    /// The text is no whole number.
    NotNumber,
    /// The text is no cell.
    NotCell,
    /// The text is no list of cells.
    NotCells,
    /// The text is no question, for this reason.
    NotQuestion(String),
    /// The text is no file of changes.
    NotChanges(Fault),
    /// The field has a value that is none of its choices.
    NotChoice,
    /// The markup of a paragraph is broken.
    Markup(MarkupError),
    /// The lesson has a fault that a file could have, too.
    Flaw(Flaw),
}

impl FormFault {
    /// Whether the fault only says that something is not written yet.
    pub const fn is_missing(&self) -> bool {
        matches!(self.wrong, Wrong::Missing)
    }
}

impl From<LessonFault> for FormFault {
    fn from(fault: LessonFault) -> Self {
        let LessonFault { mut place, flaw } = fault;
        if flaw == Flaw::NoRightAnswer {
            // It is mended at a switch, not at the text of an answer.
            place.field.push_str("[0].right");
        }
        let wrong = Wrong::Flaw(flaw);
        Self { place, wrong }
    }
}

/// The field of a form that a place belongs to: the one with the longest name that holds
/// the place, else the first field within the place.
pub fn field_of<'a>(fields: &'a [Field], place: &Place) -> Option<&'a Field> {
    let at = place.field.as_str();
    if at.is_empty() {
        return None;
    }
    let holding = fields.iter().filter(|field| is_within(at, &field.name));
    let closest = holding.max_by_key(|field| field.name.len());
    closest.or_else(|| fields.iter().find(|field| is_within(&field.name, at)))
}

/// Whether a name is another one, or of a part of it.
pub(super) fn is_within(name: &str, whole: &str) -> bool {
    let rest = name.strip_prefix(whole);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}
