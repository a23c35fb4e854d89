//! What the contrast of a question demands of one agent beside its task.
//!
//! Whatever forbids or asks for places, crossings and waits is part of the
//! agent's own task: its tables, its MDD and its searches keep to it by
//! construction, and bounds of the agent alone are bounds with the demand. What
//! counts over a whole walk (fewer moves, no long wait) is a clause inside the
//! SAT solver and a check on plans found without it.

use giveway_model::Cost;

use super::{Place, task::Mask};
use crate::terrain::Vertex;

/// A demand on one agent. Where a time is `None` it is about all times.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(
    missing_docs,
    reason = "the sentence of a variant says what its fields are"
)]
pub enum TaskConstraint {
    /// It is not at a vertex.
    Avoid { v: Vertex, time: Option<u32> },
    /// It visits a vertex only after a waypoint, which is the set of one.
    After { v: Vertex, waypoint: Mask },
    /// It crosses none of these arcs.
    NotCross { arcs: Vec<u32>, time: Option<u32> },
    /// It crosses one of these arcs; that is the last bit of its mask.
    Cross { arcs: Vec<u32>, time: Option<u32> },
    /// It never makes so many wait steps on end at the vertex (anywhere, where
    /// there is none) within the times.
    Wait {
        v: Option<Vertex>,
        from: u32,
        to: u32,
        steps: u32,
    },
    /// It does not charge at the vertex (anywhere, where there is none).
    NotCharge {
        v: Option<Vertex>,
        time: Option<u32>,
    },
    /// It charges at a vertex, and so leaves it; that is the last bit of its
    /// mask.
    Charge { v: Vertex, leaving: Vec<u32> },
    /// It arrives no later.
    ArriveBy(u32),
    /// It has at most so many charges, moves or waits.
    AtMost { cost: Cost, most: u32 },
}

/// Whether something demanded of a time is about this one; tables know no
/// times, and forbid only what is forbidden at all of them.
fn is_now(demanded: Option<u32>, time: Option<u32>) -> bool {
    demanded.is_none() || demanded == time
}

impl TaskConstraint {
    /// Whether it may be at a vertex, the waypoints of the mask visited.
    pub fn may_stand(&self, at: Vertex, mask: Mask, now: Option<u32>) -> bool {
        match *self {
            Self::Avoid { v, time } => at != v || !is_now(time, now),
            Self::After { v, waypoint } => at != v || mask & waypoint != 0,
            _ => true,
        }
    }

    /// Whether it may begin to cross an arc.
    pub fn may_cross(&self, arc: u32, now: Option<u32>) -> bool {
        match self {
            Self::NotCross { arcs, time } => !arcs.contains(&arc) || !is_now(*time, now),
            _ => true,
        }
    }

    /// Whether it may wait a step at a vertex; long waits are counted elsewhere.
    pub fn may_wait(&self, at: Vertex, now: u32) -> bool {
        match *self {
            Self::Wait { steps: 1, .. } => !self.counts_wait(at, now),
            _ => true,
        }
    }

    /// Whether a wait step is one of those that are asked about.
    pub fn counts_wait(&self, at: Vertex, now: u32) -> bool {
        match *self {
            Self::Wait { v, from, to, .. } => v.is_none_or(|v| v == at) && from <= now && now < to,
            _ => false,
        }
    }

    /// Whether it may charge at a charger.
    pub fn may_charge(&self, at: Vertex, now: Option<u32>) -> bool {
        match *self {
            Self::NotCharge { v, time } => v.is_some_and(|v| v != at) || !is_now(time, now),
            _ => true,
        }
    }

    /// Whether its mask has a bit for what is no waypoint.
    pub const fn has_bit(&self) -> bool {
        matches!(self, Self::Cross { .. } | Self::Charge { .. })
    }

    /// Whether beginning to cross an arc sets that bit. Tables, which know no
    /// times, take the best case.
    pub fn is_set_by(&self, arc: u32, now: Option<u32>) -> bool {
        match self {
            Self::Cross { arcs, time } => {
                arcs.contains(&arc) && (now.is_none() || is_now(*time, now))
            }
            Self::Charge { leaving, .. } => leaving.contains(&arc),
            _ => false,
        }
    }

    /// The time from which on that bit must be set, if there is one.
    pub const fn set_from(&self) -> Option<u32> {
        match *self {
            Self::Cross {
                time: Some(time), ..
            } => Some(time.saturating_add(1)),
            _ => None,
        }
    }

    /// The last time that it is about, where it is about some.
    pub fn last_time(&self) -> Option<u32> {
        match *self {
            Self::Avoid { time, .. }
            | Self::NotCross { time, .. }
            | Self::Cross { time, .. }
            | Self::NotCharge { time, .. } => time,
            Self::Wait { from, to, .. } if (from, to) != (0, u32::MAX) => {
                Some(if to == u32::MAX { from } else { to })
            }
            Self::ArriveBy(time) => Some(time),
            _ => None,
        }
    }

    /// Whether the agent has to be inside the SAT solver: plans made outside
    /// keep the demand by chance only.
    pub const fn counts(&self) -> bool {
        matches!(self, Self::Wait { steps: 2.., .. } | Self::AtMost { .. })
    }

    /// Whether a walk has no wait of so many steps or more.
    pub fn keeps_waits(&self, walk: &[Place]) -> bool {
        let Self::Wait { steps, .. } = *self else {
            return true;
        };
        let mut run = 0;
        for (time, pair) in walk.windows(2).enumerate() {
            let counts = match (pair[0], pair[1]) {
                (Place::At(u), Place::At(v)) => u == v && self.counts_wait(u, time as u32),
                _ => false,
            };
            run = if counts { run + 1 } else { 0 };
            if run >= steps {
                return false;
            }
        }
        true
    }
}
