//! A lesson while somebody writes it: a draft, with a pure reducer.
//!
//! A [`Draft`] may be as unfinished as a sentence that is being typed. What is written
//! in it are words under the names of fields; a field's name is its place in the file
//! of a lesson, so that a fault of the reader belongs to a field. Which fields there
//! are, [`form()`] says as data. A draft becomes a [`Lesson`] only when nothing is wrong
//! with it ([`Draft::look`]), and a lesson becomes a draft again ([`Draft::of`]). Before it
//! is shared, the solver tries its tasks ([`check`]).
//!
//! [`Lesson`]: crate::lesson::Lesson

mod action;
mod build;
pub mod check;
mod choices;
mod fault;
mod field;
mod form;
mod keep;
mod look;
mod of;
mod reduce;
mod sentence;
mod tasks;
mod undo;

use std::collections::BTreeMap;

use giveway_model::{Plan, Scene, Version};
use serde::{Deserialize, Serialize};

pub use action::{Action, Whose};
pub use fault::{FormFault, Wrong, field_of};
pub use field::{Field, Input, Part, Pick};
pub use form::{form, head};
pub use look::Looked;
pub use reduce::reduce;
pub use sentence::{ToDo, sentence};
pub use undo::Undo;

/// What is written, by the names of fields. What was written for another kind of task
/// stays, and is there again when that kind is chosen again.
pub type Words = BTreeMap<String, String>;

/// The most characters of a field.
pub const MAX_FIELD: usize = 20_000;

/// The field that says which kind of task a step has.
const KIND: &str = "task.kind";
/// The field that says how many answers there are.
const ANSWERS: &str = "task.answers";
/// The field that says which plan a step shows.
const PLAN: &str = "plan";
/// What a switch that is on has written.
const YES: &str = "yes";

/// A lesson while it is written. It has at least one step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Draft {
    /// The version of the format.
    giveway: Version,
    /// What is written of the lesson as a whole.
    words: Words,
    /// The steps.
    steps: Vec<StepDraft>,
    /// The step that is shown, from 0.
    at: usize,
    /// What can be undone, the last thing last.
    #[serde(skip)]
    undo: Vec<Undo>,
    /// The key of the next step.
    #[serde(skip)]
    next: u32,
}

/// A step while it is written.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StepDraft {
    /// What tells it from the other steps, wherever it is moved.
    #[serde(skip)]
    key: u32,
    /// What is written.
    words: Words,
    /// Its scene; the one before stays, where it has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    scene: Option<Scene>,
    /// Its plan, as it was taken from the page.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    plan: Option<Plan>,
}

impl Default for Draft {
    fn default() -> Self {
        let mut draft = Self {
            giveway: Version,
            words: Words::new(),
            steps: vec![StepDraft::default()],
            at: 0,
            undo: Vec::new(),
            next: 0,
        };
        draft.words.insert("minutes".to_owned(), "5".to_owned());
        draft.mend();
        draft
    }
}

impl Draft {
    /// What is written of the lesson as a whole.
    pub const fn words(&self) -> &Words {
        &self.words
    }

    /// The steps.
    pub fn steps(&self) -> &[StepDraft] {
        &self.steps
    }

    /// The step that is shown, from 0.
    pub const fn at(&self) -> usize {
        self.at
    }

    /// The step that is shown.
    pub fn step(&self) -> Option<&StepDraft> {
        self.steps.get(self.at)
    }

    /// The scene on the board at a step: its own, or the last one before it.
    pub fn scene(&self, step: usize) -> Option<&Scene> {
        let steps = self.steps.get(..=step)?;
        steps.iter().rev().find_map(|step| step.scene.as_ref())
    }

    /// What can be undone, if anything can.
    pub fn can_undo(&self) -> Option<&Undo> {
        self.undo.last()
    }

    /// Whether nothing was written yet.
    pub fn is_empty(&self) -> bool {
        let is_blank = self.steps.iter().all(StepDraft::is_empty);
        self.words == Self::default().words && self.steps.len() == 1 && is_blank
    }

    /// Whether the same is written in both.
    fn is_like(&self, other: &Self) -> bool {
        let same = |(one, two): (&StepDraft, &StepDraft)| {
            (&one.words, &one.scene, &one.plan) == (&two.words, &two.scene, &two.plan)
        };
        let is_as_long = self.steps.len() == other.steps.len();
        let mut steps = self.steps.iter().zip(&other.steps);
        self.words == other.words && is_as_long && steps.all(same)
    }
}

impl StepDraft {
    /// What tells it from the other steps, wherever it is moved.
    pub const fn key(&self) -> u32 {
        self.key
    }

    /// Whether nothing was written yet.
    pub fn is_empty(&self) -> bool {
        self.words.is_empty() && self.scene.is_none() && self.plan.is_none()
    }

    /// What is written.
    pub const fn words(&self) -> &Words {
        &self.words
    }

    /// What is written in a field; nothing, where nothing is.
    pub fn word(&self, field: &str) -> &str {
        self.words.get(field).map_or("", String::as_str)
    }

    /// Its scene.
    pub const fn scene(&self) -> Option<&Scene> {
        self.scene.as_ref()
    }

    /// Its plan, as it was taken from the page.
    pub const fn plan(&self) -> Option<&Plan> {
        self.plan.as_ref()
    }
}
