//! The constraint of a node on one agent, and its consequences for the others.
//!
//! A constraint is either negative (an agent is *not* there then) or positive (it
//! *is* there, which keeps all others away). Splitting a conflict into the
//! negative and the positive constraint of one agent makes two children that
//! share no plan: disjoint splitting (Li et al. 2019). A goal where an agent
//! rests is split by its arrival: after a time, or by it, which keeps all others
//! away from then on (target reasoning; Li et al. 2021).

use crate::{
    AgentId,
    problem::Problem,
    single::Place,
    terrain::Vertex,
    walk::{arrival, crossed},
};

/// A rule for one agent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[expect(
    missing_docs,
    reason = "the sentence of a variant says what its fields are"
)]
pub enum Rule {
    /// It is not at a vertex at a time.
    NotAt { v: Vertex, time: u32 },
    /// It is at a vertex at a time, and no other is.
    At { v: Vertex, time: u32 },
    /// It does not cross an arc in the step that begins at a time.
    NotCross { arc: u32, time: u32 },
    /// It crosses an arc in that step, and no other comes the other way.
    Cross { arc: u32, time: u32 },
    /// It arrives after a time.
    ArriveAfter(u32),
    /// It arrives by a time, and no other is at its goal from then on.
    ArriveBy(u32),
}

/// A constraint of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Constraint {
    /// Of whom it is asked.
    pub agent: AgentId,
    /// The rule.
    pub rule: Rule,
}

impl Constraint {
    /// The consequence for an agent, if any: for the others, the reverse of a positive constraint.
    pub(super) fn for_agent(self, problem: &Problem, agent: AgentId) -> Option<Own> {
        if self.agent == agent {
            return Some(Own::Rule(self.rule));
        }
        if !problem.collide(self.agent, agent) {
            return None;
        }
        match self.rule {
            Rule::At { v, time } => Some(Own::Rule(Rule::NotAt { v, time })),
            Rule::Cross { arc, time } => Some(Own::Rule(Rule::NotCross { arc: arc ^ 1, time })),
            Rule::ArriveBy(from) => Some(Own::Closed {
                v: problem.tasks[self.agent].goal?,
                from,
            }),
            _ => None,
        }
    }
}

/// The consequence of a constraint for one agent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Own {
    /// A rule of its own.
    Rule(Rule),
    /// A vertex where another rests from a time on.
    Closed { v: Vertex, from: u32 },
}

impl Own {
    /// Whether a walk of an agent keeps it.
    pub(super) fn is_kept(self, problem: &Problem, agent: AgentId, walk: &[Place]) -> bool {
        let end = arrival(walk);
        let rests = problem.rests(agent);
        let is_at = |v: Vertex, time: u32| match walk.get(time as usize) {
            Some(place) => *place == Place::At(v),
            None => rests && walk.last() == Some(&Place::At(v)),
        };
        let crosses = |arc: u32, time: u32| {
            let now = crossed(&problem.terrain, walk, time as usize);
            now.is_some_and(|now| now.id == arc)
        };
        match self {
            Self::Rule(Rule::NotAt { v, time }) => !is_at(v, time),
            Self::Rule(Rule::At { v, time }) => is_at(v, time),
            Self::Rule(Rule::NotCross { arc, time }) => !crosses(arc, time),
            Self::Rule(Rule::Cross { arc, time }) => crosses(arc, time),
            Self::Rule(Rule::ArriveAfter(time)) => end > time,
            Self::Rule(Rule::ArriveBy(time)) => end <= time,
            Self::Closed { v, from } => (from..=end.max(from)).all(|time| !is_at(v, time)),
        }
    }
}
