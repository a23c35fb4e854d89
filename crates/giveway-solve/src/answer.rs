//! Answers, in the shapes in which they are written as JSON.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Costs, Plan, Version, check::Violation, message::read_map};
use serde::{Deserialize, Serialize};

use crate::{Ended, Reach, Reason, search::Proved, trace::SearchTrace};

/// How much a search has proved. Running out is never "no solution".
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// A plan, and a proof that none is better.
    Optimal,
    /// A plan, and the bounds proved so far: the budget ran out.
    Feasible,
    /// No plan exists.
    Impossible,
    /// The budget ran out with neither.
    Unknown,
}

/// How much work an answer took.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Stats {
    /// CPU seconds (wall seconds in the browser).
    pub cpu_seconds: f64,
    /// Calls of the SAT solver.
    pub solver_calls: u64,
    /// SAT variables.
    pub variables: u64,
    /// Clauses given to the SAT solver.
    pub clauses: u64,
    /// Conflicts that it met.
    pub conflicts: u64,
    /// Units of work, as a limit of work counts them.
    #[serde(default)]
    pub work: u64,
}

/// The answer to a solve request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct SolveAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The proved status.
    pub status: Status,
    /// All five costs of the plan; `null` without one.
    pub costs: Option<Costs>,
    /// The proved lower bound of each cost of the objective reached so far.
    #[borsh(deserialize_with = "read_map")]
    pub bounds: BTreeMap<Cost, u32>,
    /// How far claim and bounds reach. Where the claim is gone but not its bounds, it is how
    /// far these reach ([`Reach::of_bounds`]).
    #[serde(flatten)]
    pub reach: Reach,
    /// The limit that ended the search; left out where there was none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ended: Option<Ended>,
    /// Why there is no plan or no proof; nothing otherwise, and in an answer that was read
    /// from JSON.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub reason: Option<Reason>,
    /// The plan.
    pub plan: Option<Plan>,
    /// How much work it took.
    pub stats: Stats,
    /// How it was found and proved, where that was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub trace: Option<SearchTrace>,
}

impl SolveAnswer {
    /// An answer without a plan.
    pub(crate) fn without_plan(
        status: Status,
        reach: Option<Proved>,
        (ended, reason): (Ended, Reason),
        stats: Stats,
    ) -> Self {
        Self {
            giveway: Version,
            status,
            costs: None,
            bounds: BTreeMap::new(),
            reach: reach.into(),
            ended: Some(ended),
            reason: Some(reason),
            plan: None,
            stats,
            trace: None,
        }
    }
}

/// The answer to a request for a Pareto front.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
pub struct FrontAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The proved status of the front as a whole.
    pub status: Status,
    /// The limit that ended the search for its points; left out where there was none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ended: Option<Ended>,
    /// How far the claim reaches.
    #[serde(flatten)]
    pub reach: Reach,
    /// One answer a point, in the order of the first cost.
    pub front: Vec<SolveAnswer>,
}

/// The answer to a check request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct CheckAnswer {
    /// The format's version.
    pub giveway: Version,
    /// Whether no rule is broken.
    pub valid: bool,
    /// The costs, as far as the paths have them; `null` where an agent has none.
    pub costs: Option<Costs>,
    /// Every violation, by time.
    pub violations: Vec<Violation>,
}
