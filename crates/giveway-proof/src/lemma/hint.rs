//! Hints: what the search for a plan found to be in the way.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Cost;
use giveway_model::message::read_map;
use serde::{Deserialize, Serialize};

/// A core of the search that raised a bound by one. Nothing here is believed: lemmas made of it are proved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct Hint {
    /// The cost that it bounds.
    pub cost: Cost,
    /// Its own agents, each with the most that it has of the cost; an arrival for the makespan and the sum
    /// of costs.
    #[borsh(deserialize_with = "read_map")]
    pub limits: BTreeMap<String, u32>,
    /// The agents of this core and of all that it builds on.
    pub agents: Vec<String>,
    /// How many cores these are: their agents together have so much more than the least of each. 0
    /// for the makespan.
    pub more: u32,
    /// Whether it speaks of its own agents alone, each by itself.
    pub is_clause: bool,
}
