//! What is being done with the plan: one thing at a time.

use std::rc::Rc;

use crate::Asking;
use crate::audit::Audit;
use crate::changing::{Changing, Comparing};
use crate::steering::Steering;

/// What is being done with the plan.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Mode {
    /// The scene is edited, or its plan watched.
    #[default]
    Editing,
    /// A question was asked about the plan, or about there being none.
    Asking(Rc<Asking>),
    /// The world changes while the plan runs: what changes is being listed.
    Changing(Rc<Changing>),
    /// Ways to go on are side by side.
    Comparing(Rc<Comparing>),
    /// No way to go on was found, and the solver was asked why.
    Stuck(Rc<Comparing>, Rc<Asking>),
    /// Agents are led by hand, in a plan of one's own.
    Steering(Rc<Steering>),
    /// The solver was asked about a plan of one's own.
    Judging(Rc<Steering>, Rc<Asking>),
    /// A plan of elsewhere is judged.
    Auditing(Rc<Audit>),
    /// A question was asked about a plan of elsewhere.
    Querying(Rc<Audit>, Rc<Asking>),
}

impl Mode {
    /// The question that was asked, until it is left.
    pub const fn asking(&self) -> Option<&Rc<Asking>> {
        match self {
            Self::Asking(asking)
            | Self::Judging(_, asking)
            | Self::Stuck(_, asking)
            | Self::Querying(_, asking) => Some(asking),
            _ => None,
        }
    }

    /// The plan of elsewhere, until it is left.
    pub const fn audit(&self) -> Option<&Rc<Audit>> {
        match self {
            Self::Auditing(audit) | Self::Querying(audit, _) => Some(audit),
            _ => None,
        }
    }

    /// What changes in the world, until that is adopted or left.
    pub fn changing(&self) -> Option<&Rc<Changing>> {
        match self {
            Self::Changing(changing) => Some(changing),
            Self::Comparing(comparing) | Self::Stuck(comparing, _) => Some(&comparing.changing),
            _ => None,
        }
    }

    /// The ways to go on, where they are known.
    pub const fn comparing(&self) -> Option<&Rc<Comparing>> {
        match self {
            Self::Comparing(comparing) | Self::Stuck(comparing, _) => Some(comparing),
            _ => None,
        }
    }

    /// The plan of one's own in which agents are led by hand, until it is left.
    pub const fn steering(&self) -> Option<&Rc<Steering>> {
        match self {
            Self::Steering(own) | Self::Judging(own, _) => Some(own),
            _ => None,
        }
    }

    /// The question, to be changed.
    pub(crate) fn asking_mut(&mut self) -> Option<&mut Asking> {
        match self {
            Self::Asking(asking)
            | Self::Judging(_, asking)
            | Self::Stuck(_, asking)
            | Self::Querying(_, asking) => Some(Rc::make_mut(asking)),
            _ => None,
        }
    }

    /// The same without a question.
    #[must_use]
    pub(crate) fn unasked(&self) -> Self {
        match self {
            Self::Asking(_) => Self::Editing,
            Self::Judging(own, _) => Self::Steering(Rc::clone(own)),
            Self::Stuck(comparing, _) => Self::Comparing(Rc::clone(comparing)),
            Self::Querying(audit, _) => Self::Auditing(Rc::clone(audit)),
            other => other.clone(),
        }
    }
}
