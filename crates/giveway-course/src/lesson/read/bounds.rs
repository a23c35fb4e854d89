//! How large the parts of a file may be, and the faults that are gathered.

use giveway_model::{Fault, format::native};

use super::{Flaw, LessonFault, Place, Things};

/// The most bytes of a file.
pub const MAX_BYTES: usize = 1 << 20;
/// The most steps of a lesson.
pub const MAX_STEPS: usize = 30;
/// The most minutes of a lesson.
pub const MAX_MINUTES: u32 = 90;
/// The most characters of a title.
pub const MAX_TITLE: usize = 60;
/// The most paragraphs of a step.
pub const MAX_PARAGRAPHS: usize = 8;
/// The most hints of a task.
pub const MAX_HINTS: usize = 3;
/// The most answers of a task, and the most methods.
pub const MAX_ANSWERS: usize = 6;
/// The most edits of a step.
pub const MAX_EDITS: u32 = 1000;
/// The most cells that a step names.
pub const MAX_CELLS: usize = 4096;
/// The latest time that is shown.
pub const MAX_TIME: u32 = 10_000;
/// The most robots all of whose orders can be tried.
pub const MAX_ORDERED: usize = 4;
/// The most robots of which it is asked who is first at a cell.
pub const MAX_FIRST: usize = 8;
/// The most lessons of a course.
pub const MAX_LESSONS: usize = 200;
/// The most terms of a glossary.
pub const MAX_TERMS: usize = 1000;

/// The most faults that are told of one file.
const MAX_FAULTS: usize = 100;

/// Faults of a file, gathered.
#[derive(Default)]
pub(super) struct Faults {
    all: Vec<LessonFault>,
    /// The step that is looked at; places are those of its fields.
    pub(super) step: Option<usize>,
}

impl Faults {
    pub(super) fn add(&mut self, field: impl Into<String>, flaw: Flaw) {
        if self.all.len() < MAX_FAULTS {
            let place = Place {
                step: self.step,
                field: field.into(),
            };
            self.all.push(LessonFault { place, flaw });
        }
    }

    /// A list must have at most so many entries.
    pub(super) fn few(&mut self, field: &str, count: usize, most: usize, things: Things) {
        if count > most {
            let flaw = Flaw::TooMany {
                things,
                count,
                most,
            };
            self.add(field, flaw);
        }
    }

    /// A name must be there, and short.
    pub(super) fn title(&mut self, field: &str, title: &str) {
        if title.trim().is_empty() {
            self.add(field, Flaw::NoTitle);
        }
        let length = title.chars().count();
        self.few(field, length, MAX_TITLE, Things::Characters);
        if title.chars().any(char::is_control) {
            self.add(field, Flaw::ControlCharacter);
        }
    }

    /// A number must be within bounds.
    pub(super) fn range(&mut self, field: &str, number: u32, least: u32, most: u32) {
        if !(least..=most).contains(&number) {
            let flaw = Flaw::OutOfRange {
                number,
                least,
                most,
            };
            self.add(field, flaw);
        }
    }

    /// All of them.
    pub(super) fn all(self) -> Vec<LessonFault> {
        self.all
    }

    /// What was read, where nothing is wrong with it.
    pub(super) fn or<T>(self, value: T, text: &str) -> Result<T, Vec<Fault>> {
        if self.all.is_empty() {
            return Ok(value);
        }
        let faults = self.all.into_iter().map(LessonFault::in_file_words);
        Err(native::in_text(text, faults.collect()))
    }
}
