//! The tree of CBS by hand: what a person splits, and what that gives.
//!
//! A request has all splits so far, so that nothing has to be remembered between two requests.

mod serve;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use super::{ToldConflict, ToldConstraint};

/// The tree of CBS by hand.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct ByHand {
    /// The splits so far, the first of them first; at most 200.
    #[serde(default)]
    pub splits: Vec<HandSplit>,
    /// The node of which it is told what each split would give, by its number.
    #[serde(default)]
    pub node: u64,
}

/// A split by hand.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct HandSplit {
    /// The node, by its number: 0 is the root, and each split adds two.
    pub node: u64,
    /// Which of its conflicts, by time, from 0.
    pub conflict: u32,
    /// The agent of that conflict that both branches name.
    pub agent: String,
}

/// A split that was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct SplitMade {
    /// The node.
    pub node: u64,
    /// The agent that both branches name.
    pub agent: String,
    /// The numbers of the branches.
    pub branches: [u64; 2],
    /// What the rule of the planner splits this node on.
    pub rule: UnmadeSplit,
    /// Whether that is what was split.
    pub is_rule: bool,
}

/// A split that was not made, or not yet.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct UnmadeSplit {
    /// The conflict.
    pub conflict: ToldConflict,
    /// The agent that both branches name.
    pub agent: String,
    /// What it gives.
    pub branches: [ToldBranch; 2],
}

/// A branch of the tree before it is made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct ToldBranch {
    /// Its own constraint.
    pub constraint: ToldConstraint,
    /// The cost of its paths; `null` where an agent has none: a dead end.
    pub cost: Option<u32>,
    /// How many conflicts its paths have.
    pub conflicts: u64,
}

/// What can be split at an open node.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct NodeChoices {
    /// The node.
    pub node: u64,
    /// Its conflicts by time, the first of them.
    pub conflicts: Vec<ConflictChoice>,
    /// How many more it has.
    pub left_out: u64,
}

/// A conflict, and what splitting it gives.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct ConflictChoice {
    /// The conflict.
    pub conflict: ToldConflict,
    /// The two branches that name its first agent, then those that name its second one.
    pub branches: [[ToldBranch; 2]; 2],
}
