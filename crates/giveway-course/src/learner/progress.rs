//! How far each lesson has come: what a browser keeps, and is distrusted when read back.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Fault, Version, format::native, tr};
use serde::{Deserialize, Serialize};

use super::works::{Judged, Works};
use crate::handin::Work;
use crate::lesson::read::{MAX_LESSONS, MAX_STEPS};
use crate::lesson::{Id, Lesson, Step};

/// The most steps of a lesson whose texts are kept as solved.
const MAX_TEXTS: usize = 4 * MAX_STEPS;
/// The most letters of all answers that are kept.
const MAX_LETTERS: usize = 1_000_000;

/// How far each lesson has come.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Progress {
    /// The version of the format.
    giveway: Version,
    /// How often all of it was forgotten: what another tab kept before that is of no
    /// more use.
    #[serde(default, skip_serializing_if = "is_zero")]
    forgotten: u32,
    lessons: BTreeMap<Id, Reached>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_zero(number: &u32) -> bool {
    *number == 0
}

/// How far a lesson has come.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Reached {
    /// The step that was opened last, from 0.
    step: usize,
    /// Whether it counted as done before tasks were counted: it was read to its end.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    done: bool,
    /// Whether it was read to its end.
    #[serde(default)]
    seen: bool,
    /// The steps whose tasks are solved, from 0.
    #[serde(default)]
    solved: BTreeSet<usize>,
    /// The hashes of the steps that are solved: a step that was edited since, or is told in
    /// another language, is a new one.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    texts: BTreeSet<u64>,
    /// How many tasks it has.
    #[serde(default)]
    tasks: usize,
    /// What was done for them.
    #[serde(default, skip_serializing_if = "Works::is_empty")]
    works: Works,
}

impl Reached {
    /// Whether all of its tasks are solved; where it has none, whether it was read.
    fn is_done(&self) -> bool {
        let has_tasks = self.tasks > 0;
        self.done || (self.solved.len() >= self.tasks && (has_tasks || self.seen))
    }

    /// Forgets steps where there are more than languages and editions of a lesson need.
    fn limit_texts(&mut self) {
        while self.texts.len() > MAX_TEXTS {
            self.texts.pop_first();
        }
    }

    /// Whatever was solved or read in either counts, and the furthest step; where one
    /// was read to its end, that one tells the step to go on with.
    fn join(&mut self, other: Self) {
        self.step = match (self.seen, other.seen) {
            (true, false) => self.step,
            (false, true) => other.step,
            _ => self.step.max(other.step),
        };
        self.done |= other.done;
        self.seen |= other.seen;
        self.solved.extend(other.solved);
        self.texts.extend(other.texts);
        self.limit_texts();
        self.tasks = self.tasks.max(other.tasks);
        self.works.join(other.works);
    }
}

/// How far a lesson has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// It was never opened.
    New,
    /// It was left at a step, from 0.
    Begun(usize),
    /// It was read to its end, and some of its tasks are left.
    Seen {
        /// The step to go on with, from 0.
        step: usize,
        /// How many tasks are solved.
        solved: usize,
        /// How many there are.
        tasks: usize,
    },
    /// All of its tasks are solved.
    Done,
}

impl Progress {
    /// How far a lesson has come.
    pub fn stage(&self, lesson: &Id) -> Stage {
        match self.lessons.get(lesson) {
            None => Stage::New,
            Some(reached) if reached.is_done() => Stage::Done,
            Some(reached) if reached.seen => Stage::Seen {
                step: reached.step,
                solved: reached.solved.len(),
                tasks: reached.tasks,
            },
            Some(reached) => Stage::Begun(reached.step),
        }
    }

    /// The step of a lesson that was opened last, from 0.
    pub fn step(&self, lesson: &Id) -> usize {
        self.lessons.get(lesson).map_or(0, |reached| reached.step)
    }

    /// Whether the task of a step is solved, and the step is still the same.
    pub(super) fn is_solved(&self, lesson: &Id, step: &Step) -> bool {
        let texts = self.lessons.get(lesson).map(|reached| &reached.texts);
        texts.is_some_and(|texts| !texts.is_empty() && texts.contains(&step.hash()))
    }

    /// Whether no lesson was ever opened.
    pub fn is_empty(&self) -> bool {
        self.lessons.is_empty()
    }

    /// How many lessons are done.
    pub fn done(&self) -> usize {
        self.lessons.values().filter(|it| it.is_done()).count()
    }

    /// What was kept by another tab, or before the page was opened, comes in. Nothing is
    /// lost of either, unless all was forgotten since.
    pub(super) fn join(&mut self, other: Self) {
        match other.forgotten.cmp(&self.forgotten) {
            Ordering::Less => {}
            Ordering::Greater => *self = other,
            Ordering::Equal => {
                for (id, theirs) in other.lessons {
                    if let Some(reached) = self.reached(&id) {
                        reached.join(theirs);
                    }
                }
                self.limit_works(None);
            }
        }
    }

    /// The last answers to the tasks of a lesson that are still the same, in the order of
    /// the steps.
    pub fn works(&self, id: &Id, lesson: &Lesson) -> Vec<Work> {
        let reached = self.lessons.get(id);
        reached.map_or_else(Vec::new, |reached| reached.works.of(lesson))
    }

    /// Something was done for a task.
    pub(super) fn worked(&mut self, id: &Id, lesson: &Lesson, work: Work, judged: Judged) {
        if !self.lessons.contains_key(id) {
            self.opened(id, lesson, work.step);
        }
        if let Some(reached) = self.lessons.get_mut(id) {
            reached.works.add(lesson, work, judged);
        }
        self.limit_works(Some(id));
    }

    /// Forgets what was done in other lessons where a browser would be asked to keep too
    /// much.
    fn limit_works(&mut self, but: Option<&Id>) {
        let mut letters: usize = self.lessons.values().map(|it| it.works.letters()).sum();
        for (id, reached) in &mut self.lessons {
            if letters <= MAX_LETTERS {
                return;
            }
            if Some(id) != but {
                letters -= reached.works.letters();
                reached.works = Works::default();
            }
        }
    }

    /// All is forgotten, in other tabs, too.
    pub(super) fn forget(&mut self) {
        *self = Self {
            forgotten: self.forgotten.saturating_add(1),
            ..Self::default()
        };
    }

    /// How far a lesson has come, to be changed; `None` where there are too many.
    fn reached(&mut self, id: &Id) -> Option<&mut Reached> {
        let is_full = self.lessons.len() >= MAX_LESSONS && !self.lessons.contains_key(id);
        (!is_full).then(|| self.lessons.entry(id.clone()).or_default())
    }

    /// A step of a lesson was opened.
    pub(super) fn opened(&mut self, id: &Id, lesson: &Lesson, step: usize) {
        let Some(reached) = self.reached(id) else {
            return;
        };
        reached.step = step.min(MAX_STEPS);
        // The lesson may have other tasks than when it was opened last.
        reached.tasks = tasks(lesson).count();
        reached
            .solved
            .retain(|step| tasks(lesson).any(|task| task == *step));
    }

    /// The task of a step is solved. All may have been forgotten since it was opened.
    pub(super) fn solved(&mut self, id: &Id, lesson: &Lesson, step: usize) {
        if !self.lessons.contains_key(id) {
            self.opened(id, lesson, step);
        }
        if let Some(reached) = self.lessons.get_mut(id) {
            reached.solved.insert(step);
            reached.texts.extend(lesson.steps.get(step).map(Step::hash));
            reached.limit_texts();
        }
    }

    /// A lesson was read to its end. It begins at the first task that is left when it is
    /// opened again.
    pub(super) fn finished(&mut self, id: &Id, lesson: &Lesson) {
        if !self.lessons.contains_key(id) {
            self.opened(id, lesson, 0);
        }
        if let Some(reached) = self.lessons.get_mut(id) {
            let left = tasks(lesson).find(|step| !reached.solved.contains(step));
            reached.step = left.unwrap_or(0);
            reached.seen = true;
        }
    }

    /// The text that is kept.
    pub fn write(&self) -> String {
        // Names and numbers always have a JSON form.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads a text that was kept.
    ///
    /// # Errors
    /// Where it is no such text, or holds more than there can be.
    pub fn read(text: &str) -> Result<Self, Fault> {
        let progress: Self = native::read_object(text)?;
        let count = progress.lessons.len();
        if count > MAX_LESSONS {
            let found = tr!("{count} lessons", count);
            return Err(Fault::at(
                "lessons",
                found,
                tr!("at most {most}", most = MAX_LESSONS),
            ));
        }
        let counts = |it: &Reached| {
            let last = it.solved.last().copied().unwrap_or_default();
            it.step.max(it.tasks).max(last).max(it.works.last_step())
        };
        let most = progress.lessons.values().map(counts).max();
        if let Some(step) = most.filter(|most| *most > MAX_STEPS) {
            let found = tr!("step {step}", step);
            return Err(Fault::at(
                "lessons",
                found,
                tr!("at most {most}", most = MAX_STEPS),
            ));
        }
        if !progress.lessons.values().all(|it| it.works.is_sound()) {
            let expected = tr!("each step once, in order");
            return Err(Fault::at("lessons", tr!("answers out of order"), expected));
        }
        Ok(progress)
    }
}

/// The steps of a lesson that have a task, from 0.
fn tasks(lesson: &Lesson) -> impl Iterator<Item = usize> {
    let steps = lesson.steps.iter().enumerate();
    steps.filter_map(|(index, step)| step.task.as_ref().map(|_| index))
}
