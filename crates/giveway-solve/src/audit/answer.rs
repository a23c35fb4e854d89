//! The answer to an audit of a plan.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Costs, Objective, Plan, Version, check::Violation, message::read_map};
use serde::{Deserialize, Serialize};

use crate::{Reach, Reason, Stats, Status};

/// The verdict of an audit.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum AuditStatus {
    /// It is legal, and proved to be the best.
    Optimal,
    /// It is legal, and no further from the best than the gap.
    Feasible,
    /// It breaks a rule.
    Illegal,
    /// It is legal, and nothing is known of how good it is.
    Unknown,
}

/// The answer to an audit request.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
pub struct AuditAnswer {
    /// The format's version.
    pub giveway: Version,
    /// Whether the plan breaks no rule.
    pub legal: bool,
    /// Every rule that it breaks, by time.
    pub violations: Vec<Violation>,
    /// The costs by which plans are compared, the most important first.
    pub objective: Objective,
    /// The costs of the plan as it stands, legal or not; `null` where an agent has
    /// no path.
    pub costs: Option<Costs>,
    /// The proved lower bound of each cost of the objective reached so far: no legal
    /// plan has less of the first one, and none that is best in those before has less
    /// of a later one.
    #[borsh(deserialize_with = "read_map")]
    pub bounds: BTreeMap<Cost, u32>,
    /// How far the bounds, and what is claimed with them, reach.
    #[serde(flatten)]
    pub reach: Reach,
    /// The verdict.
    pub status: AuditStatus,
    /// How far a legal plan may be from the best: its first cost beyond the bound, as
    /// a part of the bound; `null` for an illegal plan, and where there is no such
    /// number. What it is for an optimal plan is 0.
    pub gap: Option<f64>,
    /// A legal plan with lower costs, or, if the audited one is illegal, any legal
    /// plan; the best that was found.
    pub better: Option<Plan>,
    /// Its costs.
    pub better_costs: Option<Costs>,
    /// The status of the search for the best plan: `optimal` where `better`, or else the audited plan, is
    /// proved optimal; `impossible` where no legal plan exists.
    pub search: Status,
    /// Why something is not known, or why there is no legal plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<Reason>,
    /// How much work it took.
    pub stats: Stats,
}

impl AuditAnswer {
    /// The first cost of the objective.
    pub fn first_cost(&self) -> Option<Cost> {
        self.objective.costs().first().copied()
    }
}

/// The gap between the first cost of an objective and its bound, as a part of the bound; `None` where the
/// bound is 0 and the cost is not.
pub fn gap(objective: &Objective, costs: &Costs, bounds: &BTreeMap<Cost, u32>) -> Option<f64> {
    let first = objective.costs().first()?;
    let (cost, bound) = (costs.get(*first), *bounds.get(first)?);
    let beyond = cost.checked_sub(bound)?;
    match (beyond, bound) {
        (0, _) => Some(0.0),
        (_, 0) => None,
        _ => Some(f64::from(beyond) / f64::from(bound)),
    }
}
