//! Judges what a learner has done, by the solver or by the judge of plans.
//!
//! [`begin`] gives a verdict at once, or the requests that must be asked of the
//! solver's service first; [`conclude`] makes a verdict of the responses. Both are pure.
//! There is a file for each kind of task; [`words`] makes sentences of verdicts.

pub(crate) mod ask;
mod audited;
mod brought;
mod change;
mod choose;
mod edits;
mod fixed;
mod lead;
mod ledger;
pub(crate) mod order;
mod paint;
mod predict;
pub(crate) mod proved;
mod robots;
mod rules;
mod spot;
pub(crate) mod statement;
mod verdict;
pub mod words;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Plan, Scene, object_only};
use giveway_solve::change::Method;
use giveway_solve::{Request, Response};
use serde::{Deserialize, Serialize};

use crate::lesson::{Step, Task, Value};

pub(crate) use brought::{Outsider, may_bring};
pub use edits::Outside;
pub(crate) use spot::{conflicts, is_same_conflict};
pub use statement::Held;
pub use verdict::{Kind, Verdict, Why};

/// Where a learner is: a step, the scene that it began with, and the one on the board.
#[derive(Clone, Copy, Debug)]
pub struct Situation<'a> {
    /// The step.
    pub step: &'a Step,
    /// The scene that the step began with.
    pub start: &'a Scene,
    /// The scene on the board.
    pub scene: &'a Scene,
}

/// What a learner has done for a task, so far.
#[derive(Clone, Debug, Default, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum Did {
    /// Nothing that counts, or edits of the scene: those are on the board.
    #[default]
    Edits,
    /// Led robots: the plan of all of them.
    Led(Plan),
    /// Said a value.
    Guessed(Value),
    /// Said none, and asked for the answer.
    Revealed,
    /// Marked conflicts.
    Marked(Vec<Mark>),
    /// Picked an answer, by its index.
    Chose(usize),
    /// Put the robots in an order, by their names.
    Ordered(Vec<String>),
    /// Said that no order works.
    NoOrder,
    /// Went on after the change by a method.
    Went(Method),
}

/// A conflict that a learner has marked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Mark {
    /// When.
    pub time: u32,
    /// Who: two robots, by their names.
    pub robots: Vec<String>,
    /// Where they were clicked.
    pub cells: Vec<Cell>,
}

object_only!(Mark);

/// What is known at once.
#[derive(Clone, Debug, PartialEq)]
pub enum Judging {
    /// The verdict.
    Verdict(Box<Verdict>),
    /// The solver must be asked first, in this order.
    Ask(Vec<Request>),
}

impl From<Verdict> for Judging {
    fn from(verdict: Verdict) -> Self {
        Self::Verdict(Box::new(verdict))
    }
}

/// Begins to judge; `None` where there is no task.
pub fn begin(situation: Situation<'_>, did: &Did) -> Option<Judging> {
    if let Err(verdict) = on_its_board(situation) {
        return situation.step.task.as_ref().map(|_| (*verdict).into());
    }
    let judging = match (situation.step.task.as_ref()?, did) {
        (Task::Paint(task), Did::Edits) => paint::begin(task, situation),
        (Task::Lead(task), Did::Led(plan)) => lead::begin(task, situation, plan),
        (Task::Predict(task), Did::Guessed(_) | Did::Revealed) => predict::begin(task, situation),
        (Task::Spot(_), Did::Marked(marks)) => spot::judge(situation, marks).into(),
        (Task::Choose(task), Did::Chose(answer)) => choose::begin(task, situation, *answer),
        (Task::Order(task), Did::Ordered(_) | Did::NoOrder) => order::begin(task, situation, did),
        (Task::Change(task), Did::Went(method)) => change::begin(task, situation, *method),
        _ => Verdict::not_yet(Why::Untouched).into(),
    };
    Some(judging)
}

/// The verdict, once the solver has answered all that [`begin`] asked; `None` where
/// there is no task.
pub fn conclude(situation: Situation<'_>, did: &Did, responses: &[Response]) -> Option<Verdict> {
    if let Err(verdict) = on_its_board(situation) {
        return situation.step.task.as_ref().map(|_| *verdict);
    }
    let verdict = match (situation.step.task.as_ref()?, did) {
        (Task::Paint(task), Did::Edits) => paint::conclude(task, situation, responses),
        (Task::Lead(task), Did::Led(plan)) => lead::conclude(task, situation, plan, responses),
        (Task::Predict(task), Did::Guessed(value)) => {
            predict::conclude(task, situation, value, responses)
        }
        (Task::Predict(task), Did::Revealed) => predict::reveal(task, situation, responses),
        (Task::Choose(task), Did::Chose(answer)) => {
            choose::conclude(task, situation, *answer, responses)
        }
        (Task::Order(task), Did::Ordered(_) | Did::NoOrder) => {
            order::conclude(task, situation, did, responses)
        }
        (Task::Change(task), Did::Went(method)) => {
            change::conclude(task, situation, *method, responses)
        }
        _ => Verdict::not_yet(Why::Untouched),
    };
    Some(verdict)
}

/// Whether the board is one that the step allows, whatever its task is.
fn on_its_board(situation: Situation<'_>) -> Result<(), Box<Verdict>> {
    if situation.scene == situation.start {
        return Ok(());
    }
    let allowed = edits::allowed(situation);
    allowed
        .map(drop)
        .map_err(|why| Box::new(Verdict::not_like_this(why)))
}
