//! What the check of a task depends on: the step with its scene, without its prose.

use giveway_model::Scene;

use crate::judge::Situation;
use crate::lesson::{Lesson, Step, Task, Text};

/// A task as its check sees it. Two steps that differ in their prose only have the same
/// subject, so what was found for the one counts for the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// The step, without its prose and without its scene.
    pub(super) step: Step,
    /// The scene that the step begins with.
    pub(super) scene: Scene,
}

impl Subject {
    /// The subject of a step that begins with a scene; none where it has no task.
    pub fn of(step: &Step, scene: &Scene) -> Option<Self> {
        let mut task = step.task.clone()?;
        let say = match &mut task {
            Task::Paint(task) => &mut task.say,
            Task::Lead(task) => &mut task.say,
            Task::Predict(task) => {
                for answer in &mut task.answers {
                    answer.text = Text::default();
                    answer.reply = Text::default();
                }
                &mut task.say
            }
            Task::Spot(task) => &mut task.say,
            Task::Choose(task) => {
                for answer in &mut task.answers {
                    answer.text = Text::default();
                    answer.reply = Text::default();
                }
                &mut task.say
            }
            Task::Order(task) => &mut task.say,
            Task::Change(task) => &mut task.say,
        };
        *say = Text::default();
        Some(Self {
            step: Step {
                plan: step.plan.clone(),
                solved: step.solved,
                tools: step.tools.clone(),
                edits: step.edits,
                cells: step.cells.clone(),
                task: Some(task),
                ..Step::default()
            },
            scene: scene.clone(),
        })
    }

    /// The subjects of a lesson, step by step.
    pub fn all(lesson: &Lesson) -> Vec<Self> {
        let steps = lesson.steps.iter().enumerate();
        steps
            .filter_map(|(index, step)| Self::of(step, lesson.scene(index)?))
            .collect()
    }

    /// The untouched start of the step.
    pub(super) const fn start(&self) -> Situation<'_> {
        Situation {
            step: &self.step,
            start: &self.scene,
            scene: &self.scene,
        }
    }
}
