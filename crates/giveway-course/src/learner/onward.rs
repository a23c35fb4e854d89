//! Which lesson of a course comes next.

use super::{Progress, Stage};
use crate::lesson::{Course, Entry};

/// The name of the next lesson among what the page can open of the course; no [`Id`] has it.
///
/// [`Id`]: crate::lesson::Id
pub const NEXT: &str = "~next";

/// Which lesson comes next, and in which words it is offered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Onward<'a> {
    /// Nothing was begun yet: the first one.
    Start(&'a Entry),
    /// A lesson that was begun, else the first one that is new, else the first one of
    /// which tasks are left.
    GoOn(&'a Entry),
    /// All are done: the first one again.
    Again(&'a Entry),
}

impl<'a> Onward<'a> {
    /// What comes next in a course; `None` where it has no lesson.
    pub fn of(course: &'a Course, progress: &Progress) -> Option<Self> {
        let stage = |entry: &&Entry| progress.stage(&entry.lesson);
        let begun = |entry: &&Entry| matches!(stage(entry), Stage::Begun(_));
        let first = course.lessons().next()?;
        if course.lessons().all(|entry| stage(&entry) == Stage::New) {
            return Some(Self::Start(first));
        }
        let new = || course.lessons().find(|entry| stage(entry) == Stage::New);
        let left = || course.lessons().find(|entry| stage(entry) != Stage::Done);
        let next = course.lessons().find(begun).or_else(new).or_else(left);
        Some(next.map_or(Self::Again(first), Self::GoOn))
    }

    /// The lesson.
    pub const fn entry(self) -> &'a Entry {
        match self {
            Self::Start(entry) | Self::GoOn(entry) | Self::Again(entry) => entry,
        }
    }
}
