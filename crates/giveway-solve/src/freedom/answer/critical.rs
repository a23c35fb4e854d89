//! The cost of closing a cell.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Cost, Costs, message::read_map};
use serde::{Deserialize, Serialize};

use crate::Reach;

/// A free cell of the map, and what it would cost to make it an obstacle.
///
/// As JSON: `{ "cell": [5, 2], "status": "optimal", "costs": {..}, "deltas":
/// { "makespan": 2 }, "complete": true, "within": null }`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(into = "WrittenCell", try_from = "WrittenCell")]
pub struct CriticalCell {
    /// The cell.
    pub cell: Cell,
    /// The scene without it.
    pub closed: Closed,
}

/// The result of closing a cell.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Closed {
    /// There is a best plan, proved to be one.
    Optimal {
        /// Its costs.
        costs: Costs,
        /// How much more it has of each cost of the objective; less only of one that
        /// stands after a cost of which it has more.
        #[borsh(deserialize_with = "read_map")]
        deltas: BTreeMap<Cost, i64>,
        /// How far the proof reaches; never nothing.
        reach: Reach,
    },
    /// There is no plan.
    Impossible {
        /// The need of an agent for this very cell, where there is one.
        needed: Option<Need>,
        /// How far the proof reaches; never nothing.
        reach: Reach,
    },
    /// Neither was proved before the budget ran out.
    Unknown {
        /// Whether it is proved that it costs something, or leaves no plan.
        worse: bool,
    },
}

/// Why no scene is left without a cell.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Need {
    /// An agent starts there.
    Start,
    /// An agent's goal is there.
    Goal,
    /// An agent must visit it.
    Waypoint,
    /// A rule of the scene wants an agent there.
    Rule,
}

impl Closed {
    /// Whether closing the cell is proved to cost nothing.
    pub fn is_harmless(&self) -> bool {
        matches!(self, Self::Optimal { deltas, .. } if deltas.values().all(|&delta| delta == 0))
    }

    /// Whether it is not known what closing the cell would cost.
    pub const fn is_open(&self) -> bool {
        matches!(self, Self::Unknown { .. })
    }
}

/// The status as it is written.
#[derive(Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ClosedStatus {
    Impossible,
    Optimal,
    Unknown,
}

/// A cell as it is written.
#[derive(Clone, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
struct WrittenCell {
    cell: Cell,
    status: ClosedStatus,
    costs: Option<Costs>,
    deltas: Option<BTreeMap<Cost, i64>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    needed: Option<Need>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    worse: Option<bool>,
    #[serde(flatten)]
    reach: Reach,
}

impl From<CriticalCell> for WrittenCell {
    fn from(critical: CriticalCell) -> Self {
        let empty = Self {
            cell: critical.cell,
            status: ClosedStatus::Unknown,
            costs: None,
            deltas: None,
            needed: None,
            worse: None,
            reach: Reach::default(),
        };
        match critical.closed {
            Closed::Optimal {
                costs,
                deltas,
                reach,
            } => Self {
                status: ClosedStatus::Optimal,
                costs: Some(costs),
                deltas: Some(deltas),
                reach,
                ..empty
            },
            Closed::Impossible { needed, reach } => Self {
                status: ClosedStatus::Impossible,
                needed,
                reach,
                ..empty
            },
            Closed::Unknown { worse } => Self {
                worse: Some(worse),
                ..empty
            },
        }
    }
}

impl TryFrom<WrittenCell> for CriticalCell {
    type Error = &'static str;

    fn try_from(written: WrittenCell) -> Result<Self, &'static str> {
        let reach = Some(written.reach).filter(|&reach| reach != Reach::default());
        let closed = match (written.status, reach, written.costs, written.deltas) {
            (ClosedStatus::Optimal, Some(reach), Some(costs), Some(deltas)) => Closed::Optimal {
                costs,
                deltas,
                reach,
            },
            (ClosedStatus::Impossible, Some(reach), None, None) => Closed::Impossible {
                needed: written.needed,
                reach,
            },
            (ClosedStatus::Unknown, None, None, None) => Closed::Unknown {
                worse: written.worse.unwrap_or(false),
            },
            _ => return Err("found a closed cell whose parts contradict its status"),
        };
        Ok(Self {
            cell: written.cell,
            closed,
        })
    }
}
