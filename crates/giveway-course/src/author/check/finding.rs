//! What the check of a task found.

use giveway_model::Cost;
use giveway_solve::words;

use crate::judge::Why;
use crate::lesson::Value;

/// What the check of a task found.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// The task can be solved, its start is not solved, and what it claims is true.
    Passed,
    /// Something is wrong with the task.
    Failed(Problem),
    /// The solver does not know; why, as a sentence, where it says so.
    Unknown(Option<String>),
}

/// What is wrong with a task.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// It is solved before anything is done.
    StartSolved,
    /// The solver found no solution by itself: the author must solve it once.
    Unsolved,
    /// No plan exists, or none was found where a planner was asked.
    NoPlan,
    /// A plan exists, and the task is about there being none.
    SomePlan,
    /// The solver refuses the task, for a reason as a sentence.
    Refused(String),
    /// The right value is not among those that are offered.
    NotOffered(Value),
    /// Best plans differ in what is to be predicted.
    Differs,
    /// What is to be predicted has not one answer.
    Unclear,
    /// This answer, by its index, is marked right, and what it says is false.
    False(usize),
    /// This answer, by its index, is not marked right, and what it says is true.
    True(usize),
    /// So many answers are marked right.
    Right(usize),
    /// The plan has no conflict of two robots.
    NoConflicts,
    /// The best plan costs more than the task allows.
    Dear {
        /// The cost.
        cost: Cost,
        /// How much the best plan has.
        best: u32,
    },
    /// This order works, though none should.
    SomeOrderWorks(Vec<String>),
    /// No order does what the task asks for.
    NoOrder,
    /// No method reaches what the task asks for.
    NoMethod,
}

impl From<Problem> for Finding {
    fn from(problem: Problem) -> Self {
        Self::Failed(problem)
    }
}

impl Finding {
    /// What a judge means that has not said "solved".
    pub(super) fn of(why: Why) -> Self {
        match why {
            Why::Unknown(reason) => Self::Unknown(reason.as_ref().map(words::reason)),
            Why::SolverFailed(sentence) => Self::Unknown(Some(sentence)),
            Why::Refused(reason) => Problem::Refused(reason).into(),
            Why::NoPlan | Why::NoWayOn(_) => Problem::NoPlan.into(),
            Why::Unclear => Problem::Unclear.into(),
            Why::Plan(_) => Problem::SomePlan.into(),
            Why::Differs => Problem::Differs.into(),
            Why::SomeOrderWorks(order) => Problem::SomeOrderWorks(order).into(),
            _ => Problem::Unsolved.into(),
        }
    }
}
