//! What was done for the task of one step.

use giveway_model::object_only;
use serde::{Deserialize, Serialize};

use super::answer::from_one;
use super::{Answer, Edits, Sum, bounds};
use crate::lesson::Lesson;

/// What was done for the task of a step.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Work {
    /// The step, from 0; in the file the first step is 1, as on the page.
    #[serde(with = "from_one")]
    pub step: usize,
    /// How the board differed from the scene of the lesson when the answer was given: where
    /// the step went on with a board that was edited before, or was answered about a board
    /// that it lets a person edit. What a `paint` task itself asks for is its answer.
    #[serde(default, skip_serializing_if = "Edits::is_empty")]
    pub board: Edits,
    /// The last answer; the one that was taken as solved, where one was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub answer: Option<Answer>,
    /// The first answer, where that was another one: of what was predicted or picked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first: Option<Answer>,
    /// Whether the page took it as solved.
    pub solved: bool,
    /// How many answers were judged up to that one.
    pub tries: u32,
}

object_only!(Work);

impl Work {
    /// About how many letters the answers take in a file.
    pub(crate) fn letters(&self) -> usize {
        let answers = self.answer.iter().chain(&self.first);
        self.board.letters() + answers.map(Answer::letters).sum::<usize>()
    }
}

/// Whether work is small enough to be kept in a browser.
pub(crate) fn is_fit(work: &Work) -> bool {
    work.letters() <= bounds::MAX_WORK && bounds::check(work).is_none()
}

/// Whether work is of a step that was edited since.
pub(crate) fn is_old(lesson: &Lesson, step: usize, sum: Sum) -> bool {
    Sum::of_step(lesson, step) != Some(sum)
}
