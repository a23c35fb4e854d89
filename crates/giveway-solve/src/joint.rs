//! All agents at once: joint states, exhausted.
//!
//! Practical for two or three agents on small maps. It proves what a horizon
//! cannot: that there is no plan at all, or the least charges, moves or waits
//! whatever the makespan. Dijkstra over joint states, each agent's state being
//! its place, its waypoints and its battery.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use giveway_model::Cost;

use crate::{
    encode::collisions::AgentId,
    meter::{Meter, Stop},
    problem::Problem,
    single::{Place, Task},
};

/// Joint steps to look at before giving up.
const MOST_STEPS: usize = 1_500_000;
/// Agents beyond which not even a small map is small enough.
const MOST_AGENTS: usize = 3;

/// What exhausting the states has shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Found {
    /// The least value, at any horizon.
    Least(u32),
    /// No plan at any horizon.
    None,
    /// There were too many states.
    TooMany,
}

/// The state of one agent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Single {
    /// On its way.
    Going {
        place: Place,
        mask: u32,
        battery: u32,
    },
    /// Arrived this very time step, under `vanish`: it still holds its goal.
    Leaving,
    /// Arrived for good.
    Arrived,
}

/// A step of one agent.
#[derive(Clone, Copy, Debug)]
struct Move {
    to: Single,
    /// The arc that is crossed in this step.
    arc: Option<u32>,
    cost: u32,
}

/// The least charges, moves or waits of some agents among themselves; for any
/// other cost just whether they have a plan (its value is then 0).
///
/// # Errors
/// When the budget is spent.
pub(crate) fn least(
    problem: &Problem,
    agents: &[AgentId],
    cost: Cost,
    meter: &Meter,
) -> Result<Found, Stop> {
    if agents.len() > MOST_AGENTS || agents.is_empty() {
        return Ok(Found::TooMany);
    }
    let search = Joint {
        problem,
        agents,
        cost,
    };
    let mut best: BTreeMap<Vec<Single>, u32> = BTreeMap::new();
    let mut heap = BinaryHeap::new();
    for start in search.starts() {
        best.insert(start.clone(), 0);
        heap.push(Reverse((0, start)));
    }
    let mut steps = 0;
    while let Some(Reverse((paid, state))) = heap.pop() {
        meter.tick()?;
        if best.get(&state).is_some_and(|&other| other < paid) {
            continue;
        }
        if state
            .iter()
            .all(|s| matches!(s, Single::Leaving | Single::Arrived))
        {
            return Ok(Found::Least(paid));
        }
        let successors = search.successors(&state);
        steps += successors.len();
        for (next, cost) in successors {
            let total = paid + cost;
            if best.get(&next).is_none_or(|&other| total < other) {
                best.insert(next.clone(), total);
                heap.push(Reverse((total, next)));
            }
        }
        if steps > MOST_STEPS {
            return Ok(Found::TooMany);
        }
    }
    Ok(Found::None)
}

struct Joint<'a> {
    problem: &'a Problem,
    agents: &'a [AgentId],
    cost: Cost,
}

impl Joint<'_> {
    fn task(&self, i: usize) -> &Task {
        &self.problem.tasks[self.agents[i]]
    }

    fn starts(&self) -> Vec<Vec<Single>> {
        let mut joint = vec![Vec::new()];
        for i in 0..self.agents.len() {
            let task = self.task(i);
            let first = Single::Going {
                place: Place::At(task.start),
                mask: task.first_mask(),
                battery: task.first_level(),
            };
            let choices = self.or_arrived(i, first);
            joint = joint
                .iter()
                .flat_map(|head| {
                    choices.iter().map(move |choice| {
                        let mut state: Vec<Single> = head.clone();
                        state.push(*choice);
                        state
                    })
                })
                .collect();
        }
        joint
    }

    /// A state, and the arrival that it allows.
    fn or_arrived(&self, i: usize, state: Single) -> Vec<Single> {
        let mut choices = vec![state];
        if let Single::Going {
            place: Place::At(v),
            mask,
            ..
        } = state
            && self.task(i).is_end(v, mask)
        {
            choices.push(if self.problem.rests(self.agents[i]) {
                Single::Arrived
            } else {
                Single::Leaving
            });
        }
        choices
    }

    /// All joint states one step on, with what the step costs.
    fn successors(&self, state: &[Single]) -> Vec<(Vec<Single>, u32)> {
        let moves: Vec<Vec<Move>> = (0..state.len()).map(|i| self.moves(i, state[i])).collect();
        let mut found = Vec::new();
        let mut chosen = Vec::new();
        self.combine(&moves, &mut chosen, &mut found);
        found
    }

    fn combine(
        &self,
        moves: &[Vec<Move>],
        chosen: &mut Vec<Move>,
        found: &mut Vec<(Vec<Single>, u32)>,
    ) {
        let i = chosen.len();
        let Some(choices) = moves.get(i) else {
            let state = chosen.iter().map(|m| m.to).collect();
            found.push((state, chosen.iter().map(|m| m.cost).sum()));
            return;
        };
        for &choice in choices {
            let place = self.stands(i, choice.to);
            let free = chosen.iter().enumerate().all(|(j, other)| {
                let meet = place.is_some() && place == self.stands(j, other.to);
                let swap = choice.arc.is_some() && choice.arc == other.arc.map(|arc| arc ^ 1);
                let collide = self.problem.collide(self.agents[i], self.agents[j]);
                !(collide && (meet || swap))
            });
            if free {
                chosen.push(choice);
                self.combine(moves, chosen, found);
                chosen.pop();
            }
        }
    }

    /// The vertex that an agent holds.
    fn stands(&self, i: usize, state: Single) -> Option<u32> {
        match state {
            Single::Going {
                place: Place::At(v),
                ..
            } => Some(v),
            Single::Leaving => Some(self.task(i).goal),
            Single::Arrived if self.problem.rests(self.agents[i]) => Some(self.task(i).goal),
            _ => None,
        }
    }

    fn moves(&self, i: usize, state: Single) -> Vec<Move> {
        let Single::Going {
            place,
            mask,
            battery,
        } = state
        else {
            return vec![Move {
                to: Single::Arrived,
                arc: None,
                cost: 0,
            }];
        };
        let mut moves = Vec::new();
        let task = self.task(i);
        let terrain = &self.problem.terrain;
        match place {
            Place::Along(arc) => {
                let (_, v) = terrain.ends(arc);
                self.arrive(i, v, mask, Some(battery), Some(arc), 0, &mut moves);
            }
            Place::At(u) => {
                for charged in [false, true] {
                    if charged && (task.reserve.is_none() || !terrain.is_charger(u)) {
                        continue;
                    }
                    let after = |steps: u32| match task.reserve {
                        None => Some(0),
                        Some(reserve) if charged => (reserve.full + 1).checked_sub(steps),
                        Some(_) => battery.checked_sub(steps),
                    };
                    let charge = u32::from(charged && self.cost == Cost::Charges);
                    let wait = charge + u32::from(self.cost == Cost::Waits);
                    self.arrive(i, u, mask, after(1), None, wait, &mut moves);
                    let go = charge + u32::from(self.cost == Cost::Moves);
                    for arc in terrain.arcs(u) {
                        if !arc.slow {
                            self.arrive(i, arc.to, mask, after(1), Some(arc.id), go, &mut moves);
                        } else if let Some(battery) = after(2) {
                            let to = Single::Going {
                                place: Place::Along(arc.id),
                                mask,
                                battery,
                            };
                            let arc = Some(arc.id);
                            moves.push(Move { to, arc, cost: go });
                        }
                    }
                }
            }
        }
        moves
    }

    /// A step that ends at a vertex: on the way, or there for good.
    #[expect(clippy::too_many_arguments, reason = "one step has that many parts")]
    fn arrive(
        &self,
        i: usize,
        v: u32,
        mask: u32,
        battery: Option<u32>,
        arc: Option<u32>,
        cost: u32,
        moves: &mut Vec<Move>,
    ) {
        let Some(battery) = battery else { return };
        let state = Single::Going {
            place: Place::At(v),
            mask: mask | self.task(i).bit(v),
            battery,
        };
        for to in self.or_arrived(i, state) {
            moves.push(Move { to, arc, cost });
        }
    }
}
