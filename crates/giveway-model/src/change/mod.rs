//! Changes of the world while a plan runs.
//!
//! A plan is running; at a time one or more things change at once, and what was
//! before stays as it was. [`Changes`] is what a person writes; [`History`] is
//! the world over time that they make of an instance and its plan.

mod apply;
mod history;
mod refuse;
mod timeline;
mod trajectory;
mod words;
mod written;

use serde::{Deserialize, Serialize};

use crate::object_only;
use crate::{Agent, Cell, Constraint, Fault, Version, sorting};

pub use history::{Epoch, History};
pub use timeline::{Stopped, TimedWaypoint, Timeline};
pub use trajectory::{Trajectory, Whereabouts};

/// The latest time at which something may change, in steps.
pub const MAX_TIME: u32 = 1_000_000;

/// The longest breakdown, in steps.
pub const MAX_DELAY: u32 = 10_000;

/// The most changes of one plan.
pub const MAX_CHANGES: usize = 10_000;

/// The changes while a plan runs, in any order of time.
///
/// ```
/// use giveway_model::{change::What, format::native};
/// let changes = native::read_changes(
///     r#"{ "giveway": 1, "changes": [{ "at": 2, "change": "add-obstacle", "cell": [1, 0] }] }"#,
/// ).unwrap();
/// assert!(matches!(changes.changes[0].what, What::AddObstacle { .. }));
/// ```
#[derive(
    Clone,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Changes {
    /// The version of the format.
    pub giveway: Version,
    /// The changes. Those of one time happen together.
    pub changes: Vec<Change>,
}

object_only!(Changes);

impl Changes {
    /// The faults of the list as a whole, whatever the plan.
    ///
    /// # Errors
    /// Where there are too many changes.
    pub fn few(&self) -> Result<(), Vec<Fault>> {
        let count = self.changes.len();
        if count <= MAX_CHANGES {
            return Ok(());
        }
        let (found, expected) = refuse::too_many_changes(count);
        Err(vec![Fault::at("changes", found, expected)])
    }

    /// The times at which something changes, ascending, each with the changes
    /// of that time and their places in the list.
    pub fn by_time(&self) -> Vec<(u32, Vec<(usize, &Change)>)> {
        let mut times: Vec<(u32, Vec<(usize, &Change)>)> = Vec::new();
        let mut sorted: Vec<(usize, &Change)> = self.changes.iter().enumerate().collect();
        sorting::sort_by_key(&mut sorted, |(_, change)| change.at);
        for (index, change) in sorted {
            match times.last_mut() {
                Some((at, list)) if *at == change.at => list.push((index, change)),
                _ => times.push((change.at, vec![(index, change)])),
            }
        }
        times
    }
}

/// One change at one time.
#[derive(
    Clone,
    Debug,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(try_from = "written::Written", into = "written::Written")]
pub struct Change {
    /// When, in steps from 0.
    pub at: u32,
    /// The kind of change, with its place and agent.
    pub what: What,
}

/// The kind of a change.
#[derive(Clone, Debug, PartialEq, Eq, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub enum What {
    /// An agent appears at its start; `initial` is its level then.
    AddAgent {
        /// The agent, as in an instance.
        agent: Agent,
    },
    /// An agent is gone from that time on.
    RemoveAgent {
        /// Its name.
        agent: String,
    },
    /// A cell becomes an obstacle, whatever it was.
    AddObstacle {
        /// The cell.
        cell: Cell,
    },
    /// An obstacle becomes a free cell.
    RemoveObstacle {
        /// The cell.
        cell: Cell,
    },
    /// An obstacle is moved.
    MoveObstacle {
        /// Where it was; a free cell from then on.
        from: Cell,
        /// Where it is from then on.
        to: Cell,
    },
    /// Cells join the slow zone.
    SetSlow {
        /// The cells.
        cells: Vec<Cell>,
    },
    /// Cells leave the slow zone.
    SetNormal {
        /// The cells.
        cells: Vec<Cell>,
    },
    /// A cell becomes a charger.
    AddCharger {
        /// The cell.
        cell: Cell,
    },
    /// A charger is taken away.
    RemoveCharger {
        /// The cell.
        cell: Cell,
    },
    /// An agent has another goal.
    SetGoal {
        /// Its name.
        agent: String,
        /// The new goal.
        cell: Cell,
    },
    /// An agent has a further waypoint, to be visited from that time on.
    AddWaypoint {
        /// Its name.
        agent: String,
        /// The waypoint.
        cell: Cell,
    },
    /// An agent need not visit a waypoint any more.
    DropWaypoint {
        /// Its name.
        agent: String,
        /// The waypoint.
        cell: Cell,
    },
    /// A battery has another level.
    SetBattery {
        /// The agent's name.
        agent: String,
        /// The level at that time.
        level: u32,
    },
    /// An agent breaks down: it waits, from the end of a slow move under way.
    DelayAgent {
        /// Its name.
        agent: String,
        /// How long, in steps.
        steps: u32,
    },
    /// An agent breaks down for good: it stands where it is, from the end of a slow move under
    /// way, as an obstacle with its name, and leaves all costs.
    StopAgent {
        /// Its name.
        agent: String,
    },
    /// A rule of the scene's own begins to hold. Its zone is one of the scene: a change
    /// brings no zone of its own.
    AddConstraint {
        /// The rule, as in an instance.
        constraint: Constraint,
    },
    /// A rule of the scene's own is gone.
    RemoveConstraint {
        /// Which one.
        constraint: ConstraintRef,
    },
}

/// A rule of a scene's own that is there already.
#[derive(Clone, Debug, PartialEq, Eq, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub enum ConstraintRef {
    /// By its name.
    Name(String),
    /// By its number: those of the scene count from 0, and those that changes added go on
    /// from there, in the order of their times and in the order of the list.
    Index(u32),
}
