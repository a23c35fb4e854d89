//! Which of two agents comes first.

use crate::{encode::collisions::AgentId, single::Place, terrain::Vertex, walk::Walk};

/// One agent is at a vertex before another has been at one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Precedence {
    /// The agent that has to be there first; the vertex is one of its waypoints.
    pub(crate) first: (AgentId, Vertex),
    /// The agent that may be there later.
    pub(crate) second: (AgentId, Vertex),
}

impl Precedence {
    /// Whether walks, in which the first does visit its vertex, keep to it.
    pub(crate) fn is_kept(self, walks: &[Walk]) -> bool {
        let visit = |(agent, v): (AgentId, Vertex)| {
            let walk = walks.get(agent)?;
            walk.iter().position(|&place| place == Place::At(v))
        };
        match (visit(self.first), visit(self.second)) {
            (Some(first), Some(second)) => first < second,
            (first, _) => first.is_some(),
        }
    }
}
