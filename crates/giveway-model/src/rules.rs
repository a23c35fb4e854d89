//! The rules that an instance may set.

use serde::{Deserialize, Serialize};

/// What becomes of an agent at its goal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AtGoal {
    /// It remains there and blocks the cell.
    #[default]
    Stay,
    /// It holds its goal at its arrival and is gone from the next time on.
    Vanish,
}

/// The rules of an instance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Rules {
    /// What becomes of an agent at its goal.
    pub at_goal: AtGoal,
    /// The level below which no battery may fall before arrival.
    pub battery_floor: u32,
}
