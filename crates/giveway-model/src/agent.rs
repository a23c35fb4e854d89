//! An agent and its task.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::Cell;
use crate::object_only;

/// A battery, in time steps: one step of waiting or moving takes one.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Battery {
    /// The level after a charge.
    pub capacity: u32,
    /// The level at time 0, at most the capacity.
    pub initial: u32,
}

object_only!(Battery);

/// An agent (a robot): where it starts, where it must go, what it must visit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Agent {
    /// Unique in its instance, not empty.
    pub name: String,
    /// Where it is at time 0.
    pub start: Cell,
    /// Where it ends.
    pub goal: Cell,
    /// Cells to visit, in any order, before or on arrival.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub waypoints: Vec<Cell>,
    /// Its battery; `None` is unlimited.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub battery: Option<Battery>,
}

object_only!(Agent);
