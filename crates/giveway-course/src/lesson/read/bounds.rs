//! How large the parts of a file may be, and the faults that are gathered.

use giveway_model::{Fault, format::native, tr};

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
/// The most lessons of a course.
pub const MAX_LESSONS: usize = 200;
/// The most terms of a glossary.
pub const MAX_TERMS: usize = 1000;

/// The most faults that are told of one file.
const MAX_FAULTS: usize = 100;

/// Faults of a file, gathered.
#[derive(Default)]
pub(super) struct Faults(Vec<Fault>);

impl Faults {
    pub(super) fn add(
        &mut self,
        place: impl Into<String>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) {
        self.push(Fault::at(place, found, expected));
    }

    pub(super) fn push(&mut self, fault: Fault) {
        if self.0.len() < MAX_FAULTS {
            self.0.push(fault);
        }
    }

    /// A list must have at most so many entries.
    pub(super) fn few(&mut self, place: &str, count: usize, most: usize, things: &str) {
        if count > most {
            self.add(
                place,
                format!("{count} {things}"),
                tr!("at most {most}", most),
            );
        }
    }

    /// A name must be there, and short.
    pub(super) fn title(&mut self, place: &str, title: &str) {
        if title.trim().is_empty() {
            self.add(place, tr!("no words"), tr!("a title"));
        }
        let length = title.chars().count();
        self.few(place, length, MAX_TITLE, tr!("counted" => "characters"));
        if title.chars().any(char::is_control) {
            self.add(place, tr!("a control character"), tr!("one line of text"));
        }
    }

    /// A number must be within bounds.
    pub(super) fn range(&mut self, place: &str, number: u32, least: u32, most: u32) {
        if !(least..=most).contains(&number) {
            self.add(
                place,
                number.to_string(),
                tr!("{least} to {most}", least, most),
            );
        }
    }

    /// All of them.
    pub(super) fn all(self) -> Vec<Fault> {
        self.0
    }

    /// What was read, where nothing is wrong with it.
    pub(super) fn or<T>(self, value: T, text: &str) -> Result<T, Vec<Fault>> {
        if self.0.is_empty() {
            Ok(value)
        } else {
            Err(native::in_text(text, self.0))
        }
    }
}
