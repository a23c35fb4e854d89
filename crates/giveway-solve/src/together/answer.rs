//! Where agents can be, where they must meet, and what holds of them alone.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Scene, Version};
use serde::{Deserialize, Serialize};

use crate::SolveAnswer;

/// The answer to a request about some agents.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
pub struct TogetherAnswer {
    /// The format's version.
    pub giveway: Version,
    /// Where each can be while it keeps its limit, in the order of the request; none
    /// where the limit is no time, where an agent cannot do its task even alone, and
    /// where the budget was spent.
    pub regions: Vec<Region>,
    /// Where an agent has to be at a time to keep its limit, as far as that explains
    /// the meetings.
    pub passes: Vec<MustPass>,
    /// Where two of them collide whichever ways they take that keep their limits: one
    /// place for each pair, where there is one.
    pub meetings: Vec<MustMeet>,
    /// The same search for these agents alone; `null` where they are more than four.
    pub alone: Option<Alone>,
}

/// Where an agent can be while it keeps its limit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Region {
    /// The agent.
    pub agent: String,
    /// When it has to arrive at the latest.
    pub by: u32,
    /// The cells, by row.
    pub cells: Vec<CellTimes>,
}

/// A cell, and when an agent can be there. A cell of a slow move counts at the end
/// that it leaves.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct CellTimes {
    /// The cell.
    pub cell: Cell,
    /// The first time.
    pub first: u32,
    /// The last time; at a goal where agents stay, the latest arrival.
    pub last: u32,
}

/// A place where an agent has to be at a time to keep its limit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct MustPass {
    /// The agent.
    pub agent: String,
    /// Where.
    pub cell: Cell,
    /// When.
    pub time: u32,
    /// Whether it has arrived by then, and stands there from then on.
    pub rests: bool,
}

/// A place where two agents collide, whichever ways they take.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct MustMeet {
    /// The two agents.
    pub agents: [String; 2],
    /// When: at a swap, when the move begins.
    pub time: u32,
    /// How.
    #[serde(flatten)]
    pub kind: MeetingKind,
}

/// How two agents collide.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum MeetingKind {
    /// Both have to be at a cell.
    Vertex {
        /// The cell.
        cell: Cell,
    },
    /// Both have to pass an edge, the first as it is written, the second the other
    /// way.
    Swap {
        /// Its ends.
        edge: [Cell; 2],
    },
    /// The first one rests at its goal, and the second has to pass there.
    Target {
        /// The goal.
        cell: Cell,
    },
}

/// The answer for some agents alone, all others away.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
pub struct Alone {
    /// The scene with these agents only, and the cost as its objective: it can be
    /// saved, solved and certified as any scene.
    pub scene: Scene,
    /// The search for their best plan, with its trace.
    pub solved: SolveAnswer,
    /// Whether they cannot keep their limits even by themselves; `null` where that was
    /// not settled. Where it is false, others have a part in it.
    pub refuted: Option<bool>,
}
