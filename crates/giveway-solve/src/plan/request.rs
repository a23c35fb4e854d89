//! The request to a planner of the textbook.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use super::{ByHand, Planner};
use crate::Limits;

/// Find a plan with a planner of the textbook.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// Which planner.
    pub planner: Planner,
    /// The objective, where it is not the scene's own. CBS makes its first cost
    /// least, makespan or sum-of-costs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon, in time steps; by default that of a solve request.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// The order of prioritised planning, by name; agents that are not named come
    /// last. By default it is found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub order: Option<Vec<String>>,
    /// The tree of CBS by hand, instead of the planner's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub by_hand: Option<ByHand>,
    /// Whether to tell how it went; a tree by hand is told in any case.
    #[serde(default)]
    pub trace: bool,
    /// The budget; conflicts are those of SAT solvers, and limit nothing here.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

impl PlanRequest {
    /// A request for a plan of a scene, with everything else as by default.
    pub fn new(scene: Scene, planner: Planner) -> Self {
        Self {
            scene,
            planner,
            objective: None,
            within: None,
            order: None,
            by_hand: None,
            trace: false,
            limits: Limits::default(),
        }
    }
}
