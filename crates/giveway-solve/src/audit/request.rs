//! The request for an audit of a plan.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Plan, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use crate::Limits;

/// Audit a plan: is it legal, and how good is it?
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct AuditRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The plan; it may break any rule.
    pub plan: Plan,
    /// The costs by which plans are compared, where they are not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon, in time steps: the plan is compared with plans of at most this
    /// makespan. It is never less than that of the plan itself, if that is legal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// The budget.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}
