//! What is asked of some agents.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use crate::{Limits, trace::AgentLimit};

/// Why can these agents not all keep their limits?
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct TogetherRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The cost that is limited.
    pub cost: Cost,
    /// The agents, and the most that each may have of it. Of one that is asked about
    /// in [`Together`](crate::trace::Together) that is its own least and all that they
    /// have beyond it.
    pub agents: Vec<AgentLimit>,
    /// What they may have together beyond the least of each, where that is limited.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub more: Option<u32>,
    /// The budget.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}
