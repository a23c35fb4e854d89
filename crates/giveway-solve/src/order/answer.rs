//! The order of a plan, in the shape in which it is written as JSON.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Costs, Plan, Version};
use giveway_order::{Loss, NoOrder, Order, Outcome};
use serde::{Deserialize, Serialize};

use super::OrderFormat;
use crate::{Reason, Stats};

/// The order in another format.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct OrderFile {
    /// The format.
    pub format: OrderFormat,
    /// The text of the file.
    pub text: String,
}

/// The answer to a request for the order of a plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct OrderAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The costs of the plan; `null` without one.
    pub costs: Option<Costs>,
    /// The order; `null` where there is none.
    pub order: Option<Order>,
    /// How many links have no slack: there one agent follows the other in the same step.
    pub without_slack: u32,
    /// The moves that would wait for each other, where no order alone keeps the plan safe.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub none: Option<NoOrder>,
    /// What agents may break though they keep to the order.
    pub losses: Vec<Loss>,
    /// What follows from the lateness that was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub late: Option<Outcome>,
    /// The order in the formats that were asked for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<OrderFile>,
    /// The plan that was found, where none was handed in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// Why there is no plan; nothing in an answer that was read from JSON.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub reason: Option<Reason>,
    /// All of it in words.
    pub words: String,
    /// How much work it took.
    pub stats: Stats,
}
