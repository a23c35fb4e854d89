//! The check of a lesson before its link is shared, as plain data with a pure reducer.
//!
//! The solver must solve each task, find its start unsolved, and prove what it claims. What
//! was found is kept by [`Subject`]: an edit makes only the tasks unknown that it changes.
//! Each request has a number, and a lesson that is edited ends the run, so no late answer
//! counts for another text.

mod edit;
mod examine;
mod finding;
mod paint;
mod reduce;
mod sentence;
mod subject;

use std::rc::Rc;

use giveway_solve::{Request, Response};

use crate::learner::AskNumber;
use crate::lesson::Lesson;

pub use finding::{Finding, Problem};
pub use reduce::reduce;
pub use sentence::{sentence, to_do};
pub use subject::Subject;

/// What is known of the tasks of the lessons that were written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LessonCheck {
    /// What was found, the latest last.
    known: Vec<(Subject, Finding)>,
    /// The tasks that the author has solved by hand, the latest last.
    tried: Vec<Subject>,
    /// The check that runs.
    run: Option<Run>,
    /// The number of the last request.
    asked: AskNumber,
}

/// A check that runs.
#[derive(Clone, Debug, PartialEq)]
struct Run {
    /// The lesson that is shared once all of its tasks have passed.
    lesson: Rc<Lesson>,
    /// The tasks that are still to be checked; the last is checked now.
    left: Vec<Subject>,
    /// How many there were at first.
    count: usize,
    /// What the solver has answered about the task that is checked now.
    answers: Vec<Response>,
}

/// Something that happens to the check.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The link of a lesson is to be shared.
    Share {
        /// The lesson.
        lesson: Rc<Lesson>,
        /// Whether it is shared although some of its tasks are not known to be right.
        anyway: bool,
    },
    /// The check is to end: the author cancels it, or edits the lesson.
    Cancel,
    /// The author has solved a task by hand.
    Solved(Box<Subject>),
    /// The solver has answered.
    Answered {
        /// Which request.
        number: AskNumber,
        /// The answer.
        response: Box<Response>,
    },
    /// The solver has broken down.
    Failed {
        /// At which request.
        number: AskNumber,
        /// What happened, as a sentence.
        sentence: String,
    },
}

/// Something that must be done outside.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Asks the solver.
    Ask {
        /// The number that the answer must carry.
        number: AskNumber,
        /// The request.
        request: Box<Request>,
    },
    /// The request that was asked last is of no more use.
    Forget,
    /// Shares the link of this lesson.
    Share(Rc<Lesson>),
}

/// What is known of some tasks together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// All of them have passed.
    Passed,
    /// All were checked and none is wrong, but of some the solver does not know.
    Unknown,
    /// Some were not checked.
    Unchecked,
    /// Some are wrong.
    Failed,
}

impl LessonCheck {
    /// What was found for a task.
    pub fn of(&self, subject: &Subject) -> Option<&Finding> {
        let mut known = self.known.iter().rev();
        let known = known.find(|(other, _)| other == subject);
        known.map(|(_, finding)| finding)
    }

    /// What is known of all tasks of a lesson together.
    pub fn standing(&self, lesson: &Lesson) -> Standing {
        let all = Subject::all(lesson);
        let all = all.iter().map(|subject| match self.of(subject) {
            Some(Finding::Passed) => Standing::Passed,
            Some(Finding::Unknown(_)) => Standing::Unknown,
            None => Standing::Unchecked,
            Some(Finding::Failed(_)) => Standing::Failed,
        });
        all.max().unwrap_or(Standing::Passed)
    }

    /// Which task is checked now, from 1, and how many are checked in this run.
    pub fn progress(&self) -> Option<(usize, usize)> {
        let run = self.run.as_ref()?;
        Some((run.count + 1 - run.left.len().min(run.count), run.count))
    }
}
