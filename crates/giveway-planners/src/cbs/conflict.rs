//! Where two walks break a rule together.

use super::constraint::{Constraint, Rule};
use crate::{
    AgentId,
    problem::Problem,
    single::Place,
    terrain::Vertex,
    walk::{arrival, crossed},
};

/// How two agents get into each other's way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[expect(
    missing_docs,
    reason = "the sentence of a variant says what its fields are"
)]
pub enum ConflictKind {
    /// Both are at a vertex at a time.
    Vertex { v: Vertex, time: u32 },
    /// The first crosses an arc while the second crosses it the other way, both
    /// in the step that begins at a time. A slow arc is crossed in two steps.
    Swap { arc: u32, time: u32 },
    /// The first has arrived and rests at a vertex, and the second comes by.
    Target { v: Vertex, time: u32 },
}

impl ConflictKind {
    /// When it happens.
    pub const fn time(self) -> u32 {
        match self {
            Self::Vertex { time, .. } | Self::Swap { time, .. } | Self::Target { time, .. } => time,
        }
    }
}

/// A conflict of two agents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// The first of them; of a target conflict the one that rests.
    pub first: AgentId,
    /// The second of them.
    pub second: AgentId,
    /// How they meet.
    pub kind: ConflictKind,
}

/// One of the two agents of a conflict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Party {
    /// [`Conflict::first`].
    First,
    /// [`Conflict::second`].
    Second,
}

impl Conflict {
    /// The two constraints that split it, as the planner does: of its first agent.
    pub(super) fn split(&self) -> [Constraint; 2] {
        self.split_naming(Party::First)
    }

    /// The two constraints of one of its agents that split it: no plan keeps both, and
    /// each plan without this conflict keeps one.
    pub(super) fn split_naming(&self, party: Party) -> [Constraint; 2] {
        let (negative, positive) = match (self.kind, party) {
            // Who rests at its goal comes later, or has come by then.
            (ConflictKind::Target { time, .. }, Party::First) => {
                (Rule::ArriveAfter(time), Rule::ArriveBy(time))
            }
            (ConflictKind::Vertex { v, time }, Party::First | Party::Second)
            | (ConflictKind::Target { v, time }, Party::Second) => {
                (Rule::NotAt { v, time }, Rule::At { v, time })
            }
            (ConflictKind::Swap { arc, time }, Party::First) => {
                (Rule::NotCross { arc, time }, Rule::Cross { arc, time })
            }
            (ConflictKind::Swap { arc, time }, Party::Second) => {
                let arc = arc ^ 1;
                (Rule::NotCross { arc, time }, Rule::Cross { arc, time })
            }
        };
        [negative, positive].map(|rule| Constraint {
            agent: self.agent(party),
            rule,
        })
    }

    /// One of its agents.
    pub const fn agent(&self, party: Party) -> AgentId {
        match party {
            Party::First => self.first,
            Party::Second => self.second,
        }
    }
}

/// All conflicts of the walks of two agents, by time.
pub(super) fn between(
    problem: &Problem,
    (a, walk): (AgentId, &[Place]),
    (b, other): (AgentId, &[Place]),
) -> Vec<Conflict> {
    let mut found = Vec::new();
    if !problem.collide(a, b) {
        return found;
    }
    for time in 0..walk.len().max(other.len()) {
        let now = time as u32;
        let mut add = |first, second, kind| {
            found.push(Conflict {
                first,
                second,
                kind,
            });
        };
        match (walk.get(time), other.get(time)) {
            (Some(&Place::At(v)), Some(&Place::At(u))) if u == v => {
                add(a, b, ConflictKind::Vertex { v, time: now });
            }
            (None, Some(&Place::At(v))) if is_at_rest(problem, a, walk, v) => {
                add(a, b, ConflictKind::Target { v, time: now });
            }
            (Some(&Place::At(v)), None) if is_at_rest(problem, b, other, v) => {
                add(b, a, ConflictKind::Target { v, time: now });
            }
            _ => {}
        }
        let arcs =
            crossed(&problem.terrain, walk, time).zip(crossed(&problem.terrain, other, time));
        if let Some((arc, _)) = arcs.filter(|(arc, back)| arc.id == back.id ^ 1) {
            add(
                a,
                b,
                ConflictKind::Swap {
                    arc: arc.id,
                    time: now,
                },
            );
        }
    }
    found
}

/// Whether an agent that arrived earlier rests at a vertex.
fn is_at_rest(problem: &Problem, agent: AgentId, walk: &[Place], v: Vertex) -> bool {
    let end = walk.get(arrival(walk) as usize);
    problem.rests(agent) && end == Some(&Place::At(v))
}
