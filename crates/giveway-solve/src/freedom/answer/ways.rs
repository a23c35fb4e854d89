//! How many best plans there are, and what agents can choose from.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Plan, message::read_map};
use serde::{Deserialize, Serialize};

use super::{Known, PlanCount};

/// The best plans, counted. Two plans are the same where every agent is in the same
/// cell at each time and charges at the same times.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Plans {
    /// How many.
    #[serde(flatten)]
    pub number: PlanCount,
    /// The choices of each agent. Where the numbers of ways multiply to the number of plans, each choice is
    /// independent of all others.
    #[borsh(deserialize_with = "read_map")]
    pub ways: BTreeMap<String, Ways>,
}

/// The ways of one agent in best plans.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Ways {
    /// How many, told apart by cells, times and charges.
    #[serde(flatten)]
    pub number: PlanCount,
    /// Every step that it takes in a best plan that was found, by time.
    pub steps: Vec<Step>,
    /// Whether it is proved that it takes no other step in any best plan.
    pub all: Known,
}

/// A step before the arrival: a move, or a wait where both cells are the same.
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
pub struct Step {
    /// The time at which it begins.
    pub time: u32,
    /// Where it begins.
    pub from: Cell,
    /// Where it ends, one step later, or two where it is slow.
    pub to: Cell,
}

/// Another best plan, as different from this one as can be.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "status", rename_all = "kebab-case")]
pub enum Farthest {
    /// It is proved that there is no other best plan.
    Only,
    /// There is another one.
    Found {
        /// The plan.
        plan: Box<Plan>,
        /// In how many entries it differs: times at which an agent is elsewhere (or in
        /// transit elsewhere), or charges in one plan alone. Arrived agents are at
        /// their goals where they stay, and nowhere where they vanish.
        differs: u32,
        /// Whether it is proved that no best plan differs in more.
        most: Known,
    },
    /// None was found before the budget ran out.
    Unknown,
}
