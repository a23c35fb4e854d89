//! The request for the delays of a plan.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Plan, Scene, change::Changes, format::from_object};
use serde::{Deserialize, Serialize};

use crate::Limits;

/// Who costs whom in a plan?
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct DelaysRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The plan; without one, the scene is solved first. With changes it has to be there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// What changed while the plan ran: each agent is compared with its best way alone from where
    /// the last of these changes finds it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changes: Option<Changes>,
    /// The time as of which is asked: later changes do not count. By default all count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<u32>,
    /// The objective, where it is not the scene's own: the costs before the sum of costs in it
    /// are kept by the plans that the proof speaks of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon of the proof, in time steps from the beginning of the whole plan. By default
    /// that of a solve request, and never less than the makespan of the plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// Whether the search for a proof is left out. One that solved the scene already has it:
    /// see [`DelaysAnswer::prove_by`](super::DelaysAnswer::prove_by).
    #[serde(default)]
    pub ledger_only: bool,
    /// The budget.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}
