//! What the solver is to do, and how far it has come.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Costs};
use giveway_solve::change::ChangeRequest;
use giveway_solve::explain::ExplainRequest;
use giveway_solve::{CertifyRequest, Request, SolveRequest};

use crate::Draft;

/// What the solver does.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Work {
    /// Nothing.
    #[default]
    Idle,
    /// A request is being solved.
    Solving(Run),
    /// A question is being answered.
    Asking(Inquiry),
    /// What was answered is proved again and checked.
    Certifying(Certifying),
    /// Ways to go on where the world changes are looked for.
    Adapting(Adapting),
}

impl Work {
    /// What the solver is to do, with the number of the run.
    pub fn request(&self) -> Option<(u64, Request)> {
        match self {
            Self::Idle => None,
            Self::Solving(run) => Some((run.id, Request::Solve((*run.request).clone()))),
            Self::Asking(inquiry) => {
                Some((inquiry.id, Request::Explain((*inquiry.request).clone())))
            }
            Self::Certifying(run) => Some((run.id, Request::Certify((*run.request).clone()))),
            Self::Adapting(run) => Some((run.id, Request::Change((*run.request).clone()))),
        }
    }

    /// The number of the run, if there is one.
    pub const fn id(&self) -> Option<u64> {
        match self {
            Self::Idle => None,
            Self::Solving(run) => Some(run.id),
            Self::Asking(inquiry) => Some(inquiry.id),
            Self::Certifying(run) => Some(run.id),
            Self::Adapting(run) => Some(run.id),
        }
    }
}

/// A question on its way to an answer; what is known stands in
/// [`State::asking`](crate::State::asking).
#[derive(Clone, Debug, PartialEq)]
pub struct Inquiry {
    /// The number of the run, from 1.
    pub id: u64,
    /// The request.
    pub request: Rc<ExplainRequest>,
}

/// A search for ways to go on.
#[derive(Clone, Debug, PartialEq)]
pub struct Adapting {
    /// The number of the run, from 1.
    pub id: u64,
    /// The request.
    pub request: Rc<ChangeRequest>,
    /// How large the formula is that is worked on.
    pub size: Size,
}

/// The check of a proof on its way.
#[derive(Clone, Debug, PartialEq)]
pub struct Certifying {
    /// The number of the run, from 1.
    pub id: u64,
    /// The request.
    pub request: Rc<CertifyRequest>,
    /// Whether it is about the answer to the question, not about the plan.
    pub of_question: bool,
    /// The claim that it has come to, and whether its proof is being checked.
    pub at: Option<(String, bool)>,
}

/// A request on its way to an answer, and what is known so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Its number, from 1.
    pub id: u64,
    /// The draft that is solved.
    pub draft: Rc<Draft>,
    /// The request.
    pub request: Rc<SolveRequest>,
    /// The proved lower bound of each cost reached so far.
    pub bounds: BTreeMap<Cost, u32>,
    /// The costs of the best plan so far.
    pub best: Option<Costs>,
    /// How large the formula is.
    pub size: Size,
}

/// How large a formula is, and how far its solution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Size {
    /// SAT variables.
    pub variables: u64,
    /// Clauses.
    pub clauses: u64,
    /// Conflicts met.
    pub conflicts: u64,
}
