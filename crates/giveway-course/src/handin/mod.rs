//! Handing in a lesson: what a learner has done, as a file that a mail survives, or a link.
//!
//! - [`HandIn`], [`Work`], [`Answer`], [`Edits`]: what is in it. It holds no lesson and no
//!   scene: edits are differences from the scene of the lesson that the lecturer has;
//! - [`Sum`]: what a lesson is known by, in any language;
//! - [`write()`], [`read()`]: the file; [`link`]: the same as a part of an address;
//! - [`hand_in`]: made of a learner's [`crate::learner::Progress`];
//! - [`Form`], [`Card`]: what a learner sees of it before;
//! - [`Shown`]: a task's work laid on the lesson again, for judges and to be looked at.
//!
//! Nothing in it is believed: [`crate::grade`] judges each answer anew.

mod answer;
mod apply;
mod bounds;
mod cards;
mod edits;
mod form;
pub mod link;
mod made;
mod read;
mod shown;
mod sum;
mod unwrap;
mod words;
mod work;
mod wrap;

use giveway_model::{Version, object_only};
use serde::{Deserialize, Serialize};

use crate::lesson::Id;

pub use answer::Answer;
pub use apply::NoFit;
pub use bounds::{MAX_BYTES, MAX_NAME, MAX_TRIES};
pub use cards::{Card, CardState, cards, summary};
pub use edits::{CellEdit, Edits};
pub use form::{Done, Form, FormAction, FormEffect, Subject};
pub use made::hand_in;
pub use read::read;
pub use shown::{Misfit, Shown};
pub use sum::Sum;
pub use words::answer_words;
pub use work::Work;
pub use wrap::write;

pub(crate) use bounds::is_plain;
pub(crate) use made::work_of;
pub(crate) use work::{is_fit, is_old};

/// What a learner hands in of one lesson.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct HandIn {
    /// The version of the format.
    pub giveway: Version,
    /// The lesson.
    pub hand_in: OfLesson,
    /// Who hands it in, as they like to say; it cannot be checked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// What was done for its tasks, in the order of the steps.
    pub tasks: Vec<Work>,
}

object_only!(HandIn);

/// The lesson of a hand-in.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct OfLesson {
    /// Its short name.
    pub lesson: Id,
    /// What it is called, in the learner's language.
    pub title: String,
    /// What it is known by.
    pub sum: Sum,
}

object_only!(OfLesson);

impl HandIn {
    /// What was done for the task of a step, from 0.
    pub fn work(&self, step: usize) -> Option<&Work> {
        self.tasks.iter().find(|work| work.step == step)
    }

    /// The name of its file: `room-to-pass-ada.json`.
    ///
    /// ```
    /// use giveway_course::handin::{HandIn, read};
    /// let text = r#"{ "giveway": 1, "name": "Ada L.", "tasks": [],
    ///   "hand-in": { "lesson": "room-to-pass", "title": "Room to pass", "sum": "00000000000000a7" } }"#;
    /// let mut hand_in = read(text).unwrap();
    /// assert_eq!(hand_in.file_name(), "room-to-pass-ada-l.json");
    /// hand_in.hand_in.lesson = "own-00000000000000a7".parse().unwrap();
    /// hand_in.hand_in.title = "Let me through!".to_owned();
    /// assert_eq!(hand_in.file_name(), "let-me-through-ada-l.json");
    /// ```
    pub fn file_name(&self) -> String {
        // A lesson of one's own has a number for a name.
        let lesson = match &self.hand_in.lesson {
            own if own.is_own() => hyphened(&self.hand_in.title).chars().take(TITLE).collect(),
            lesson => lesson.to_string(),
        };
        let name = hyphened(self.name.as_deref().unwrap_or_default());
        let parts: Vec<String> = [lesson, name]
            .into_iter()
            .filter(|part| !part.is_empty())
            .collect();
        match parts.join("-") {
            name if name.is_empty() => "hand-in.json".to_owned(),
            name => format!("{name}.json"),
        }
    }
}

/// The most characters of a lesson's title in the name of a file.
const TITLE: usize = 40;

/// Letters and digits of a text in small letters, with a hyphen between its words.
fn hyphened(text: &str) -> String {
    let small = text.to_lowercase();
    let words = small.split(|c: char| !c.is_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join("-")
}
