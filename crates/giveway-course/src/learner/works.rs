//! What was done for each task of a lesson, kept so that it can be handed in.

use giveway_model::object_only;
use serde::{Deserialize, Serialize};

use crate::handin::{Answer, Sum, Work, is_fit, is_old};
use crate::judge::{Verdict, Why};
use crate::lesson::Lesson;

/// The last answers to the tasks of a lesson, in the order of the steps.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub(super) struct Works(Vec<Kept>);

/// What was done for a task.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
struct Kept {
    /// What the step was known by: of a step that was edited since it counts no more.
    sum: Sum,
    /// What was done.
    work: Work,
}

object_only!(Kept);

/// What the judge made of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Judged {
    /// Nothing yet.
    Not,
    /// It is a part of an answer, or the answer was asked for: no try.
    Part,
    /// It is a try.
    Tried {
        /// Whether it is taken as solved.
        solved: bool,
    },
}

impl Judged {
    /// What a verdict makes of an answer.
    pub(super) fn by(verdict: &Verdict) -> Self {
        match &verdict.why {
            Why::Untouched
            | Why::Unknown(_)
            | Why::SolverFailed(_)
            | Why::NotHome(_)
            | Why::NotVisited(..)
            | Why::Revealed(_) => Self::Part,
            Why::Found { found, of } if found < of => Self::Part,
            _ => Self::Tried {
                solved: verdict.is_solved(),
            },
        }
    }
}

impl Works {
    pub(super) const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// What was done for tasks that are still the same, in the order of the steps.
    pub(super) fn of(&self, lesson: &Lesson) -> Vec<Work> {
        let kept = self.0.iter();
        let kept = kept.filter(|kept| !is_old(lesson, kept.work.step, kept.sum));
        kept.map(|kept| kept.work.clone()).collect()
    }

    /// Something was done for a task. Once an answer was taken as solved, it stays.
    pub(super) fn add(&mut self, lesson: &Lesson, mut work: Work, judged: Judged) {
        let Some(sum) = Sum::of_step(lesson, work.step) else {
            return;
        };
        let place = self
            .0
            .binary_search_by_key(&work.step, |kept| kept.work.step);
        let before = place.ok().and_then(|place| self.0.get(place));
        if let Some(before) = before.filter(|before| before.sum == sum) {
            if before.work.solved {
                return;
            }
            work.tries = before.work.tries;
            let first = before.work.first.as_ref().or(before.work.answer.as_ref());
            work.first = first.filter(|first| is_told(first, &work)).cloned();
        }
        if let Judged::Tried { solved } = judged {
            work.tries = work.tries.saturating_add(1);
            work.solved = solved;
        }
        if !is_fit(&work) {
            return;
        }
        let kept = Kept { sum, work };
        match place {
            Ok(place) => {
                if let Some(before) = self.0.get_mut(place) {
                    *before = kept;
                }
            }
            Err(place) => self.0.insert(place, kept),
        }
    }

    /// What another tab kept comes to it: of one task what was solved, else what took more
    /// tries.
    pub(super) fn join(&mut self, other: Self) {
        for theirs in other.0 {
            let place = self
                .0
                .binary_search_by_key(&theirs.work.step, |kept| kept.work.step);
            match place {
                Err(place) => self.0.insert(place, theirs),
                Ok(place) => {
                    let rank = |kept: &Kept| (kept.work.solved, kept.work.tries);
                    if let Some(ours) = self.0.get_mut(place)
                        && rank(ours) < rank(&theirs)
                    {
                        *ours = theirs;
                    }
                }
            }
        }
    }

    /// The last step that something was done in, from 0.
    pub(super) fn last_step(&self) -> usize {
        self.0.last().map_or(0, |kept| kept.work.step)
    }

    /// Whether steps follow each other and each work is small enough, as it is where
    /// nobody else wrote it.
    pub(super) fn is_sound(&self) -> bool {
        let mut pairs = self.0.windows(2);
        let in_order = pairs.all(|pair| match pair {
            [one, two] => one.work.step < two.work.step,
            _ => true,
        });
        in_order && self.0.iter().all(|kept| is_fit(&kept.work))
    }

    /// About how many letters they take.
    pub(super) fn letters(&self) -> usize {
        let letters = |kept: &Kept| kept.work.letters() + 100;
        self.0.iter().map(letters).sum()
    }
}

/// Whether a first answer is told beside the last one.
fn is_told(first: &Answer, work: &Work) -> bool {
    let is_short = matches!(first, Answer::Value { .. } | Answer::Choice { .. });
    is_short && work.answer.as_ref() != Some(first)
}
