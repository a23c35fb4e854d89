//! The calmest walk of one agent among others: lexicographic space-time A*.
//!
//! A state is a place at a time with the waypoints visited. Several labels of a state are
//! kept where none is better in all that matters later: driving so far, the cell that the
//! agent came from (a move back there is a turn), the battery, and the costs that are
//! limited.

mod bound;

use std::cell::RefCell;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

use rustc_hash::FxBuildHasher;

use super::{
    Driving,
    allowance::Allowance,
    label::{Label, NONE},
};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    local::OtherAgents,
    problem::Problem,
    rules::Presence,
    single::{Mask, Onward, Place, Task},
    terrain::Vertex,
    walk::Walk,
};

/// The search for a calmer walk of one agent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Query {
    pub(super) agent: AgentId,
    pub(super) allowance: Allowance,
    /// Only a walk with less driving than this one will do.
    pub(super) calmer_than: Option<Driving>,
    /// States to look at before giving up.
    pub(super) expansion_limit: u32,
}

/// The result of a search.
pub(super) struct Found {
    /// The calmest walk without collisions that keeps the allowance; `None` where there is
    /// none, or the limit of expansions was reached first.
    pub(super) walk: Option<Walk>,
    /// Agents that were in the way. While they keep their walks, nothing calmer is found.
    pub(super) blockers: BTreeSet<AgentId>,
}

/// Searches for the calmest walk of an agent.
///
/// # Errors
/// When the budget is spent.
pub(super) fn plan_one(
    problem: &Problem,
    others: &impl OtherAgents,
    query: Query,
    budget: &dyn Budget,
) -> Result<Found, Stop> {
    let task = &problem.tasks[query.agent];
    // Under `stay` nobody can rest at a goal that others still pass.
    let rests = problem.rests(query.agent) && problem.relaxed.ignored.is_empty();
    let goal = task.goal.filter(|_| rests);
    let passed = goal.and_then(|goal| others.last_visit(goal));
    let slow = query.allowance.moves.is_some() && has_slow_arcs(problem);
    let mut search = Search {
        problem,
        others,
        task,
        query,
        earliest: passed.map_or(0, |time| time + 1).max(task.not_before),
        steps_of_a_move: 1 + u32::from(slow),
        labels: Vec::new(),
        heap: BinaryHeap::new(),
        seen: Seen::default(),
        blockers: RefCell::default(),
    };
    if let Some(goal) = goal.filter(|_| passed.is_some()) {
        search.blockers.get_mut().extend(others.after(0, goal));
    }
    let walk = search.run(budget)?;
    Ok(Found {
        walk,
        blockers: search.blockers.into_inner(),
    })
}

/// Whether moves and steps in motion differ anywhere.
fn has_slow_arcs(problem: &Problem) -> bool {
    let terrain = &problem.terrain;
    let mut arcs = (0..terrain.size() as u32).flat_map(|v| terrain.arcs(v));
    arcs.any(|arc| arc.slow)
}

#[expect(
    clippy::disallowed_types,
    reason = "only looked up, never iterated, so its order cannot matter"
)]
type Seen = std::collections::HashMap<(u32, Place, Mask), u32, FxBuildHasher>;

struct Search<'a, O> {
    problem: &'a Problem,
    others: &'a O,
    task: &'a Task,
    query: Query,
    /// The agent does not arrive sooner.
    earliest: u32,
    /// The most steps that a move may take.
    steps_of_a_move: u32,
    labels: Vec<Label>,
    /// The least driving in all by way of a label, late labels first, and its number.
    heap: BinaryHeap<Reverse<(Driving, Reverse<u32>, u32)>>,
    seen: Seen,
    blockers: RefCell<BTreeSet<AgentId>>,
}

impl<O: OtherAgents> Search<'_, O> {
    fn run(&mut self, budget: &dyn Budget) -> Result<Option<Walk>, Stop> {
        let Some(first) = self.task.first() else {
            return Ok(None);
        };
        let came_from = match first.place {
            Place::At(v) if self.is_met(self.others.at(0, v)) => return Ok(None),
            Place::At(_) => None,
            Place::Along(arc) => Some(self.problem.terrain.ends(arc).0),
        };
        self.push(Label {
            state: first,
            time: 0,
            driving: Driving::default(),
            came_from,
            charges: 0,
            moves: 0,
            parent: NONE,
            next: NONE,
        });
        let mut expansions = self.query.expansion_limit;
        while let Some(Reverse((.., id))) = self.heap.pop() {
            budget.tick()?;
            let label = self.labels[id as usize];
            if self.may_end(&label) {
                return Ok(Some(self.walk_to(id)));
            }
            if expansions == 0 {
                break;
            }
            expansions -= 1;
            self.expand(id, &label);
        }
        Ok(None)
    }

    /// Whether one of some agents must not be met; such an agent is noted.
    fn is_met(&self, mut met: impl Iterator<Item = AgentId>) -> bool {
        let blocker = met.find(|&other| self.problem.collide(self.query.agent, other));
        self.blockers.borrow_mut().extend(blocker);
        blocker.is_some()
    }

    /// Whether an agent may end its walk here: nobody comes by later, and no rule forbids it.
    fn may_end(&self, label: &Label) -> bool {
        let Place::At(v) = label.state.place else {
            return false;
        };
        self.task.may_end(v, label.state.mask, label.time)
            && label.time >= self.earliest
            && !(self.problem.rests(self.query.agent)
                && self.is_met(self.others.after(label.time, v)))
            && !self.is_met(self.met_after_end(label, v).into_iter())
    }

    fn met_after_end(&self, label: &Label, v: Vertex) -> Vec<AgentId> {
        let (agent, mask) = (self.query.agent, label.state.mask);
        self.others.met_after_end(agent, v, label.time, mask)
    }

    fn expand(&mut self, id: u32, label: &Label) {
        let (problem, task) = (self.problem, self.task);
        let mut steps: Vec<(Onward, bool)> = Vec::with_capacity(10);
        let counts = self.query.allowance.charges.is_some() && task.reserve.is_some();
        let charger = match label.state.place {
            Place::At(v) => task.may_charge(&problem.terrain, v, Some(label.time)),
            Place::Along(_) => false,
        };
        for charging in [true, false] {
            if charging || counts && charger {
                task.onward(
                    &problem.terrain,
                    label.state,
                    label.time,
                    charging,
                    |step| {
                        steps.push((step, charging && counts && charger));
                    },
                );
            }
        }
        for (step, charged) in steps {
            self.reach(id, label, step, charged);
        }
    }

    fn reach(&mut self, parent: u32, from: &Label, step: Onward, charged: bool) {
        let mut label = Label {
            state: step.to,
            time: from.time + 1,
            charges: from.charges + u32::from(charged),
            parent,
            ..*from
        };
        if let Some(arc) = step.arc {
            let (start, end) = self.problem.terrain.ends(arc);
            let begins = matches!(from.state.place, Place::At(_));
            label.driving = from.driving.and_step(begins && from.came_from == Some(end));
            label.came_from = Some(start);
            label.moves += u32::from(begins);
        } else {
            label.driving = from.driving.and_wait(from.time);
        }
        let meets = |search: &Self| {
            let against = step
                .arc
                .is_some_and(|arc| search.is_met(search.others.against(from.time, arc)));
            let here = Presence {
                agent: search.query.agent,
                time: label.time,
                place: step.to.place,
                before: from.state.mask,
            };
            against
                || matches!(step.to.place, Place::At(v) if search.is_met(search.others.at(label.time, v)))
                || search.is_met(search.others.met_by_rules(here).into_iter())
        };
        if self.bound(&label).is_some() && !self.is_dominated(&label) && !meets(self) {
            self.push(label);
        }
    }

    /// Whether a label as good was reached before.
    fn is_dominated(&self, label: &Label) -> bool {
        let key = (label.time, label.state.place, label.state.mask);
        let mut id = self.seen.get(&key).copied().unwrap_or(NONE);
        while id != NONE {
            let known = &self.labels[id as usize];
            if known.dominates(label, &self.query.allowance) {
                return true;
            }
            id = known.next;
        }
        false
    }

    fn push(&mut self, mut label: Label) {
        let Some(bound) = self.bound(&label) else {
            return;
        };
        let id = self.labels.len() as u32;
        let key = (label.time, label.state.place, label.state.mask);
        label.next = self.seen.insert(key, id).unwrap_or(NONE);
        self.labels.push(label);
        self.heap.push(Reverse((bound, Reverse(label.time), id)));
    }

    fn walk_to(&self, mut id: u32) -> Walk {
        let mut walk = Walk::new();
        while id != NONE {
            let label = &self.labels[id as usize];
            walk.push(label.state.place);
            id = label.parent;
        }
        walk.reverse();
        walk
    }
}
