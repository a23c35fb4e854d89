//! What a class is given, and what it needs.

use std::rc::Rc;

use giveway_model::tr;
use giveway_solve::Request;

use crate::handin::Sum;
use crate::learner::AskNumber;
use crate::lesson::{Id, Lesson, Text};

/// A lesson against which hand-ins are judged.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// Its short name.
    pub id: Id,
    /// The lesson.
    pub lesson: Rc<Lesson>,
    /// What it is known by.
    pub sum: Sum,
}

impl Given {
    /// A lesson, with its check sum.
    pub fn new(id: Id, lesson: Rc<Lesson>) -> Self {
        let sum = Sum::of(&lesson);
        Self { id, lesson, sum }
    }

    /// The steps that have a task, from 0.
    pub fn tasks(&self) -> impl Iterator<Item = usize> + '_ {
        let steps = self.lesson.steps.iter().enumerate();
        steps.filter_map(|(index, step)| step.task.as_ref().map(|_| index))
    }

    /// The number of the task of a step, from 1; `None` where the step has no task.
    pub fn number(&self, step: usize) -> Option<usize> {
        let place = self.tasks().position(|task| task == step);
        place.map(|place| place + 1)
    }

    /// The task of a step, by its number and what the step is called: `2 Who gives way?`.
    pub fn task_words(&self, step: usize) -> String {
        match (self.number(step), self.lesson.steps.get(step)) {
            (Some(number), Some(step)) => format!("{number} {}", step.title),
            _ => tr!("step {number}, without a task", number = step + 1),
        }
    }

    /// What the task of a step asks for.
    pub fn asked(&self, step: usize) -> Option<&Text> {
        Some(self.lesson.steps.get(step)?.task.as_ref()?.say())
    }
}

/// What a class needs next.
#[derive(Clone, Debug, PartialEq)]
pub enum Next {
    /// The solver must be asked.
    Ask {
        /// The number that the answer must carry.
        number: AskNumber,
        /// The question.
        request: Box<Request>,
    },
    /// Something was judged without the solver, and there is more.
    Again,
    /// All is judged, or it was cancelled.
    Done,
}

/// How much is judged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    /// How many tasks are judged.
    pub done: usize,
    /// How many there are.
    pub all: usize,
}
