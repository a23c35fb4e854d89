//! The soft constraints of a stage, each an assumption.

use crate::encode::collisions::AgentId;

/// What an assumption bounds.
#[derive(Clone, Copy, Debug)]
pub(super) enum Soft {
    /// The cost of an agent is at most this.
    Agent(AgentId, u32),
    /// At most `k` inputs of a totalizer are true.
    Total { totalizer: usize, k: usize },
}

impl Soft {
    /// The same at a higher level.
    pub(super) const fn raised(self, by: u32) -> Self {
        match self {
            Self::Agent(agent, most) => Self::Agent(agent, most + by),
            Self::Total { totalizer, k } => Self::Total {
                totalizer,
                k: k + by as usize,
            },
        }
    }

    /// The agent that it bounds, if it is one alone.
    pub(super) const fn agent(&self) -> Option<AgentId> {
        match self {
            Self::Agent(agent, _) => Some(*agent),
            Self::Total { .. } => None,
        }
    }
}
