//! The requests of a front: plain data.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Plan, Scene, change::Changes, format::from_object};
use serde::{Deserialize, Serialize};

use crate::audit::AuditRequest;
use crate::change::ChangeRequest;
use crate::delays::DelaysRequest;
use crate::order::OrderRequest;
use crate::sizing::SizingRequest;
use crate::together::TogetherRequest;
use crate::{
    CertifyRequest, ExportRequest, explain::ExplainRequest, freedom::FreedomRequest,
    plan::PlanRequest, price::PriceRequest,
};

/// A request to the [service](crate::service).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "request", rename_all = "kebab-case")]
pub enum Request {
    /// Find and prove the best plan, or the Pareto front.
    Solve(SolveRequest),
    /// Judge a plan.
    Check(CheckRequest),
    /// Answer a question about a plan, or about there being none.
    Explain(ExplainRequest),
    /// Prove again what was answered, and check the proofs.
    Certify(CertifyRequest),
    /// The same, as files that anyone can check.
    Export(ExportRequest),
    /// Go on with a plan around which the world changes.
    Change(ChangeRequest),
    /// Judge a plan, and tell how far it is from the best.
    Audit(AuditRequest),
    /// Find a plan with a planner of the textbook.
    Plan(PlanRequest),
    /// Tell what must be so in every best plan.
    Freedom(FreedomRequest),
    /// Why can some agents not all keep their limits?
    Together(TogetherRequest),
    /// What does each rule of the scene's own cost?
    Price(PriceRequest),
    /// Who costs whom in a plan?
    Delays(DelaysRequest),
    /// Who must begin to leave each cell before who begins to come?
    Order(OrderRequest),
    /// How many robots does a floor bear?
    Sizing(SizingRequest),
}

/// A request that needs no more than search and judge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Basic<'a> {
    /// Find and prove the best plan.
    Solve(&'a SolveRequest),
    /// Go on with a plan around which the world changes.
    Change(&'a ChangeRequest),
}

impl Request {
    /// The request as one that [`serve_basic`](crate::serve_basic) serves; `None`
    /// where it takes [`serve`](crate::serve).
    pub const fn basic(&self) -> Option<Basic<'_>> {
        match self {
            Self::Solve(request) if !request.pareto => Some(Basic::Solve(request)),
            Self::Change(request) => Some(Basic::Change(request)),
            Self::Solve(_)
            | Self::Check(_)
            | Self::Explain(_)
            | Self::Certify(_)
            | Self::Export(_)
            | Self::Audit(_)
            | Self::Plan(_)
            | Self::Together(_)
            | Self::Price(_)
            | Self::Delays(_)
            | Self::Order(_)
            | Self::Sizing(_)
            | Self::Freedom(_) => None,
        }
    }
}

/// Find and prove the best plan, or the Pareto front.
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct SolveRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The objective, where it is not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// All non-dominated cost vectors of the objective's two or three costs,
    /// instead of the lexicographic best.
    #[serde(default)]
    pub pareto: bool,
    /// The horizon, in time steps: only plans of at most this makespan count.
    /// By default the largest single-agent optimum + 4 (width + height) + 10.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// A plan that is known already, such as the best one of a search that was
    /// cancelled: the search begins with it instead of looking for a first plan.
    /// It is ignored where the judge does not pass it for this scene, or its
    /// makespan is beyond the horizon. It changes no claim; where several plans
    /// are optimal, it may decide which of them is found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<Plan>,
    /// Whether to tell how the plan was found and proved; not with `pareto`.
    #[serde(default)]
    pub trace: bool,
    /// Whether the plan stays as the search found it: among plans of equal cost it is
    /// otherwise made a calm one. For programs that compare fingerprints of certificates,
    /// of which the plan is a part; no message and no file has it.
    #[serde(skip)]
    #[borsh(skip)]
    pub as_found: bool,
    /// The budget.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

/// Judge a plan.
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct CheckRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The plan.
    pub plan: Plan,
    /// The changes while it runs; each time is judged in the world of that time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changes: Option<Changes>,
}

/// A budget; what is `None` is not limited (memory: see the field).
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields, default)]
pub struct Limits {
    /// Wall seconds for the whole request, by the host's clock.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
    /// Conflicts of the SAT solver for the whole request.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub conflicts: Option<u64>,
    /// Units of work for the whole request: states that planners, tables and local search
    /// look at, and what the SAT solver does, weighed in states. Where only this limit
    /// ends a search, the same request has the same answer each time, natively and in Wasm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub work: Option<u64>,
    /// Bytes that the request may hold, by the solver's own estimate and, where
    /// the host can tell, in fact; 1.5 GB where it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory_bytes: Option<u64>,
}
