//! The request for plans of more and more robots.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use crate::Limits;

/// How many robots does a floor bear?
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct SizingRequest {
    /// The floor with all robots, in the order in which they are added; unchecked.
    pub scene: Scene,
    /// Another floor for the same numbers of robots, to be compared: with a charger more, say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beside: Option<Scene>,
    /// The numbers of robots, ascending: the first of the scene, so many of them.
    pub counts: Vec<u32>,
    /// The objective, where it is not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon of each solve, in time steps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// The budget of each solve by itself.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}
