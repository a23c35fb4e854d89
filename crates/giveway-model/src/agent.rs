//! An agent and its task.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::Cell;
use crate::constraint::Heading;
use crate::object::null_is_default;
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
    /// Where it ends; without a goal it may rest at any cell, and stays there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub goal: Option<Cell>,
    /// Cells to visit, in any order, before or on arrival.
    #[serde(
        default,
        deserialize_with = "null_is_default",
        skip_serializing_if = "Vec::is_empty"
    )]
    pub waypoints: Vec<Cell>,
    /// Its battery; `None` is unlimited.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub battery: Option<Battery>,
    /// Where it faces at first, which matters where turns take time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heading: Option<Heading>,
}

object_only!(Agent);

impl Agent {
    /// An agent without waypoints and battery.
    pub fn new(name: impl Into<String>, start: Cell, goal: Option<Cell>) -> Self {
        Self {
            name: name.into(),
            start,
            goal,
            waypoints: Vec::new(),
            battery: None,
            heading: None,
        }
    }

    /// Its goal, for formats in which each agent has one; its start where it has none.
    pub fn goal_or_start(&self) -> Cell {
        self.goal.unwrap_or(self.start)
    }
}

/// Whether a path ends with a step of rest: its last two entries are one cell, at
/// which the agent may rest. Without a goal it may rest at any cell.
///
/// ```
/// use giveway_model::{Cell, ends_with_rest};
/// let [a, b] = [Cell::new(0, 0), Cell::new(1, 0)];
/// assert!(ends_with_rest(&[Some(a), Some(b), Some(b)], None));
/// assert!(!ends_with_rest(&[Some(a), Some(b), Some(b)], Some(a)));
/// ```
pub fn ends_with_rest(path: &[Option<Cell>], goal: Option<Cell>) -> bool {
    matches!(path, [.., before, Some(last)]
        if *before == Some(*last) && goal.is_none_or(|goal| goal == *last))
}
