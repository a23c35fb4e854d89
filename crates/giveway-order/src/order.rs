//! The order as plain data: visits, links, rotations.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Cell;
use giveway_model::constraint::Heading;
use serde::{Deserialize, Serialize};

/// The order of a plan.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Order {
    /// The agents that have a path, in the order in which they came.
    pub agents: Vec<AgentOrder>,
    /// The links, by cell (row by row), then by time.
    pub links: Vec<Link>,
    /// The rotations, by time.
    pub rotations: Vec<Rotation>,
    /// The moves that begin later than in the plan, since the order alone has to be safe;
    /// by time.
    pub later: Vec<Shift>,
}

/// The way of an agent.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct AgentOrder {
    /// Its name.
    pub agent: String,
    /// Where it faces at first, where the scene says so.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heading: Option<Heading>,
    /// The cells that it stands at or passes, in order. Times are those of the order without
    /// lateness: the plan's own, but for the moves in [`Order::later`] and what they push, so
    /// that an agent may be removed before it comes to the last of them.
    pub visits: Vec<Visit>,
    /// Its end.
    pub end: End,
}

/// The end of an agent's way.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum End {
    /// It stays at its last cell.
    Stays,
    /// It vanishes at its last cell.
    Vanishes,
    /// It is removed while the plan runs.
    Removed,
}

/// A stay of an agent at a cell.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Visit {
    /// The cell.
    pub cell: Cell,
    /// When it begins its move into the cell, in steps; `None` where its way begins.
    pub comes: Option<u32>,
    /// The first time at which it is there.
    pub arrives: u32,
    /// When it begins to leave: the last time at which it is there. One that vanishes leaves
    /// at its arrival. `None` where it stays for good.
    pub leaves: Option<u32>,
    /// The least steps that it stands there before it leaves: it turns in them, under a rule
    /// `turns`.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub stands: u32,
    /// Whether it charges there.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub charges: bool,
}

/// A visit of an agent, as an end of a link.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct LinkEnd {
    /// The agent's name.
    pub agent: String,
    /// The number of its visit, from 0.
    pub visit: u32,
    /// The time: of the first agent when it begins to leave, of the second when it begins
    /// to come.
    pub time: u32,
}

/// Two agents that are in a cell one after the other: `second` begins its move into the
/// cell no earlier than `gap` steps after `first` begins to leave it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Link {
    /// The cell.
    pub cell: Cell,
    /// Who leaves.
    pub first: LinkEnd,
    /// Who comes.
    pub second: LinkEnd,
    /// The steps that have to lie between: 0 without a rule `gap`.
    pub gap: u32,
    /// How many steps later the first may leave before the second has to wait.
    pub slack: u32,
}

/// Agents that each move into the cell that the next one leaves, in a circle: all of these
/// moves begin in one step.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Rotation {
    /// When the moves begin.
    pub time: u32,
    /// The moves; each agent enters the cell that the one after it leaves, the last
    /// that of the first.
    pub moves: Vec<RotationMove>,
}

/// A move of a rotation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct RotationMove {
    /// The agent's name.
    pub agent: String,
    /// The number of the visit that it comes to, from 0.
    pub visit: u32,
    /// The cell that it enters.
    pub cell: Cell,
}

/// A move that begins later than in the plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Shift {
    /// The agent's name.
    pub agent: String,
    /// The cell that it enters; the last one where it leaves the floor there.
    pub cell: Cell,
    /// When the move begins in the plan.
    pub planned: u32,
    /// When it begins in the order.
    pub begins: u32,
}

/// A plan that no order alone keeps safe: these moves would wait for each other in a circle.
/// It has slow moves that begin a step before their ends are left.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct NoOrder {
    /// The moves; each waits for the one after it, the last for the first.
    pub moves: Vec<RotationMove>,
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde hands in a reference"
)]
const fn is_zero(steps: &u32) -> bool {
    *steps == 0
}

impl Order {
    /// How many links have no slack: there the robots follow each other in one step.
    pub fn without_slack(&self) -> usize {
        let links = self.links.iter();
        links
            .filter(|link| link.slack == 0 && link.gap == 0)
            .count()
    }

    /// The links of a cell, in order.
    pub fn at(&self, cell: Cell) -> impl Iterator<Item = &Link> {
        self.links.iter().filter(move |link| link.cell == cell)
    }

    /// The agent of a name.
    pub fn agent(&self, name: &str) -> Option<&AgentOrder> {
        self.agents.iter().find(|it| it.agent == name)
    }

    /// Whether an agent makes a slow move somewhere.
    pub fn has_slow_moves(&self) -> bool {
        let visits = self.agents.iter().flat_map(|it| &it.visits);
        visits.into_iter().any(Visit::is_slow)
    }
}

impl Visit {
    /// Whether the agent comes by a slow move.
    pub fn is_slow(&self) -> bool {
        self.comes.is_some_and(|comes| self.arrives > comes + 1)
    }
}
