//! Which of two agents comes first.

use giveway_model::constraint::{ConstraintKind, InForce};

use super::OwnRules;
use crate::{
    AgentId,
    single::Place,
    terrain::{Terrain, Vertex},
    walk::Walk,
};

/// One agent is at a vertex before another has been at one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Precedence {
    /// The agent that has to be there first. Its task notes whether it has been.
    pub first: (AgentId, Vertex),
    /// The agent that may be there later.
    pub second: (AgentId, Vertex),
    /// Whether the first has to be there, even if the second is not: its vertex is one of
    /// its waypoints.
    pub is_required: bool,
}

impl Precedence {
    /// Whether walks keep to it.
    pub fn is_kept(self, walks: &[Walk]) -> bool {
        let visit = |(agent, v): (AgentId, Vertex)| {
            let walk = walks.get(agent)?;
            walk.iter().position(|&place| place == Place::At(v))
        };
        match (visit(self.first), visit(self.second)) {
            (Some(first), Some(second)) => first < second,
            (None, None) => !self.is_required,
            (first, _) => first.is_some(),
        }
    }
}

impl OwnRules<'_> {
    pub(super) fn precedence(&self, rule: &InForce<'_>, terrain: &Terrain) -> Option<Precedence> {
        let ConstraintKind::Before { first, second } = &rule.constraint.kind else {
            return None;
        };
        let (one, other) = (self.number(&first.agent)?, self.number(&second.agent)?);
        let at = terrain.vertex(first.cell)?;
        let there = terrain.vertex(second.cell)?;
        (one != other).then_some(Precedence {
            first: (one, at),
            second: (other, there),
            is_required: false,
        })
    }
}
