//! How a planner went, with names and cells instead of numbers.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Path, Version, message::read_map};
use serde::{Deserialize, Serialize};

use super::{NodeChoices, SplitMade, StuckAgent};

/// How a planner went.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct PlanTrace {
    /// The format's version.
    pub giveway: Version,
    /// The steps of the planner.
    #[serde(flatten)]
    pub went: Went,
}

/// The steps, by planner.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "planner", rename_all = "kebab-case")]
pub enum Went {
    /// The orders that were tried.
    Prioritised {
        /// One after the other, the first of them.
        orders: Vec<OrderTried>,
    },
    /// The constraint tree.
    Cbs {
        /// The nodes by number, the first of them.
        nodes: Vec<TreeNode>,
        /// How many more there were.
        left_out: u64,
    },
    /// The constraint tree by hand.
    CbsByHand {
        /// The nodes by number: the root, then two for each split.
        nodes: Vec<TreeNode>,
        /// The splits, the first of them first.
        splits: Vec<SplitMade>,
        /// What can be split at the node that was asked about; `null` where that is not open.
        choices: Option<NodeChoices>,
    },
    /// The time steps of PIBT.
    Pibt {
        /// The first inheritances of priority.
        inherited: Vec<Inherited>,
        /// The agent of the highest priority in each step, of the first steps.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        leaders: Vec<String>,
    },
    /// The search of LaCAM.
    Lacam {
        /// Its steps, the first of them.
        events: Vec<LacamEvent>,
    },
    /// The better plans of large neighbourhood search.
    Lns {
        /// One after the other, the first of them.
        improvements: Vec<LnsImprovement>,
    },
}

/// An agent lends its priority to another one, which stands in its way.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Inherited {
    /// When the step begins; `null` in the trace of LaCAM, where it is the
    /// configuration's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<u32>,
    /// The agent that lends it.
    pub from: String,
    /// The agent that inherits it.
    pub to: String,
    /// Where the heir stands, and the lender wants to be.
    pub cell: Cell,
}

/// A step of LaCAM: from a configuration to the next.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct LacamEvent {
    /// The number of the configuration that it begins in; 0 is the start.
    pub from: u32,
    /// The first agents of its order, which had to go somewhere.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub constrained: Vec<String>,
    /// Where they had to go.
    pub constraints: Vec<Cell>,
    /// The inheritances of priority.
    pub inherited: Vec<Inherited>,
    /// The number of the configuration that it made; `null` where it made none.
    pub made: Option<u32>,
    /// Whether that was known before.
    pub known: bool,
    /// Where the agents are in a configuration that is new, in the order of the scene; left out of
    /// others, and where configurations are too many to be told.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cells: Vec<Cell>,
}

/// A better plan of large neighbourhood search.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct LnsImprovement {
    /// The agents that got other paths.
    pub changed: Vec<String>,
    /// The costs before, in the order of the objective.
    pub before: Vec<u32>,
    /// The costs after.
    pub after: Vec<u32>,
}

/// One order of prioritised planning.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct OrderTried {
    /// The agents.
    pub order: Vec<String>,
    /// The agents with a path, in this order.
    pub planned: Vec<PlannedAgent>,
    /// The one that did not; `null` where the order works.
    pub stuck: Option<StuckAgent>,
    /// How far that one comes: the longest path of its own around those before it.
    /// Left out where paths are too many to be told.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub furthest: Path,
    /// Whether that path ends where no cell is left free for its next step.
    #[serde(default, skip_serializing_if = "is_false")]
    pub dead_end: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_false(value: &bool) -> bool {
    !*value
}

/// An agent that got a path.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct PlannedAgent {
    /// The agent.
    pub agent: String,
    /// When it arrives.
    pub arrival: u32,
    /// When it would arrive alone.
    pub alone: u32,
    /// Where it arrives later than alone: whom it had to avoid.
    pub around: Vec<String>,
    /// Its path; left out where paths are too many to be told.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub path: Path,
}

/// A node of the constraint tree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct TreeNode {
    /// Its number.
    pub id: u64,
    /// The number of its parent; `null` for the root.
    pub parent: Option<u64>,
    /// Its own constraint, beside those of its ancestors.
    pub constraint: Option<ToldConstraint>,
    /// The cost of its paths: no plan that keeps its constraints costs less. `null`
    /// where an agent cannot keep them.
    pub cost: Option<u32>,
    /// How many conflicts its paths have.
    pub conflicts: u64,
    /// The paths that its parent has not; all of the root. Those of a node that was
    /// split are the ones that have the conflict.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[borsh(deserialize_with = "read_map")]
    pub paths: BTreeMap<String, Path>,
    /// Its fate.
    #[serde(flatten)]
    pub fate: NodeFate,
}

/// The fate of a node.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "fate", rename_all = "kebab-case")]
pub enum NodeFate {
    /// It was not taken out of the open list.
    Open,
    /// An agent cannot keep its constraints.
    Dead,
    /// It was taken out and split at a conflict.
    Split {
        /// As the n-th, from 0.
        turn: u64,
        /// The conflict.
        conflict: ToldConflict,
        /// How often it took the paths of a child that cost no more (bypass).
        bypassed: u32,
    },
    /// It is the answer.
    Best {
        /// As the n-th, from 0.
        turn: u64,
        /// How often it took the paths of a child that cost no more (bypass).
        bypassed: u32,
    },
}

/// A constraint. A positive one (at, along, arrive by) also keeps all others away.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "rule", rename_all = "kebab-case")]
#[expect(missing_docs, reason = "an agent, a cell or an edge, a time in steps")]
pub enum ToldConstraint {
    /// It is not at a cell at a time.
    NotAt {
        agent: String,
        cell: Cell,
        time: u32,
    },
    /// It is at a cell at a time.
    At {
        agent: String,
        cell: Cell,
        time: u32,
    },
    /// It is not on its way from a cell to the next in the step from a time.
    NotAlong {
        agent: String,
        edge: [Cell; 2],
        time: u32,
    },
    /// It is on its way from a cell to the next in the step from a time.
    Along {
        agent: String,
        edge: [Cell; 2],
        time: u32,
    },
    /// It arrives after a time.
    ArriveAfter { agent: String, time: u32 },
    /// It arrives by a time.
    ArriveBy { agent: String, time: u32 },
}

/// A conflict of two agents.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[expect(
    missing_docs,
    reason = "two agents, a cell or an edge, a time in steps, how many of them are delayed for sure"
)]
pub enum ToldConflict {
    /// Both are at a cell.
    Vertex {
        agents: [String; 2],
        cell: Cell,
        time: u32,
        delays: u32,
    },
    /// The first goes along an edge, the second the other way.
    Swap {
        agents: [String; 2],
        edge: [Cell; 2],
        time: u32,
        delays: u32,
    },
    /// The first rests at its goal, and the second comes by.
    Target {
        agents: [String; 2],
        cell: Cell,
        time: u32,
        delays: u32,
    },
}
