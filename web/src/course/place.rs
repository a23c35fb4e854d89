//! A place in the course, as it stands in an address: `room-to-pass.3`; and what waits until
//! it is there.

use giveway_course::lesson::Id;

/// A lesson, and perhaps a step of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// The lesson.
    pub(super) lesson: Id,
    /// The step, from 0; where it was left, if there is none.
    pub(super) step: Option<usize>,
}

/// What is to be opened as soon as it is there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// A place.
    Place(Place),
    /// The lesson that comes next.
    Next,
}

impl Place {
    /// Reads an address; `None` where it names no lesson. Steps are counted from 1 there.
    pub(super) fn read(address: &str) -> Option<Self> {
        let (lesson, step) = match address.split_once('.') {
            Some((lesson, step)) => (lesson, step.parse::<usize>().ok()),
            None => (address, None),
        };
        Some(Self {
            lesson: lesson.parse().ok()?,
            step: step.and_then(|step| step.checked_sub(1)),
        })
    }
}
