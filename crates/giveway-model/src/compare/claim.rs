//! Costs and bounds of a plan as a file states them.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

/// The costs that a file claims for its plan, by its maker's definitions.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub struct Claimed {
    /// The largest arrival.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub makespan: Option<u64>,
    /// The sum of arrivals (`soc`, `solution_cost`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sum_of_costs: Option<u64>,
}

/// The costs that a file claims as lower bounds of every plan, and a cost that is compared by its own
/// definition.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub struct ClaimedBounds {
    /// Of the largest arrival (`makespan_lb`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub makespan: Option<u64>,
    /// Of the sum of arrivals (`lower_cost`, `soc_lb`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sum_of_costs: Option<u64>,
    /// Of the steps that do not begin and end at the goal (`sum_of_loss_lb`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sum_of_loss: Option<u64>,
    /// These steps of the plan itself (`sum_of_loss`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss: Option<u64>,
}
