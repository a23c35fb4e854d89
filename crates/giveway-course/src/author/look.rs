//! What a draft comes to: a lesson, or what is wrong with it.

use giveway_model::{Fault, Version, tr};
use serde_json::Value;

use super::{Draft, PLAN, build, form, head};
use crate::lesson::read::check_lesson;
use crate::lesson::{Glossary, Lesson, Step, Text};

/// A draft that was looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Looked {
    /// The lesson, as far as it can be read.
    lesson: Lesson,
    /// What is wrong, each with its place in the file.
    faults: Vec<Fault>,
}

impl Draft {
    /// Looks at what is written, with the terms of a glossary.
    pub fn look(&self, glossary: &Glossary) -> Looked {
        let mut faults = Vec::new();
        let written = build::object(&head(), &self.words, &mut faults);
        let word = |name: &str| written.get(name).and_then(Value::as_str).unwrap_or("");
        let minutes = written.get("minutes").and_then(Value::as_u64);
        let mut lesson = Lesson {
            giveway: Version,
            title: word("title").to_owned(),
            minutes: minutes.and_then(|n| u32::try_from(n).ok()).unwrap_or(1),
            about: word("about").parse().unwrap_or_default(),
            hides_answers: written.get("hides-answers").is_some(),
            steps: Vec::new(),
        };
        for index in 0..self.steps.len() {
            let mut own = Vec::new();
            lesson.steps.extend(self.built(index, &mut own));
            let place = format!("steps[{index}]");
            faults.extend(own.into_iter().map(|fault| fault.of_part(&place)));
        }
        for fault in check_lesson(&lesson, glossary) {
            // What cannot be read is told once.
            if !faults
                .iter()
                .any(|known| covers(&known.place, &fault.place))
            {
                faults.push(fault);
            }
        }
        Looked { lesson, faults }
    }

    /// A step, as far as it can be read.
    fn built(&self, index: usize, faults: &mut Vec<Fault>) -> Option<Step> {
        let draft = self.steps.get(index)?;
        let fields = form(draft, self.scene(index));
        let mut written = build::object(&fields, &draft.words, faults);
        let mut step = match serde_json::from_value::<Step>(written.clone()) {
            Ok(step) => step,
            Err(error) => {
                // What is missing in the task was told; the rest is shown without it.
                if faults.is_empty() {
                    faults.push(Fault::at("task", tr!("a fault"), error.to_string()));
                }
                if let Some(object) = written.as_object_mut() {
                    for part in ["task", "hints", "reason"] {
                        object.remove(part);
                    }
                }
                serde_json::from_value(written).unwrap_or_default()
            }
        };
        if step.task.is_some() && step.reason.is_none() {
            // That it is missing was told.
            step.reason = Some(Text::default());
        }
        step.scene.clone_from(&draft.scene);
        match draft.word(PLAN) {
            "given" => step.plan.clone_from(&draft.plan),
            "best" => step.solved = true,
            _ => {}
        }
        Some(step)
    }
}

/// Whether a place is one where something is wrong already, or in it.
fn covers(known: &str, place: &str) -> bool {
    let rest = place.strip_prefix(known);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

impl Looked {
    /// The lesson.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn whole(&self) -> Result<&Lesson, &[Fault]> {
        if self.faults.is_empty() {
            Ok(&self.lesson)
        } else {
            Err(&self.faults)
        }
    }

    /// What is wrong, each with its place in the file.
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// What is wrong with a step, each with its place in the step.
    pub fn of_step(&self, step: usize) -> Vec<Fault> {
        let place = format!("steps[{step}]");
        let own = self.faults.iter().filter_map(|fault| {
            let rest = fault.place.strip_prefix(&place)?;
            let mut own = fault.clone();
            rest.trim_start_matches('.').clone_into(&mut own.place);
            Some(own)
        });
        own.collect()
    }

    /// A step, as far as it can be read.
    pub fn step(&self, step: usize) -> Option<&Step> {
        self.lesson.steps.get(step)
    }

    /// What can be tried of a step: the whole lesson, and where in it; or the step
    /// alone, where nothing is wrong with that.
    pub fn to_try(&self, step: usize) -> Option<(Lesson, usize)> {
        if self.faults.is_empty() {
            return Some((self.lesson.clone(), step));
        }
        if !self.of_step(step).is_empty() {
            return None;
        }
        let mut alone = self.step(step)?.clone();
        alone.scene = self.lesson.scene(step).cloned();
        alone.scene.is_some().then(|| {
            let lesson = Lesson {
                giveway: Version,
                title: self.lesson.title.clone(),
                minutes: 1,
                about: Text::default(),
                hides_answers: self.lesson.hides_answers,
                steps: vec![alone],
            };
            (lesson, 0)
        })
    }

    /// Whether a fault only says that nothing is written yet.
    pub fn is_missing(fault: &Fault) -> bool {
        build::is_missing(fault)
    }
}
