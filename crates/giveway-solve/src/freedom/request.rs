//! The request about all best plans.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Plan, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use crate::{Limits, ProvedBest};

/// A part of the answer; parts are served in this order.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum FreedomPart {
    /// The backbone: visits that every best plan has, and visits that only this one has.
    Backbone,
    /// How late each agent could be.
    Slack,
    /// How many best plans there are, and the ways that agents can choose from.
    Plans,
    /// The cost of closing each free cell.
    Critical,
    /// Another best plan, as different from this one as can be.
    Farthest,
}

impl FreedomPart {
    /// All of them, in the order in which they are served.
    pub const ALL: [Self; 5] = [
        Self::Backbone,
        Self::Slack,
        Self::Plans,
        Self::Critical,
        Self::Farthest,
    ];
}

/// The number of plans up to which is counted where nothing else is asked for.
pub const DEFAULT_COUNT: u32 = 1000;

/// Tell what must be so in every best plan, and what is free to choose.
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct FreedomRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The plan that is looked at. Where it is not proved to be a best one, that is
    /// done first; without one, the scene is solved first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// The objective, where it is not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon, in time steps: only plans of at most this makespan count.
    /// By default the largest single-agent optimum + 4 (width + height) + 10.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// What the front that asks had proved: that no plan is better than `plan`, by an answer
    /// to the same scene, objective and horizon. It is not proved again. Only programs of the
    /// same build hand it on; no file has it.
    #[serde(skip)]
    pub proved: Option<ProvedBest>,
    /// The parts that are asked for, in any order; all where none is named.
    #[serde(default)]
    pub parts: Vec<FreedomPart>,
    /// The number of plans up to which is counted; 1,000 where it is not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub count: Option<u32>,
    /// The budget.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

impl FreedomRequest {
    /// The parts that are asked for, in the order in which they are served.
    pub fn asked(&self) -> Vec<FreedomPart> {
        let asked = |part: &FreedomPart| self.parts.is_empty() || self.parts.contains(part);
        FreedomPart::ALL.into_iter().filter(asked).collect()
    }

    /// The number of plans up to which is counted.
    pub fn count_limit(&self) -> u32 {
        self.count.unwrap_or(DEFAULT_COUNT)
    }
}
