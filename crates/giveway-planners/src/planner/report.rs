//! How a planner ended.

use super::{Best, Improvement, Inability};
use crate::{
    AgentId,
    budget::Stop,
    cbs::{LowerBound, Proved, Tree},
    lacam,
    pibt::Inheritance,
    prioritised::{OrderAttempt, Stuck},
    walk::Walk,
};

/// The result of a planner.
#[derive(Clone, Debug)]
pub struct Report {
    /// How it ended.
    pub outcome: Outcome,
    /// Its work, in what [`Planner::steps`](super::Planner::steps) names.
    pub steps: u64,
    /// Its trace, where that was asked for.
    pub trace: Option<Trace>,
}

impl Report {
    /// It was not begun.
    pub(super) const fn refused(lack: Inability) -> Self {
        Self {
            outcome: Outcome::Refused { lack },
            steps: 0,
            trace: None,
        }
    }
}

/// How a planner ended. There is no "no plan": none of them proves that.
#[derive(Clone, Debug)]
#[expect(
    missing_docs,
    reason = "the sentence of a variant says what its fields are"
)]
pub enum Outcome {
    /// With a plan of least cost.
    Best { walks: Vec<Walk>, proved: Proved },
    /// With a plan; there may be better ones.
    Found { walks: Vec<Walk> },
    /// No order that was tried works within a makespan; who got stuck in the last. There may
    /// be a plan.
    NoOrderWorks {
        tried: u32,
        within: u32,
        stuck: Stuck,
    },
    /// Early, with the best plan so far and what is proved, as far as there is one.
    Stopped {
        halt: Halt,
        walks: Option<Vec<Walk>>,
        bound: Option<LowerBound>,
    },
    /// The method cannot do this.
    Refused { lack: Inability },
}

impl Outcome {
    /// With the best plan, or with none where there is none.
    pub(super) fn found(best: Best) -> Self {
        match best.walks() {
            Some(walks) => Self::Found { walks },
            None => Self::Stopped {
                halt: Halt::Effort,
                walks: None,
                bound: None,
            },
        }
    }

    /// Early, with the best plan so far.
    pub(super) fn stopped(halt: Halt, best: Best) -> Self {
        Self::Stopped {
            halt,
            walks: best.walks(),
            bound: None,
        }
    }

    /// The walks, where it has a plan.
    pub fn walks(&self) -> Option<&[Walk]> {
        match self {
            Self::Best { walks, .. } | Self::Found { walks } => Some(walks),
            Self::Stopped { walks, .. } => walks.as_deref(),
            Self::NoOrderWorks { .. } | Self::Refused { .. } => None,
        }
    }

    /// The proved bound of the first cost, if there is one.
    pub fn bound(&self) -> Option<LowerBound> {
        match self {
            Self::Best { proved, .. } => Some(proved.bound()),
            Self::Stopped { bound, .. } => *bound,
            _ => None,
        }
    }
}

/// Why a planner stopped early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
    /// The budget was spent.
    Budget(Stop),
    /// All plans up to this makespan were excluded; longer ones were not looked
    /// for.
    Horizon(u32),
    /// All steps were made, and not all agents were at their goals.
    Stuck {
        /// The agents at their goals.
        arrived: usize,
        /// The steps.
        steps: u32,
    },
    /// It looked at as much as it ever looks at.
    Effort,
}

/// How a planner went.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Trace {
    /// The orders that were tried.
    Prioritised(Vec<OrderAttempt>),
    /// The constraint tree.
    Cbs(Tree),
    /// The steps of PIBT.
    Pibt {
        /// The inheritances of priority, each with the time at which its step begins.
        inherited: Vec<(u32, Inheritance)>,
        /// The agent of the highest priority in each step.
        leaders: Vec<AgentId>,
    },
    /// The configurations.
    Lacam(lacam::Trace),
    /// The better plans.
    Lns(Vec<Improvement>),
}
