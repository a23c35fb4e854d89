//! A lesson as data: steps of text with a board and at most one task each.
//!
//! - [`Lesson`], [`Step`]: what a file holds; [`board`] what a step says of the board;
//! - [`task`], [`statement`], [`quantity`]: what there is to do, and what decides it;
//! - [`text`]: the little markup of a paragraph;
//! - [`course`], [`glossary`]: the index of lessons, the terms of the field;
//! - [`read`]: read with distrust, `write`: written for people; [`link`]: as a part of an address;
//! - [`translated`]: the same in the words of another language.

pub mod board;
pub mod course;
pub mod glossary;
mod id;
mod layout;
pub mod link;
mod own;
pub mod quantity;
pub mod read;
pub mod statement;
mod step;
pub mod task;
pub mod text;
mod translate;
mod write;

use giveway_model::{Instance, Scene, Version, object_only};
use serde::{Deserialize, Serialize};

pub use board::{Layer, Tool};
pub use course::{Chapter, Course, Entry, Picture};
pub use glossary::{Glossary, Source, Term};
pub(crate) use id::hash;
pub use id::{BadId, Id};
pub use own::OwnLessons;
pub use quantity::{Quantity, Value};
pub use read::{read_course, read_glossary, read_lesson};
pub use statement::{Comparison, Statement};
pub use step::Step;
pub use task::Task;
pub use text::{Span, Target, Text};
pub use translate::{Find, Worded, keys, translated};
pub(crate) use write::dense as write_dense;
pub use write::{write_course, write_glossary, write_lesson};

/// A lesson: one idea, in a few steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Lesson {
    /// The version of the format.
    pub giveway: Version,
    /// What it is called.
    pub title: String,
    /// How long it takes, in minutes.
    pub minutes: u32,
    /// The idea in one sentence.
    pub about: Text,
    /// Whether hints, replies and the answer are not shown to the learner, who may try
    /// as often as they like.
    #[serde(default, skip_serializing_if = "is_false")]
    pub hides_answers: bool,
    /// The steps; there is at least one, and the first has a scene.
    pub steps: Vec<Step>,
}

object_only!(Lesson);

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_false(value: &bool) -> bool {
    !*value
}

impl Lesson {
    /// The scene with which a step begins where nothing was done before: its own, or
    /// that of the last step before it that has one.
    pub fn scene(&self, step: usize) -> Option<&Scene> {
        let steps = self.steps.get(..=step)?;
        steps.iter().rev().find_map(|step| step.scene.as_ref())
    }

    /// Whether a step goes on with a board that was edited in the step before: it has no
    /// scene and no plan of its own, the board is an instance, and all robots that the
    /// step may name are there.
    pub(crate) fn goes_on_with(&self, step: usize, board: &Scene) -> bool {
        let own = self.steps.get(step);
        let is_own = own.is_none_or(|step| step.scene.is_some() || step.plan.is_some());
        let has = |name: &str| board.agents.iter().any(|agent| agent.name == name);
        let robots = self.scene(step).map(|scene| scene.agents.iter());
        let has_all = robots.is_some_and(|mut robots| robots.all(|robot| has(&robot.name)));
        !is_own && has_all && Instance::new(board.clone()).is_ok()
    }

    /// The lesson as a page of contents shows it, by its first board.
    pub fn entry(&self, id: Id) -> Option<Entry> {
        let first = self.steps.first()?;
        Some(Entry {
            lesson: id,
            title: self.title.clone(),
            minutes: self.minutes,
            steps: u32::try_from(self.steps.len()).ok()?,
            picture: Picture {
                scene: first.scene.clone()?,
                plan: first.plan.clone(),
                time: first.time,
            },
        })
    }

    /// The short name of a lesson that is no part of a course.
    pub fn own_id(&self) -> Id {
        Id::of_content(&write::dense(self))
    }

    /// The JSON Schema (draft 2020-12) of lessons, courses, glossaries and
    /// hand-ins. It refers
    /// to that of scenes and plans ([`giveway_model::format::schema`]).
    pub const fn schema() -> &'static str {
        include_str!("../../schema/lesson.schema.json")
    }
}
