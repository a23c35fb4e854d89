//! A file of a class, and what is wrong with those that are none.

use giveway_model::{Fault, tr};

use super::Graded;
use crate::handin::HandIn;

/// A file, or a link, that was given.
#[derive(Clone, Debug, PartialEq)]
pub struct Filed {
    /// What it is called.
    pub file: String,
    /// When it was changed last, in seconds from any time on; a link has none.
    pub date: Option<u64>,
    /// The hand-in, else why it is none.
    pub(super) content: Result<Content, Unread>,
}

/// A hand-in of a lesson that is known.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Content {
    pub(super) hand_in: HandIn,
    /// The lesson, by its place among those that were given.
    pub(super) lesson: usize,
    /// Its tasks, in the order of the lesson.
    pub(super) tasks: Vec<Graded>,
}

/// Why a file is not judged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unread {
    /// It cannot be read.
    Fault(Fault),
    /// It is of a lesson that was not given, or of another edition of one that was.
    OtherLesson {
        /// The hand-in, for when its lesson is given.
        hand_in: Box<HandIn>,
        /// Whether a lesson of that short name was given.
        is_edition: bool,
    },
}

impl Unread {
    /// It as a phrase: what it is, and what to do.
    pub fn words(&self) -> String {
        match self {
            Self::Fault(fault) => fault.to_string(),
            Self::OtherLesson {
                hand_in,
                is_edition,
            } => {
                let title = hand_in.hand_in.title.as_str();
                if *is_edition {
                    tr!(
                        "of another edition of the lesson \"{title}\"; give the lesson that was handed out",
                        title
                    )
                } else {
                    tr!(
                        "of another lesson, \"{title}\"; give that lesson, too",
                        title
                    )
                }
            }
        }
    }
}

impl Filed {
    /// The hand-in, where it can be read and its lesson is known.
    pub fn hand_in(&self) -> Option<&HandIn> {
        let content = self.content.as_ref().ok();
        content.map(|content| &content.hand_in)
    }

    /// Why it is not judged, where it is not.
    pub fn unread(&self) -> Option<&Unread> {
        self.content.as_ref().err()
    }

    /// Its lesson, by its place among those that were given.
    pub fn lesson(&self) -> Option<usize> {
        self.content.as_ref().ok().map(|content| content.lesson)
    }

    /// Its tasks, in the order of the lesson.
    pub fn tasks(&self) -> &[Graded] {
        let content = self.content.as_ref().ok();
        content.map_or(&[], |content| content.tasks.as_slice())
    }
}
