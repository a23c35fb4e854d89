//! The request for the prices of rules.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Plan, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use crate::Limits;

/// What does each rule of the scene's own that is in force cost?
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct PriceRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The objective, where it is not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon, in time steps: only plans of at most this makespan count.
    /// By default that of a solve request, for each side.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// A plan that is known already, as for a solve request.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<Plan>,
    /// The price of this rule alone, by its number in the scene, and the
    /// least by which it has to ask for less so that the costs change, or there is a plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loosen: Option<u32>,
    /// The budget for all prices together.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}
