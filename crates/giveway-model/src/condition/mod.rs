//! Conditions on a plan: what it must have, or must not have, beside the rules.
//!
//! A condition is data: *whom* it is about, *where*, *when* and *how much*. The
//! contrast of a question is one ([`Question::condition`](crate::Question::condition)),
//! and so is what a certificate says of the plans that do not exist. Four
//! interpreters give it its meaning, each a match over all kinds:
//!
//! | interpreter | where | what it makes of a condition |
//! |---|---|---|
//! | judge | [`Condition::holds`] | whether a plan meets it |
//! | search | `impose` in giveway-solve | a part of the agents' tasks |
//! | certificate | `plain/condition` and `exhaust/watch` in giveway-proof | clauses, and what a search of joint states remembers |
//! | words | [`Condition::clause`] | a sentence |

mod clause;
mod holds;
mod written;

use borsh::{BorshDeserialize, BorshSerialize};

use crate::{Cell, Constraint, Cost};

pub use clause::Clause;
pub(crate) use holds::{first_visit, goes, is_at, moves, turns};

/// A condition on a plan.
///
/// In JSON it has the form in which certificates have it: the question whose
/// contrast it is, or a number that something is below.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Condition {
    /// The agent does this at none of these times.
    Never {
        /// The agent.
        agent: String,
        /// The act that it must not do.
        act: Act,
        /// When.
        times: Times,
    },
    /// The agent is at the cell at some time, be it at rest.
    Visit {
        /// The agent; any one of them where it is `None`.
        agent: Option<String>,
        /// The cell.
        cell: Cell,
    },
    /// The agent begins to go from one cell to the next at one of these times.
    Move {
        /// The agent.
        agent: String,
        /// The cell that it leaves.
        from: Cell,
        /// The cell that it goes to.
        to: Cell,
        /// When.
        times: Times,
    },
    /// The agent charges at the charger.
    Charge {
        /// The agent.
        agent: String,
        /// The charger.
        cell: Cell,
    },
    /// The first visit is made at some time, and the second at none up to then.
    Before {
        /// The visit that is made first.
        first: Visit,
        /// The visit that is made later, or not at all.
        second: Visit,
    },
    /// A cost is below a number.
    Below {
        /// The agent whose cost it is; that of the whole plan where it is `None`.
        agent: Option<String>,
        /// The cost. The makespan of an agent is its arrival.
        cost: Cost,
        /// The number.
        limit: u32,
    },
    /// The plan keeps a rule beside those of its scene. The rule forbids something.
    Keeps(Box<Constraint>),
}

/// An act of an agent on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Act {
    /// It is at a cell; resting at its goal counts.
    Visit(Cell),
    /// It begins to go from one cell to the next.
    Move(Cell, Cell),
    /// It begins a slow move: over this edge, either way, or over any.
    SlowMove(Option<(Cell, Cell)>),
    /// It makes so many wait steps on end before its arrival, or more. A wait step
    /// is within times where its begin and its end are.
    Wait {
        /// Where; anywhere where it is `None`.
        cell: Option<Cell>,
        /// The number of steps; 0 is 1.
        steps: u32,
    },
    /// It charges: at this charger, or at any.
    Charge(Option<Cell>),
}

/// Times from one to another, both included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Times {
    /// The first; 0 where it is `None`.
    pub from: Option<u32>,
    /// The last; without end where it is `None`.
    pub to: Option<u32>,
}

/// An agent at a cell.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Visit {
    /// The agent.
    pub agent: String,
    /// The cell.
    pub cell: Cell,
}

impl Times {
    /// One time, or all of them.
    pub const fn at(time: Option<u32>) -> Self {
        Self {
            from: time,
            to: time,
        }
    }

    /// The first time.
    pub fn first(self) -> u32 {
        self.from.unwrap_or(0)
    }

    /// The last time.
    pub fn last(self) -> u32 {
        self.to.unwrap_or(u32::MAX)
    }

    /// Whether a time is one of them.
    pub fn contains(self, time: u32) -> bool {
        self.first() <= time && time <= self.last()
    }

    /// Whether all times are.
    pub fn are_all(self) -> bool {
        (self.first(), self.last()) == (0, u32::MAX)
    }

    /// The time, where it is a single one.
    pub fn single(self) -> Option<u32> {
        self.from.filter(|_| self.from == self.to)
    }
}

impl Condition {
    /// The agent that it is about, where it is about one; of two the one that is first.
    pub fn agent(&self) -> Option<&str> {
        match self {
            Self::Never { agent, .. } | Self::Move { agent, .. } | Self::Charge { agent, .. } => {
                Some(agent)
            }
            Self::Visit { agent, .. } | Self::Below { agent, .. } => agent.as_deref(),
            Self::Before { first, .. } => Some(&first.agent),
            Self::Keeps(rule) => rule.single_agent(),
        }
    }

    /// All agents that it names.
    pub fn agents(&self) -> impl Iterator<Item = &str> {
        let (one, others) = match self {
            Self::Before { second, .. } => (self.agent(), vec![second.agent.as_str()]),
            Self::Keeps(rule) => (None, rule.named_agents().collect()),
            Self::Never { .. }
            | Self::Visit { .. }
            | Self::Move { .. }
            | Self::Charge { .. }
            | Self::Below { .. } => (self.agent(), Vec::new()),
        };
        one.into_iter().chain(others)
    }
}
