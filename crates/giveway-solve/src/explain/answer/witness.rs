//! Things that would go wrong, and counts that are higher than in a better plan.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, check::Violation};
use serde::{Deserialize, Serialize};

/// A count that is higher for an agent in this plan than in a better one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Excess {
    /// The agent.
    pub agent: String,
    /// Time steps before its arrival (as `sum-of-costs`), charges, moves or
    /// waits.
    pub cost: Cost,
    /// By how much.
    pub by: u32,
}

/// One thing that would go wrong.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct WitnessEntry {
    /// The broken rule, with place, time and agents.
    #[serde(flatten)]
    pub violation: Violation,
    /// The rules that were soft, where there is no plan at all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub class: Option<Class>,
}

/// A class of rules, of which a relaxed plan breaks as few as it can.
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
pub enum Class {
    /// Vertex and swap collisions, counted by pair and time.
    Collision,
    /// Agents in obstacles, counted by agent and time.
    Obstacle,
    /// Batteries that run empty, counted by agent.
    Battery,
    /// Waypoints not visited, counted by agent and waypoint.
    Waypoint,
}
