//! Which conflict to split first: a cardinal one, both of whose children cost more.
//!
//! ICBS (Boyarski et al. 2015). The MDD of an agent tells whether all its
//! shortest walks run into the conflict, so that avoiding it costs time.

use super::conflict::{Conflict, ConflictKind};
use super::node::Way;
use crate::{AgentId, problem::Problem};

/// How many of the two agents cannot avoid a conflict without arriving later.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cardinality {
    /// Both.
    Cardinal,
    /// One of them.
    SemiCardinal,
    /// Neither.
    NonCardinal,
}

/// The conflict to split: of the most cardinal the first in time.
pub(super) fn choose<'c>(
    problem: &Problem,
    conflicts: &'c [Conflict],
    ways: &[Way],
) -> Option<(&'c Conflict, Cardinality)> {
    let rated = conflicts.iter().map(|conflict| {
        let cardinality = cardinality(problem, conflict, ways);
        (conflict, cardinality)
    });
    rated.min_by_key(|(conflict, cardinality)| {
        (
            *cardinality,
            conflict.kind.time(),
            conflict.first.min(conflict.second),
        )
    })
}

/// How many of its agents have no walk as short without the conflict.
pub(super) fn cardinality(problem: &Problem, conflict: &Conflict, ways: &[Way]) -> Cardinality {
    let is_stuck = |agent: AgentId| {
        let Some(way) = ways.get(agent) else {
            return false;
        };
        let mdd = &way.mdd;
        let is_first = agent == conflict.first;
        match conflict.kind {
            ConflictKind::Swap { arc, time } => {
                let arc = if is_first { arc } else { arc ^ 1 };
                mdd.always_crosses(arc, time)
            }
            // The agent that rests there would have to arrive later.
            ConflictKind::Target { .. } if is_first => true,
            ConflictKind::Vertex { v, time } | ConflictKind::Target { v, time } => {
                mdd.is_always_at(problem, v, time)
            }
        }
    };
    match (is_stuck(conflict.first), is_stuck(conflict.second)) {
        (true, true) => Cardinality::Cardinal,
        (false, false) => Cardinality::NonCardinal,
        _ => Cardinality::SemiCardinal,
    }
}
