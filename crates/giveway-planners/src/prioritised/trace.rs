//! The steps of one order: which agents were planned around which, and which got stuck.

use crate::{AgentId, walk::Walk};

/// An agent that got a walk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Planned {
    /// The agent.
    pub agent: AgentId,
    /// When it arrives.
    pub arrival: u32,
    /// When it would arrive alone.
    pub alone: u32,
    /// Where it arrives later than alone: whom it would have met on the best way
    /// of its own that meets the fewest.
    pub around: Vec<AgentId>,
    /// Its walk; empty where too many were told before.
    pub walk: Walk,
}

/// An agent that has no walk around those before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stuck {
    /// The agent.
    pub agent: AgentId,
    /// Agents on its least-conflict optimal path.
    pub around: Vec<AgentId>,
}

/// One order, from its first agent on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrderAttempt {
    /// The order.
    pub order: Vec<AgentId>,
    /// The agents with a walk, in that order.
    pub planned: Vec<Planned>,
    /// The agent that got stuck, if one did.
    pub stuck: Option<Stuck>,
    /// How far whoever is stuck comes: the longest walk of its own around those
    /// before it. Empty where nobody is, or too many walks were told before.
    pub furthest: Walk,
    /// Whether that walk ends where no vertex is left free for the next step.
    pub dead_end: bool,
}
