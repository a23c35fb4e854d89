//! The limit that ended a search, as programs read it.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::budget::Stop;

/// The limit that ended a search.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Ended {
    /// Its question was settled: no plan is better, or there is none.
    Proof,
    /// The limit of work.
    Work,
    /// The limit of conflicts of the SAT solver.
    Conflicts,
    /// The limit of seconds.
    Time,
    /// The limit of memory.
    Memory,
    /// The person.
    Cancelled,
    /// There was more to compare than the method takes on.
    Size,
    /// A fault of this program, which it noticed.
    Fault,
    /// The search came to its end, but the scene leaves out what may change that.
    Assumptions,
}

impl Ended {
    /// Whether the same request ends in the same way each time. Time, memory and a person
    /// end a search wherever it happens to be.
    pub const fn is_repeatable(self) -> bool {
        match self {
            Self::Proof
            | Self::Work
            | Self::Conflicts
            | Self::Size
            | Self::Fault
            | Self::Assumptions => true,
            Self::Time | Self::Memory | Self::Cancelled => false,
        }
    }

    /// The stop of a limit or a person; `None` of what needs more words.
    pub const fn limit(self) -> Option<Stop> {
        match self {
            Self::Work => Some(Stop::Work),
            Self::Conflicts => Some(Stop::Conflicts),
            Self::Time => Some(Stop::Time),
            Self::Memory => Some(Stop::Memory),
            Self::Cancelled => Some(Stop::Cancelled),
            Self::Fault => Some(Stop::Contradiction),
            Self::Proof | Self::Size | Self::Assumptions => None,
        }
    }

    /// Of a search that such a stop ended, or else a proof.
    pub(crate) fn by(stop: Option<Stop>) -> Self {
        stop.map_or(Self::Proof, Self::from)
    }
}

impl From<Stop> for Ended {
    fn from(stop: Stop) -> Self {
        match stop {
            Stop::Time => Self::Time,
            Stop::Conflicts => Self::Conflicts,
            Stop::Work => Self::Work,
            Stop::Memory => Self::Memory,
            Stop::Sets | Stop::LateTimes | Stop::ManyWaypoints => Self::Size,
            Stop::Cancelled => Self::Cancelled,
            Stop::Contradiction => Self::Fault,
        }
    }
}
