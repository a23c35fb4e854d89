//! Agents that exclude each other: vertices, edges, goals.
//!
//! Vertex: at most one agent at a vertex at a time. Swap: one direction
//! variable for each edge and step; whoever crosses in that step crosses in
//! that direction. A slow move crosses in both of its steps, so two of them in
//! opposite directions exclude each other just when they leave less than two
//! steps apart. Nothing is written for what only one agent uses.
//!
//! Where some pairs ignore each other, every other pair excludes each other by
//! a clause of its own instead; and where collisions are soft, such a clause has
//! a literal that says which collision happens.

use std::collections::{BTreeMap, BTreeSet};

use super::at_most_one::AtMostOne;
use crate::{
    sat::{Clauses, Lit},
    terrain::{Arc, Vertex},
};

pub(crate) use giveway_planners::AgentId;

/// Literals that together mean that an agent crosses an edge.
type Premise = [Lit; 2];

#[derive(Default)]
struct Crossings {
    /// The direction variable, once agents may meet here.
    direction: Option<Lit>,
    /// The crossers forward and backward, until two of them may meet.
    crossers: [Vec<(AgentId, Premise)>; 2],
}

/// A collision that may happen where collisions are soft: when, where (for an
/// edge: the end that the first agent leaves), who, the lower number first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Meeting {
    pub(crate) time: u32,
    pub(crate) place: Vertex,
    pub(crate) pair: (AgentId, AgentId),
}

/// Collisions that may happen, each with the literal that says that it happens.
#[derive(Default)]
struct SoftCollision {
    meetings: BTreeMap<Meeting, Lit>,
    /// Two slow moves may overlap in two steps, which count as one collision: the key is the
    /// first literal of each.
    slow: BTreeMap<(Lit, Lit), Lit>,
}

/// Clauses against collisions of the agents inside the solver.
#[derive(Default)]
pub(crate) struct Collisions {
    cells: BTreeMap<(u32, Vertex), AtMostOne>,
    edges: BTreeMap<(u32, u32), Crossings>,
    /// Pairs that ignore each other, the lower number first.
    ignored: BTreeSet<(AgentId, AgentId)>,
    /// Agents that may be at a vertex at a time, where pairs ignore each other.
    members: BTreeMap<(u32, Vertex), Vec<(AgentId, Lit)>>,
    soft: Option<SoftCollision>,
}

impl Collisions {
    /// Collisions of all pairs but these, given with the lower number first.
    pub(crate) fn new(ignored: BTreeSet<(AgentId, AgentId)>) -> Self {
        Self {
            ignored,
            ..Self::default()
        }
    }

    /// Collisions that may happen, and are told.
    pub(crate) fn soft() -> Self {
        Self {
            soft: Some(SoftCollision::default()),
            ..Self::default()
        }
    }

    /// Where collisions are soft: all that may happen so far.
    pub(crate) fn meetings(&self) -> impl Iterator<Item = (Meeting, Lit)> + '_ {
        let soft = self.soft.iter().flat_map(|soft| &soft.meetings);
        soft.map(|(&meeting, &lit)| (meeting, lit))
    }

    fn is_pairwise(&self) -> bool {
        self.soft.is_some() || !self.ignored.is_empty()
    }

    fn collide(&self, a: AgentId, b: AgentId) -> bool {
        a != b && !self.ignored.contains(&(a.min(b), a.max(b)))
    }

    /// An agent may be at a vertex at a time; once for each agent.
    pub(crate) fn occupy(
        &mut self,
        time: u32,
        v: Vertex,
        agent: AgentId,
        at: Lit,
        out: &mut impl Clauses,
    ) {
        if !self.is_pairwise() {
            self.cells.entry((time, v)).or_default().add(at, out);
            return;
        }
        let members = self.members.remove(&(time, v)).unwrap_or_default();
        for &(other, there) in &members {
            if self.collide(agent, other) {
                let meeting = meeting(time, v, agent, other);
                self.exclude(meeting, None, vec![!at, !there], out);
            }
        }
        let members = self.members.entry((time, v)).or_insert(members);
        members.push((agent, at));
    }

    /// An agent may cross an arc in the step that begins at a time, namely
    /// when both literals are true (one literal may be given twice).
    pub(crate) fn cross(
        &mut self,
        time: u32,
        arc: Arc,
        agent: AgentId,
        premise: Premise,
        out: &mut impl Clauses,
    ) {
        if self.is_pairwise() {
            self.cross_pairwise(time, arc, agent, premise, out);
            return;
        }
        let crossings = self.edges.entry((time, arc.edge())).or_default();
        if let Some(direction) = crossings.direction {
            imply(direction, arc.forward(), premise, out);
            return;
        }
        let [forward, backward] = &mut crossings.crossers;
        let (same, opposite) = if arc.forward() {
            (forward, backward)
        } else {
            (backward, forward)
        };
        same.push((agent, premise));
        if opposite.iter().any(|&(other, _)| other != agent) {
            let direction = out.fresh();
            crossings.direction = Some(direction);
            for (list, forward) in crossings.crossers.iter_mut().zip([true, false]) {
                for (_, premise) in std::mem::take(list) {
                    imply(direction, forward, premise, out);
                }
            }
        }
    }

    /// The same with a clause for each pair that does not ignore each other.
    fn cross_pairwise(
        &mut self,
        time: u32,
        arc: Arc,
        agent: AgentId,
        premise: Premise,
        out: &mut impl Clauses,
    ) {
        let key = (time, arc.edge());
        let mut crossings = self.edges.remove(&key).unwrap_or_default();
        let (same, opposite) = if arc.forward() { (0, 1) } else { (1, 0) };
        for &(other, against) in &crossings.crossers[opposite] {
            if self.collide(agent, other) {
                let mut clause = vec![!premise[0], !premise[1], !against[0], !against[1]];
                clause.dedup();
                // In the order of the agents, so that each pair has one name.
                let (first, second) = (premise[0].min(against[0]), premise[0].max(against[0]));
                let slow = arc.slow.then_some((first, second));
                let meeting = meeting(time, arc.to, agent, other);
                self.exclude(meeting, slow, clause, out);
            }
        }
        crossings.crossers[same].push((agent, premise));
        self.edges.insert(key, crossings);
    }

    /// Makes a clause of what must not be true together, or of what makes a
    /// soft collision happen. Both steps of two slow moves are one collision.
    fn exclude(
        &mut self,
        meeting: Meeting,
        slow: Option<(Lit, Lit)>,
        mut clause: Vec<Lit>,
        out: &mut impl Clauses,
    ) {
        if let Some(soft) = &mut self.soft {
            let known = slow.and_then(|moves| soft.slow.get(&moves).copied());
            let happens = known
                .unwrap_or_else(|| *soft.meetings.entry(meeting).or_insert_with(|| out.fresh()));
            if let Some(moves) = slow {
                soft.slow.insert(moves, happens);
            }
            clause.push(happens);
        }
        out.clause(&clause);
    }
}

fn meeting(time: u32, place: Vertex, a: AgentId, b: AgentId) -> Meeting {
    let pair = (a.min(b), a.max(b));
    Meeting { time, place, pair }
}

fn imply(direction: Lit, forward: bool, premise: Premise, out: &mut impl Clauses) {
    let direction = if forward { direction } else { !direction };
    let [a, b] = premise;
    if a == b {
        out.clause(&[!a, direction]);
    } else {
        out.clause(&[!a, !b, direction]);
    }
}
