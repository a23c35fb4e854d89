//! Rules of a scene's own: conditions that every plan for it must keep.
//!
//! A constraint is data: *whom* it binds, *where*, *when* and *how much*. Who gives
//! it its meaning:
//!
//! | interpreter | where | what it makes of a constraint |
//! |---|---|---|
//! | judge | `check/constraints` | the violations of a plan |
//! | search | `rules` in giveway-planners | a part of the agents' tasks, or a rule between agents |
//! | certificate | `plain/constraints` and `exhaust/constraints` in giveway-proof | clauses, and the memory of a search |
//! | words | [`Constraint::sentence`] | a sentence |

mod edited;
mod faults;
mod heading;
mod in_force;
mod looser;
mod timed;
mod weaker;
mod words;
mod written;
mod zone;

use borsh::{BorshDeserialize, BorshSerialize};

use crate::Cell;
use crate::condition::{Times, Visit};

pub(crate) use faults::{World, check, find};
pub use heading::{Heading, quarter_turn};
pub use in_force::InForce;
pub(crate) use in_force::in_force;
pub use looser::{Loosens, LooserWay};
pub use timed::TimedConstraint;
pub use words::sentences;
pub use zone::Zone;

/// The largest number in a constraint; as the last of some times it is for ever.
pub const MAX_NUMBER: u32 = 1_000_000;
/// The most zones of a scene.
pub const MAX_ZONES: usize = 1_000;
/// The most cells of all zones of a scene together.
pub const MAX_ZONE_CELLS: usize = 4_194_304;
/// The most constraints of a scene.
pub const MAX_CONSTRAINTS: usize = 10_000;

/// A rule of a scene's own.
///
/// ```
/// use giveway_model::{Constraint, constraint::ConstraintKind};
/// let text = r#"{ "kind": "gap", "steps": 1 }"#;
/// let gap: Constraint = serde_json::from_str(text).unwrap();
/// assert_eq!(gap.kind, ConstraintKind::Gap { steps: 1 });
/// assert_eq!(gap.agents, None);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Constraint {
    /// What it demands.
    pub kind: ConstraintKind,
    /// The agents that it binds, by name; `None` for all, and for a sequence and a
    /// precedence, which name their own.
    pub agents: Option<Vec<String>>,
    /// Its name, unique in the scene.
    pub name: Option<String>,
    /// Whether it is kept and shown, but not in force.
    pub off: bool,
}

/// What a constraint demands. An agent is *in a zone* at a time if it is at a cell of it,
/// or in transit over an edge with an end in it; one that has arrived and stays is where it
/// rests.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum ConstraintKind {
    /// At each of these times at most `most` of the agents are in the zone.
    Capacity {
        /// The name of the zone.
        zone: String,
        /// The number of agents.
        most: u32,
        /// When.
        times: Times,
    },
    /// At none of these times is one of the agents in the zone.
    Closed {
        /// The name of the zone.
        zone: String,
        /// When.
        times: Times,
    },
    /// None of the agents moves from a cell of the lane to the one before it.
    OneWay {
        /// Cells, each a neighbour of the one before.
        lane: Vec<Cell>,
    },
    /// When an agent is at a cell, no other one is there in the next `steps` time steps
    /// (k-robust plans; Atzmon et al. 2020).
    Gap {
        /// The number of time steps, at least 1.
        steps: u32,
    },
    /// At each of these times any two of the agents have at least this Manhattan
    /// distance. In transit an agent counts at both ends of its edge.
    Apart {
        /// The distance in cells, at least 2.
        distance: u32,
        /// When.
        times: Times,
    },
    /// The agent is at these cells in this order.
    Sequence {
        /// The name of the agent.
        agent: String,
        /// The cells.
        cells: Vec<Cell>,
    },
    /// Each of the agents is at the cell for `stay` time steps on end, within these times.
    /// Resting there counts.
    Visit {
        /// The cell.
        cell: Cell,
        /// The number of time steps; 0 to pass.
        stay: u32,
        /// When.
        times: Times,
    },
    /// Each of the agents arrives at one of these times.
    Arrive {
        /// When.
        times: Times,
    },
    /// Each time step that one of the agents arrives after `by` costs `weight` (a penalty).
    Late {
        /// The time from which on it costs.
        by: u32,
        /// The cost of a time step, at least 1.
        weight: u32,
    },
    /// Each of the agents begins no move before this time.
    Depart {
        /// The time.
        from: u32,
    },
    /// The second agent is not at its cell unless the first was at its own at an earlier
    /// time.
    Before {
        /// The visit that is made first.
        first: Visit,
        /// The visit that is made later, or not at all.
        second: Visit,
    },
    /// None of the agents makes more than `most` wait steps on end at a cell of the zone
    /// before its arrival.
    NoWaiting {
        /// The name of the zone.
        zone: String,
        /// The number of wait steps.
        most: u32,
    },
    /// Between two moves an agent stands at least this long for each quarter turn between
    /// their directions.
    Turns {
        /// The number of time steps of a quarter turn, at least 1.
        quarter: u32,
    },
    /// Each time at which one of the agents is in the zone before its arrival costs
    /// `weight` (a penalty).
    Avoid {
        /// The name of the zone.
        zone: String,
        /// The cost of a time, at least 1.
        weight: u32,
    },
}

impl Constraint {
    /// The times that it names.
    pub(crate) const fn times(&self) -> Option<Times> {
        match &self.kind {
            ConstraintKind::Capacity { times, .. }
            | ConstraintKind::Closed { times, .. }
            | ConstraintKind::Apart { times, .. }
            | ConstraintKind::Visit { times, .. }
            | ConstraintKind::Arrive { times } => Some(*times),
            ConstraintKind::Depart { from } => Some(Times {
                from: Some(*from),
                to: None,
            }),
            ConstraintKind::Late { by, .. } => Some(Times {
                from: None,
                to: Some(*by),
            }),
            ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => None,
        }
    }

    /// The last time that it names; the largest number is none.
    pub fn last_time(&self) -> u32 {
        let times = self.times().into_iter();
        let named = times.flat_map(|times| times.from.into_iter().chain(times.to));
        named.filter(|&time| time < MAX_NUMBER).max().unwrap_or(0)
    }

    /// The agents that it names.
    pub fn named_agents(&self) -> impl Iterator<Item = &str> {
        let own = match &self.kind {
            ConstraintKind::Sequence { agent, .. } => vec![agent],
            ConstraintKind::Before { first, second } => vec![&first.agent, &second.agent],
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => Vec::new(),
        };
        own.into_iter()
            .chain(self.agents.iter().flatten())
            .map(String::as_str)
    }

    /// The agent that it is about, where it names one and no other.
    pub fn single_agent(&self) -> Option<&str> {
        let mut names = self.named_agents();
        names.next().filter(|&one| names.all(|name| name == one))
    }

    /// Whether it is about several agents at once.
    pub const fn is_between(&self) -> bool {
        match &self.kind {
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Before { .. } => true,
            ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => false,
        }
    }

    /// Whether it is a penalty, and forbids nothing.
    pub const fn is_penalty(&self) -> bool {
        matches!(
            self.kind,
            ConstraintKind::Late { .. } | ConstraintKind::Avoid { .. }
        )
    }

    /// The name of the kind in files.
    pub const fn kind_name(&self) -> &'static str {
        written::kind_name(&self.kind)
    }
}

/// Times as a constraint means them: the largest number as the last one is for ever.
pub fn meant(times: Times) -> Times {
    Times {
        to: times.to.filter(|&to| to < MAX_NUMBER),
        ..times
    }
}
