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
    /// assert_eq!(read(text).unwrap().file_name(), "room-to-pass-ada-l.json");
    /// ```
    pub fn file_name(&self) -> String {
        let mut name = self.hand_in.lesson.to_string();
        let words = self.name.as_deref().unwrap_or_default().to_lowercase();
        let plain = |c: &char| c.is_alphanumeric();
        let mut is_open = true;
        for c in words.chars() {
            if plain(&c) {
                if std::mem::take(&mut is_open) {
                    name.push('-');
                }
                name.push(c);
            } else {
                is_open = true;
            }
        }
        name.push_str(".json");
        name
    }
}
