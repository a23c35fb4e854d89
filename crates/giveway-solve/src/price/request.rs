//! The request for the prices of rules.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Plan, Scene, format::from_object};
use serde::{Deserialize, Serialize};

use super::RulePrice;
use crate::{Limits, SolveAnswer};

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
    /// What the front that asks knows already, by answers to the same scene, objective and
    /// horizon: it is not looked for again. Only programs of the same build hand it on; no file
    /// has it.
    #[serde(skip)]
    pub known: Option<Box<KnownPrices>>,
    /// The budget for all prices together.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

/// What is known of prices before they are asked for.
#[derive(Clone, Debug, Default, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct KnownPrices {
    /// The answer with all rules, where its plan is proved best.
    pub with: Option<SolveAnswer>,
    /// Plans that may keep all rules but one: of those that do, the search begins with the best.
    pub plans: Vec<Plan>,
    /// Prices of an earlier answer. Those that are exact stay; of the others the search goes on
    /// with the plan.
    pub prices: Vec<RulePrice>,
}

impl KnownPrices {
    /// The price of a rule, by its number in the scene.
    pub(super) fn price(&self, rule: usize) -> Option<&RulePrice> {
        self.prices.iter().find(|it| it.index as usize == rule)
    }
}
