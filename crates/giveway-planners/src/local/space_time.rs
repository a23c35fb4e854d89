//! One agent among others whose walks are given: space-time A*.
//!
//! Silver, "Cooperative pathfinding" (2005), with exact distances as the
//! heuristic, waypoints in the state, and of two ways to one state the one with
//! the fuller battery. Collisions are forbidden, or allowed at a price in time.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use rustc_hash::FxBuildHasher;

use super::OtherAgents;
use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::Problem,
    rules::Presence,
    single::{self as task, Mask, Place},
    walk::Walk,
};

/// The search for a walk of one agent.
#[derive(Clone, Copy, Debug)]
pub struct Query {
    /// The agent.
    pub agent: AgentId,
    /// It must arrive by this time.
    pub latest: u32,
    /// How many steps of delay a collision is worth; `None` forbids them.
    pub conflict_penalty: Option<u32>,
    /// States to look at before giving up.
    pub expansion_limit: u32,
}

struct Label {
    place: Place,
    mask: Mask,
    battery: u32,
    time: u32,
    collisions: u32,
    parent: u32,
}

#[expect(
    clippy::disallowed_types,
    reason = "only looked up, never iterated, so its order cannot matter"
)]
type Seen = std::collections::HashMap<(u32, Place, Mask), (u32, u32), FxBuildHasher>;

/// Arrival and the price of collisions, then collisions, then late states
/// first, then order of birth.
type Key = (u32, u32, Reverse<u32>, u32);

/// The best walk of an agent among the others, and its number of collisions
/// (each counted by time); `None` where there is none by the latest time, or
/// none was found with the effort.
///
/// # Errors
/// When the budget is spent.
pub fn plan_one(
    problem: &Problem,
    others: &impl OtherAgents,
    query: Query,
    budget: &dyn Budget,
) -> Result<Option<(Walk, u32)>, Stop> {
    // Under `stay` nobody can rest at a goal that others still pass. To know
    // that from the beginning spares all tries to arrive sooner.
    let task = &problem.tasks[query.agent];
    let query = Query {
        latest: query.latest.min(task.not_after()),
        ..query
    };
    // Some of those that pass may not count, where pairs ignore each other.
    let all_count = problem.relaxed.ignored.is_empty();
    let rests = problem.rests(query.agent) && all_count;
    let waits = rests
        && query
            .conflict_penalty
            .is_none_or(|conflict_penalty| conflict_penalty >= DEAR);
    let passed = task.goal.and_then(|goal| others.last_visit(goal));
    let passed = passed.filter(|_| waits);
    let earliest = passed.map_or(0, |time| time + 1);
    if earliest > query.latest && query.conflict_penalty.is_none() {
        return Ok(None);
    }
    let mut search = SpaceTimeAStar {
        problem,
        others,
        query,
        earliest: if earliest > query.latest { 0 } else { earliest },
        states: Vec::new(),
        heap: BinaryHeap::new(),
        seen: Seen::default(),
    };
    search.run(budget)
}

/// A collision that any detour is better than, in steps of delay.
pub const DEAR: u32 = 10_000;

struct SpaceTimeAStar<'a, O> {
    problem: &'a Problem,
    others: &'a O,
    query: Query,
    /// It does not arrive sooner, except into a collision.
    earliest: u32,
    states: Vec<Label>,
    /// Whether the entry ends the walk, and the state's number.
    heap: BinaryHeap<Reverse<(Key, bool)>>,
    seen: Seen,
}

const NO_PARENT: u32 = u32::MAX;

impl<O: OtherAgents> SpaceTimeAStar<'_, O> {
    fn run(&mut self, budget: &dyn Budget) -> Result<Option<(Walk, u32)>, Stop> {
        let task = &self.problem.tasks[self.query.agent];
        let collisions = match task.first_place() {
            Place::At(v) => self.count(self.others.at(0, v)),
            Place::Along(_) => 0,
        };
        let collisions = collisions + self.broken_rules(task.first_place(), 0, 0);
        if collisions > 0 && self.query.conflict_penalty.is_none() {
            return Ok(None);
        }
        let Some(first) = task.first() else {
            return Ok(None);
        };
        if let Some(bound) = self.bound(first, 0) {
            self.push(first, (0, bound), collisions, NO_PARENT);
        }
        let mut expansion_limit = self.query.expansion_limit;
        while let Some(Reverse(((_, collisions, _, id), ends))) = self.heap.pop() {
            budget.tick()?;
            if ends {
                return Ok(Some((self.walk_to(id), collisions)));
            }
            if expansion_limit == 0 {
                break;
            }
            expansion_limit -= 1;
            self.try_to_end(id);
            self.expand(id);
        }
        Ok(None)
    }

    /// How many of some agents it must not meet.
    fn count(&self, met: impl Iterator<Item = AgentId>) -> u32 {
        let agent = self.query.agent;
        met.filter(|&other| self.problem.collide(agent, other))
            .count() as u32
    }

    /// With how many agents it breaks a rule between agents at a place and time; `before`
    /// is how far it had come the time before.
    fn broken_rules(&self, place: Place, time: u32, before: Mask) -> u32 {
        if !self.problem.has_rules_between() {
            return 0;
        }
        let here = Presence {
            agent: self.query.agent,
            time,
            place,
            before,
        };
        self.others.met_by_rules(here).len() as u32
    }

    /// An agent at its goal may end there, if nobody comes by later.
    fn try_to_end(&mut self, id: u32) {
        let task = &self.problem.tasks[self.query.agent];
        let state = &self.states[id as usize];
        let Place::At(v) = state.place else { return };
        if !task.may_end(v, state.mask, state.time) {
            return;
        }
        let (agent, rests) = (self.query.agent, self.problem.rests(self.query.agent));
        let passing = if rests {
            self.count(self.others.after(state.time, v))
        } else {
            0
        };
        let by_rules = self.others.met_after_end(agent, v, state.time, state.mask);
        let later = passing + by_rules.len() as u32;
        if later == 0 || self.query.conflict_penalty.is_some() {
            let (time, collisions) = (state.time, state.collisions + later);
            let key = (self.total(time, collisions), collisions, Reverse(time), id);
            self.heap.push(Reverse((key, true)));
        }
    }

    fn expand(&mut self, id: u32) {
        let problem = self.problem;
        let task = &problem.tasks[self.query.agent];
        let state = &self.states[id as usize];
        let (time, collisions) = (state.time, state.collisions);
        let from = task::State {
            place: state.place,
            mask: state.mask,
            battery: state.battery,
        };
        let others = self.others;
        task.onward(&problem.terrain, from, time, true, |step| {
            let against = step.arc.map(|arc| self.count(others.against(time, arc)));
            let collisions = collisions + against.unwrap_or(0);
            self.reach(step.to, time + 1, collisions, (id, from.mask));
        });
    }

    /// The cheap check comes first: most ways are too long.
    fn reach(
        &mut self,
        to: task::State,
        time: u32,
        collisions: u32,
        (parent, before): (u32, Mask),
    ) {
        let Some(bound) = self.bound(to, time) else {
            return;
        };
        if self.is_known(to, time, collisions) {
            return;
        }
        let met = match to.place {
            Place::At(v) => self.count(self.others.at(time, v)),
            Place::Along(_) => 0,
        };
        let met = met + self.broken_rules(to.place, time, before);
        if self.query.conflict_penalty.is_some() || collisions + met == 0 {
            self.push(to, (time, bound), collisions + met, parent);
        }
    }

    /// The earliest arrival from a state, if that is early enough.
    fn bound(&self, to: task::State, time: u32) -> Option<u32> {
        let task = &self.problem.tasks[self.query.agent];
        let (arrival, delay) = match to.place {
            Place::At(v) => (v, 0),
            Place::Along(arc) => (self.problem.terrain.ends(arc).1, 1),
        };
        let cost_to_go = &self.problem.cost_to_go[self.query.agent];
        let rest = cost_to_go.from(arrival, to.mask | task.bit(arrival), to.battery)?;
        let bound = (time + delay + rest).max(self.earliest);
        (bound <= self.query.latest).then_some(bound)
    }

    /// Whether a state as good was reached before.
    fn is_known(&self, to: task::State, time: u32, collisions: u32) -> bool {
        let seen = self.seen.get(&(time, to.place, to.mask));
        seen.is_some_and(|&(fewer, fuller)| fewer <= collisions && fuller >= to.battery)
    }

    fn push(&mut self, to: task::State, (time, bound): (u32, u32), collisions: u32, parent: u32) {
        if self.is_known(to, time, collisions) {
            return;
        }
        let task::State {
            place,
            mask,
            battery,
        } = to;
        self.seen.insert((time, place, mask), (collisions, battery));
        let id = self.states.len() as u32;
        self.states.push(Label {
            place,
            mask,
            battery,
            time,
            collisions,
            parent,
        });
        let key = (self.total(bound, collisions), collisions, Reverse(time), id);
        self.heap.push(Reverse((key, false)));
    }

    fn total(&self, arrival: u32, collisions: u32) -> u32 {
        let conflict_penalty = self.query.conflict_penalty.unwrap_or(0);
        arrival.saturating_add(conflict_penalty.saturating_mul(collisions))
    }

    fn walk_to(&self, mut id: u32) -> Walk {
        let mut walk = Walk::new();
        while id != NO_PARENT {
            let state = &self.states[id as usize];
            walk.push(state.place);
            id = state.parent;
        }
        walk.reverse();
        walk
    }
}
