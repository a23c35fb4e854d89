//! Questions that a person may ask of a plan, and what each contrasts it with.
//!
//! Questions are contrastive ("why this rather than that?"): each has a
//! *contrast*, a [`Condition`](crate::condition::Condition) on another plan, but for
//! the two about the instance or the plan as a whole. See Bogatarkan and Erdem,
//! "Explanation Generation for Multi-Modal Multi-Agent Path Finding with
//! Optimal Resource Utilization using Answer Set Programming" (2020).

mod agents;
mod asked;
mod condition;
mod fits;
mod holds;
mod least;
mod misfit;
mod names;
mod not_so;
mod sentence;
mod so;
mod words;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::{Cell, Constraint};

pub use asked::Asked;
pub use fits::fits;
pub use holds::holds;
pub use misfit::Misfit;
pub use names::names_exist;
pub use sentence::sentence;
pub use words::{WordsError, from_words, to_words};

/// A question. Times are steps from 0; agents go by their names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(
    tag = "kind",
    rename_all = "kebab-case",
    rename_all_fields = "kebab-case",
    deny_unknown_fields
)]
pub enum Question {
    /// Why does it wait? Or, with `at-least`, why so long?
    Wait {
        /// The agent.
        agent: String,
        /// The cell; anywhere where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        at: Option<Cell>,
        /// The first time of the interval; 0 where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        from: Option<u32>,
        /// The last time of the interval; the arrival where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        to: Option<u32>,
        /// The wait steps on end that count as long.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        at_least: Option<u32>,
    },
    /// Why does it charge?
    Charge {
        /// The agent.
        agent: String,
        /// The charger; anywhere where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        at: Option<Cell>,
        /// The time; ever where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        time: Option<u32>,
    },
    /// Why does it not charge there?
    NoCharge {
        /// The agent.
        agent: String,
        /// The charger.
        at: Cell,
    },
    /// Why does it pass a cell?
    Visit {
        /// The agent.
        agent: String,
        /// The cell.
        at: Cell,
        /// The time; ever where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        time: Option<u32>,
    },
    /// Why does it not pass a cell? Without an agent: why does nobody?
    NoVisit {
        /// The agent; any where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        agent: Option<String>,
        /// The cell.
        at: Cell,
    },
    /// Why does it go from one cell to another?
    Move {
        /// The agent.
        agent: String,
        /// Where it leaves.
        from_cell: Cell,
        /// Where it goes.
        to_cell: Cell,
        /// The time at which it leaves; ever where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        time: Option<u32>,
    },
    /// Why does it not go from one cell to another?
    NoMove {
        /// The agent.
        agent: String,
        /// Where it would leave.
        from_cell: Cell,
        /// Where it would go.
        to_cell: Cell,
        /// The time at which it would leave; ever where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        time: Option<u32>,
    },
    /// Why does it take the slow way? Over one edge, either way, where both of
    /// its cells are given; over any else.
    Slow {
        /// The agent.
        agent: String,
        /// One end of the edge.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        from_cell: Option<Cell>,
        /// The other end.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        to_cell: Option<Cell>,
    },
    /// Why does it visit one cell before another?
    Order {
        /// The agent.
        agent: String,
        /// The cell that it visits first.
        first: Cell,
        /// The cell that it visits after that.
        second: Cell,
    },
    /// Why does it arrive only then?
    Arrival {
        /// The agent.
        agent: String,
    },
    /// Why is its path this long?
    Length {
        /// The agent.
        agent: String,
        /// The moves that would be too many; those of the plan where it is left
        /// out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        fewer_than: Option<u32>,
    },
    /// Why can the last arrival not be sooner?
    Makespan,
    /// Why can the sum of arrivals not be less?
    SumOfCosts,
    /// Why can the penalty of rules not be less?
    Penalty,
    /// Why not fewer charges, of one agent or of all?
    Charges {
        /// The agent; all where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        agent: Option<String>,
    },
    /// Why not fewer moves, of one agent or of all?
    Moves {
        /// The agent; all where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        agent: Option<String>,
    },
    /// Why not fewer waits, of one agent or of all?
    Waits {
        /// The agent; all where it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        agent: Option<String>,
    },
    /// Why does one agent give way to another at a cell?
    Yield {
        /// The agent that comes later.
        agent: String,
        /// The one that comes first.
        to: String,
        /// The cell.
        at: Cell,
    },
    /// Why does the plan not keep this rule, which is none of the scene's?
    Rule {
        /// The rule; it forbids something.
        rule: Box<Constraint>,
    },
    /// Why is there no plan?
    Unsolvable,
    /// Is this plan all right, and is it the best?
    Plan,
}

impl Question {
    /// The kind, as it is written in files and on the command line.
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Wait { .. } => "wait",
            Self::Charge { .. } => "charge",
            Self::NoCharge { .. } => "no-charge",
            Self::Visit { .. } => "visit",
            Self::NoVisit { .. } => "no-visit",
            Self::Move { .. } => "move",
            Self::NoMove { .. } => "no-move",
            Self::Slow { .. } => "slow",
            Self::Order { .. } => "order",
            Self::Arrival { .. } => "arrival",
            Self::Length { .. } => "length",
            Self::Makespan => "makespan",
            Self::SumOfCosts => "sum-of-costs",
            Self::Penalty => "penalty",
            Self::Charges { .. } => "charges",
            Self::Moves { .. } => "moves",
            Self::Waits { .. } => "waits",
            Self::Yield { .. } => "yield",
            Self::Rule { .. } => "rule",
            Self::Unsolvable => "unsolvable",
            Self::Plan => "plan",
        }
    }
}
