//! What a learner has done, as plain data with a pure reducer.
//!
//! [`reduce()`] makes the next state of an action, and tells what must be done outside
//! of it as [`Effect`]s: the solver is asked, the page is told something, progress is
//! kept. Each question to the solver and each board has a number; answers and messages
//! that carry an older one are dropped.

mod action;
mod left;
mod onward;
mod open;
mod pointed;
mod progress;
mod proof;
mod reduce;
mod task;
mod works;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_solve::{Request, Response};

use crate::judge::Verdict;
use crate::port::BoardNumber;

pub use action::{Action, Effect};
pub use onward::{NEXT, Onward};
pub use open::Open;
pub use progress::{Progress, Stage};
pub use proof::{Changed, Held, Proof};
pub use reduce::reduce;

/// A learner.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Learner {
    /// How far each lesson has come.
    pub progress: Progress,
    /// The lesson that is open.
    pub open: Option<Open>,
    /// The step that was left while its judge was still looking.
    left: Option<Box<Open>>,
    /// The number of the last board.
    board: BoardNumber,
    /// The number of the last question to the solver.
    asked: AskNumber,
}

/// The number of a question to the solver.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, BorshSerialize, BorshDeserialize,
)]
pub struct AskNumber(pub u32);

/// What the judge of a task does, or says.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Judge {
    /// Nothing was done yet.
    #[default]
    Waiting,
    /// It asks the solver.
    Looking(Looking),
    /// It says this.
    Said(Box<Verdict>),
}

/// Questions to the solver, asked one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Looking {
    /// The number of the question that is asked now.
    number: AskNumber,
    /// The questions after that one.
    left: Vec<Request>,
    /// The answers so far.
    responses: Vec<Response>,
}

impl Judge {
    /// What it says, where it says something.
    pub fn verdict(&self) -> Option<&Verdict> {
        match self {
            Self::Said(verdict) => Some(verdict),
            Self::Waiting | Self::Looking(_) => None,
        }
    }
}
