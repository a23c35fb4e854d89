//! How far each lesson has come: what a browser keeps, and is distrusted when read back.

use std::collections::BTreeMap;

use giveway_model::{Fault, Version, format::native};
use serde::{Deserialize, Serialize};

use crate::lesson::Id;
use crate::lesson::read::{MAX_LESSONS, MAX_STEPS};

/// How far each lesson has come.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Progress {
    /// The version of the format.
    giveway: Version,
    lessons: BTreeMap<Id, Reached>,
}

/// How far a lesson has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Reached {
    /// The step that was opened last, from 0.
    step: usize,
    /// Whether it was done once.
    #[serde(default)]
    done: bool,
}

/// How far a lesson has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// It was never opened.
    New,
    /// It was left at a step, from 0.
    Begun(usize),
    /// It was done.
    Done,
}

impl Progress {
    /// How far a lesson has come.
    pub fn stage(&self, lesson: &Id) -> Stage {
        match self.lessons.get(lesson) {
            None => Stage::New,
            Some(Reached { done: true, .. }) => Stage::Done,
            Some(Reached { step, .. }) => Stage::Begun(*step),
        }
    }

    /// The step of a lesson that was opened last, from 0.
    pub fn step(&self, lesson: &Id) -> usize {
        self.lessons.get(lesson).map_or(0, |reached| reached.step)
    }

    /// How many lessons are done.
    pub fn done(&self) -> usize {
        self.lessons.values().filter(|reached| reached.done).count()
    }

    /// A step of a lesson was opened.
    pub(super) fn opened(&mut self, lesson: &Id, step: usize) {
        if self.lessons.len() < MAX_LESSONS || self.lessons.contains_key(lesson) {
            self.lessons.entry(lesson.clone()).or_default().step = step.min(MAX_STEPS);
        }
    }

    /// A lesson is done; it begins at its first step when it is opened again.
    pub(super) fn finished(&mut self, lesson: &Id) {
        if let Some(reached) = self.lessons.get_mut(lesson) {
            *reached = Reached {
                step: 0,
                done: true,
            };
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
            let found = format!("{count} lessons");
            return Err(Fault::at(
                "lessons",
                found,
                format!("at most {MAX_LESSONS}"),
            ));
        }
        let mut steps = progress.lessons.values().map(|reached| reached.step);
        if let Some(step) = steps.find(|step| *step > MAX_STEPS) {
            let found = format!("step {step}");
            return Err(Fault::at("lessons", found, format!("at most {MAX_STEPS}")));
        }
        Ok(progress)
    }
}
