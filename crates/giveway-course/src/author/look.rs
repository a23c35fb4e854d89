//! What a draft comes to: a lesson, or what is wrong with it.

use giveway_model::Version;
use serde_json::Value;

use super::check::Subject;
use super::fault::is_within;
use super::{Draft, Field, FormFault, Input, KIND, PLAN, Words, Wrong, build, form, head};
use crate::lesson::read::{Place, check_lesson};
use crate::lesson::{Glossary, Lesson, Step, Text};

/// A draft that was looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Looked {
    /// The lesson, as far as it can be read.
    lesson: Lesson,
    /// What is wrong.
    faults: Vec<FormFault>,
}

impl Draft {
    /// Looks at what is written, with the terms of a glossary.
    pub fn look(&self, glossary: &Glossary) -> Looked {
        let mut own = build::Faults::new();
        let written = build::object(&head(), &self.words, &mut own);
        let mut faults = of(None, own);
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
            let mut own = build::Faults::new();
            lesson.steps.extend(self.built(index, &mut own));
            faults.extend(of(Some(index), own));
        }
        for fault in check_lesson(&lesson, glossary) {
            // A field that cannot be read has one fault.
            let is_known = faults.iter().any(|known| {
                let (known, place) = (&known.place, &fault.place);
                known.step == place.step && is_within(&place.field, &known.field)
            });
            if !is_known {
                faults.push(fault.into());
            }
        }
        Looked { lesson, faults }
    }

    /// A step, as far as it can be read.
    fn built(&self, index: usize, faults: &mut build::Faults) -> Option<Step> {
        let draft = self.steps.get(index)?;
        let fields = form(draft, self.scene(index));
        let mut written = build::object(&fields, &draft.words, faults);
        let mut step = serde_json::from_value::<Step>(written.clone()).unwrap_or_else(|_| {
            // What is missing in the task was told; the rest is shown without it.
            if faults.is_empty() {
                faults.push((no_choice(&fields, &draft.words), Wrong::NotChoice));
            }
            if let Some(object) = written.as_object_mut() {
                for part in ["task", "hints", "reason"] {
                    object.remove(part);
                }
            }
            serde_json::from_value(written).unwrap_or_default()
        });
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

/// Faults of the lesson, or of a step.
fn of(step: Option<usize>, faults: build::Faults) -> Vec<FormFault> {
    let fault = |(field, wrong)| FormFault {
        place: Place { step, field },
        wrong,
    };
    faults.into_iter().map(fault).collect()
}

/// The first field with a value that is none of its choices: only a draft that was
/// changed outside of the editor has one.
fn no_choice(fields: &[Field], words: &Words) -> String {
    let is_none = |field: &&Field| match &field.input {
        Input::One(picks) | Input::Many(picks) => field.picks(words).len() > picks.len(),
        Input::Line | Input::Area | Input::Number | Input::Switch => false,
    };
    let field = fields.iter().find(is_none);
    field.map_or_else(|| KIND.to_owned(), |field| field.name.clone())
}

impl Looked {
    /// The lesson.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn whole(&self) -> Result<&Lesson, &[FormFault]> {
        if self.faults.is_empty() {
            Ok(&self.lesson)
        } else {
            Err(&self.faults)
        }
    }

    /// What is wrong.
    pub fn faults(&self) -> &[FormFault] {
        &self.faults
    }

    /// What is wrong with a step, or with the lesson as a whole.
    pub fn of(&self, step: Option<usize>) -> Vec<FormFault> {
        let own = self.faults.iter();
        let own = own.filter(|fault| fault.place.step == step);
        own.cloned().collect()
    }

    /// A step, as far as it can be read.
    pub fn step(&self, step: usize) -> Option<&Step> {
        self.lesson.steps.get(step)
    }

    /// What a check of a step's task depends on; none where the step has no task.
    pub fn subject(&self, step: usize) -> Option<Subject> {
        Subject::of(self.step(step)?, self.lesson.scene(step)?)
    }

    /// What can be tried of a step: the whole lesson, and where in it; or the step
    /// alone, where nothing is wrong with that.
    pub fn to_try(&self, step: usize) -> Option<(Lesson, usize)> {
        if self.faults.is_empty() {
            return Some((self.lesson.clone(), step));
        }
        if !self.of(Some(step)).is_empty() {
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
}
