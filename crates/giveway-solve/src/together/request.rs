//! The request about some agents alone.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use crate::{
    Limits,
    trace::{AgentLeast, AgentLimit, Core},
};

/// Why can these agents not all keep their limits?
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct TogetherRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The cost that is limited.
    pub cost: Cost,
    /// The agents, and the most that each may have of it.
    pub agents: Vec<AgentLimit>,
    /// The limit on their sum beyond the least of each, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub more: Option<u32>,
    /// Only plans of at most this makespan count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// The budget.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

impl TogetherRequest {
    /// The claim of a core as a request about its agents: its own limits where it is about agents alone, else
    /// a sum that is one less than they need.
    pub fn about(core: &Core, scene: Scene) -> Self {
        let (agents, more) = match &core.together {
            Some(together) if !core.sums.is_empty() => {
                let more = together.more.saturating_sub(1);
                let limit = |own: &AgentLeast| AgentLimit {
                    agent: own.agent.clone(),
                    least: own.least,
                    at_most: own.least.saturating_add(more),
                };
                (together.agents.iter().map(limit).collect(), Some(more))
            }
            _ => (core.limits.clone(), None),
        };
        let scope = &core.scope;
        let given = scope.given.get(&Cost::Makespan).copied();
        Self {
            scene,
            cost: core.cost,
            agents,
            more,
            within: given.into_iter().chain(scope.within).min(),
            limits: Limits::default(),
        }
    }
}
