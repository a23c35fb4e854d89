//! Two agents that have to change places, as in a corridor.
//!
//! PIBT alone sends an agent forward as long as it can, and two that meet in a
//! corridor push each other for ever. So an agent looks ahead: where one of the
//! two can only get past after they have changed places, and further back
//! there is a junction for it, the first one goes back and the other follows
//! (Okumura, "Improving LaCAM for Scalable Eventually Optimal MAPF", 2023).

use super::step::Step;
use crate::{AgentId, plain::Plain, terrain::Vertex};

/// The agent with which an agent has to swap to enter a vertex.
pub(super) fn follower(
    plain: &Plain,
    step: &Step,
    agent: AgentId,
    wish: Vertex,
) -> Option<AgentId> {
    let at = step.now[agent];
    if wish == at {
        return None;
    }
    let corridor = Corridor { plain, step };
    if let Some(other) = step.occupant(wish)
        && !step.has_chosen(other)
        && corridor.is_required(agent, other, at, wish)
        && corridor.is_possible(wish, at)
    {
        return Some(other);
    }
    // A neighbour behind it may need it to clear the way.
    let behind = plain.neighbours(at).iter().filter(|&&v| v != wish);
    behind.filter_map(|&v| step.occupant(v)).find(|&other| {
        corridor.is_required(other, agent, at, wish) && corridor.is_possible(wish, at)
    })
}

struct Corridor<'a> {
    plain: &'a Plain<'a>,
    step: &'a Step<'a>,
}

/// The ways on from a cell in a corridor.
enum Onward {
    /// Two or more: here two agents can pass.
    Junction,
    /// One.
    To(Vertex),
    /// None.
    End,
}

impl Corridor<'_> {
    /// The ways on from `v` but back to `from`; a dead end where an agent is at
    /// its goal does not count.
    fn onward(&self, from: Vertex, v: Vertex) -> Onward {
        let mut only = Onward::End;
        for &u in self.plain.neighbours(v) {
            if u == from || self.is_closed(u) {
                continue;
            }
            only = match only {
                Onward::End => Onward::To(u),
                _ => return Onward::Junction,
            };
        }
        only
    }

    fn is_closed(&self, v: Vertex) -> bool {
        let arrived = |agent: AgentId| self.plain.goals()[agent] == v;
        self.plain.neighbours(v).len() == 1 && self.step.occupant(v).is_some_and(arrived)
    }

    /// Whether `pusher`, going on as it wants, pushes `puller` before it all
    /// along a corridor that `puller` wants to leave at the other end.
    fn is_required(
        &self,
        pusher: AgentId,
        puller: AgentId,
        pusher_at: Vertex,
        puller_at: Vertex,
    ) -> bool {
        let (mut behind, mut ahead) = (pusher_at, puller_at);
        let distance = |agent, v| self.step.to_go(agent, v);
        while distance(pusher, ahead) < distance(pusher, behind) {
            match self.onward(behind, ahead) {
                Onward::Junction => return false,
                Onward::End => break,
                Onward::To(next) => (behind, ahead) = (ahead, next),
            }
        }
        distance(puller, behind) < distance(puller, ahead)
            && (distance(pusher, behind) == 0 || distance(pusher, ahead) < distance(pusher, behind))
    }

    /// Whether the way back of an agent, away from the other one, comes to a
    /// junction.
    fn is_possible(&self, pusher_at: Vertex, puller_at: Vertex) -> bool {
        let (mut behind, mut ahead) = (pusher_at, puller_at);
        while ahead != pusher_at {
            match self.onward(behind, ahead) {
                Onward::Junction => return true,
                Onward::End => return false,
                Onward::To(next) => (behind, ahead) = (ahead, next),
            }
        }
        false
    }
}
