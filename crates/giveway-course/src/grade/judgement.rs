//! What a task's work is worth, whatever its file says.

use giveway_model::tr;

use crate::handin::Misfit;
use crate::judge::{Verdict, Why, words};
use crate::lesson::Step;

/// What a task's work is worth.
#[derive(Clone, Debug, PartialEq)]
pub enum Judgement {
    /// The answer solves the task.
    Solved(Box<Verdict>),
    /// It does not.
    NotSolved(Reason),
    /// There is no answer.
    NotTried,
    /// The solver has not decided it with the work that it may do, or broke down.
    Undecided(Reason),
}

/// Why an answer does not solve its task, or why that is not known.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// The judge says so.
    Verdict(Box<Verdict>),
    /// The file says what does not fit the lesson.
    Misfit(Misfit),
}

impl Judgement {
    /// What a judge's verdict makes of an answer.
    pub(super) fn by(verdict: Verdict) -> Self {
        let verdict = Box::new(verdict);
        match &verdict.why {
            _ if verdict.is_solved() => Self::Solved(verdict),
            Why::Unknown(_) | Why::SolverFailed(_) => Self::Undecided(Reason::Verdict(verdict)),
            _ => Self::NotSolved(Reason::Verdict(verdict)),
        }
    }

    /// Whether it is decided that the task is solved.
    pub const fn is_solved(&self) -> bool {
        matches!(self, Self::Solved(_))
    }

    /// What the judge says, where it was asked.
    pub const fn verdict(&self) -> Option<&Verdict> {
        match self {
            Self::Solved(verdict)
            | Self::NotSolved(Reason::Verdict(verdict))
            | Self::Undecided(Reason::Verdict(verdict)) => Some(verdict),
            Self::NotSolved(Reason::Misfit(_))
            | Self::Undecided(Reason::Misfit(_))
            | Self::NotTried => None,
        }
    }

    /// It in a word or two: `not solved`.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Solved(_) => tr!("solved"),
            Self::NotSolved(_) => tr!("not solved"),
            Self::NotTried => tr!("not tried"),
            Self::Undecided(_) => tr!("not decided"),
        }
    }

    /// Why the task is not solved, as a sentence; empty where it is, or was not tried.
    pub fn reason(&self, step: &Step) -> String {
        match self {
            Self::Solved(_) | Self::NotTried => String::new(),
            Self::NotSolved(reason) | Self::Undecided(reason) => match reason {
                Reason::Verdict(verdict) => {
                    let said = words::said(verdict, step);
                    capitalised(&said.text.plain())
                }
                Reason::Misfit(misfit) => misfit.sentence(),
            },
        }
    }
}

/// With a capital at the beginning.
pub(super) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}
