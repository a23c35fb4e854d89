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
    condition::Precedence,
    encode::collisions::AgentId,
    meter::{Meter, Stop},
    problem::Problem,
    single::{Demand, Place, State, Task},
};

/// Joint steps to look at before giving up.
const MOST_STEPS: usize = 1_500_000;
/// Agents beyond which only the smallest maps are small enough.
const MOST_AGENTS: usize = 3;

/// Joint states up to which they are exhausted before anything else is tried.
const FEW_STATES: usize = 50_000;

/// Whether there are so few joint states that they are best exhausted at once.
pub(crate) fn is_small(problem: &Problem) -> bool {
    has_few_states(problem, 0..problem.agents())
}

/// Whether some agents have so few joint states among themselves.
fn has_few_states(problem: &Problem, agents: impl Iterator<Item = AgentId>) -> bool {
    let states = agents.map(|agent| {
        let task = &problem.tasks[agent];
        let cells = problem.terrain.len();
        cells
            .saturating_mul(task.masks())
            .saturating_mul(task.levels())
    });
    states.fold(1, usize::saturating_mul) <= FEW_STATES
}

/// Whether it is worth the try to exhaust the joint states of some agents.
fn may_be_exhausted(problem: &Problem, agents: &[AgentId]) -> bool {
    let few = agents.len() <= MOST_AGENTS || has_few_states(problem, agents.iter().copied());
    few && !agents.is_empty()
}

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
        /// The time, as far as a demand on the agent looks at it.
        clock: u32,
        /// Events that a demand on the agent counts.
        count: u32,
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
    if !may_be_exhausted(problem, agents) {
        return Ok(Found::TooMany);
    }
    let search = Joint {
        problem,
        agents,
        cost,
    };
    let most = MOST_STEPS.min(usize::try_from(meter.joint_left()).unwrap_or(MOST_STEPS));
    let mut steps = 0;
    let found = search.run(most, &mut steps, meter);
    meter.count_joint(steps as u64);
    found
}

struct Joint<'a> {
    problem: &'a Problem,
    agents: &'a [AgentId],
    cost: Cost,
}

impl Joint<'_> {
    fn run(&self, most: usize, steps: &mut usize, meter: &Meter) -> Result<Found, Stop> {
        let mut best: BTreeMap<Vec<Single>, u32> = BTreeMap::new();
        let mut heap = BinaryHeap::new();
        for start in self.starts() {
            best.insert(start.clone(), 0);
            heap.push(Reverse((0, start)));
        }
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
            let successors = self.successors(&state);
            *steps += successors.len();
            for (next, cost) in successors {
                let total = paid + cost;
                if best.get(&next).is_none_or(|&other| total < other) {
                    best.insert(next.clone(), total);
                    heap.push(Reverse((total, next)));
                }
            }
            if *steps > most {
                return Ok(Found::TooMany);
            }
        }
        Ok(Found::None)
    }

    fn task(&self, i: usize) -> &Task {
        &self.problem.tasks[self.agents[i]]
    }

    fn starts(&self) -> Vec<Vec<Single>> {
        let mut joint = vec![Vec::new()];
        for i in 0..self.agents.len() {
            let task = self.task(i);
            let Some(state) = task.first() else {
                return Vec::new();
            };
            let first = Single::Going {
                place: state.place,
                mask: state.mask,
                battery: state.battery,
                clock: 0,
                count: 0,
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
        joint.retain(|state| self.is_in_order(state));
        joint
    }

    /// Whether who has to be somewhere first has been there, if the other is.
    fn is_in_order(&self, state: &[Single]) -> bool {
        let Some(Precedence { first, second, at }) = self.problem.precedence else {
            return true;
        };
        let number = |agent| self.agents.iter().position(|&other| other == agent);
        let (Some(first), Some(second)) = (number(first), number(second)) else {
            return true;
        };
        if self.stands(second, state[second]) != Some(at) {
            return true;
        }
        match state[first] {
            Single::Going { mask, .. } => mask & self.task(first).bit(at) != 0,
            Single::Leaving | Single::Arrived => true,
        }
    }

    /// A state, and the arrival that it allows.
    fn or_arrived(&self, i: usize, state: Single) -> Vec<Single> {
        let mut choices = vec![state];
        let task = self.task(i);
        if let Single::Going {
            place: Place::At(v),
            mask,
            clock,
            ..
        } = state
            && task.is_end(v, mask)
            && task.not_before <= clock
            && clock <= task.not_after()
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
        found.retain(|(state, _)| self.is_in_order(state));
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
            clock,
            count,
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
        let from = State {
            place,
            mask,
            battery,
        };
        let terrain = &self.problem.terrain;
        for charged in [false, true] {
            let charger = matches!(place, Place::At(u) if task.may_charge(terrain, u, Some(clock)));
            if charged && !(charger && task.reserve.is_some()) {
                continue;
            }
            task.onward(terrain, from, clock, charged, |step| {
                let event = Event {
                    from: place,
                    to: step.to.place,
                    clock,
                    charged,
                };
                let Some((count, mask)) = follow(task, count, [mask, step.to.mask], event) else {
                    return;
                };
                let last = task.last_time();
                if clock >= task.not_after() {
                    return;
                }
                let to = Single::Going {
                    place: step.to.place,
                    mask,
                    battery: step.to.battery,
                    clock: last.map_or(0, |last| (clock + 1).min(last.saturating_add(1))),
                    count,
                };
                let cost = event.costs(self.cost);
                for to in self.or_arrived(i, to) {
                    let arc = step.arc;
                    moves.push(Move { to, arc, cost });
                }
            });
        }
        moves
    }
}

/// What happens to one agent in a step.
#[derive(Clone, Copy, Debug)]
struct Event {
    from: Place,
    to: Place,
    clock: u32,
    charged: bool,
}

impl Event {
    fn waits(self) -> bool {
        matches!((self.from, self.to), (Place::At(u), Place::At(v)) if u == v)
    }

    /// What the step adds to a cost.
    fn costs(self, cost: Cost) -> u32 {
        let counts = match cost {
            Cost::Charges => self.charged,
            Cost::Waits => self.waits(),
            Cost::Moves => matches!(self.from, Place::At(_)) && !self.waits(),
            Cost::Makespan | Cost::SumOfCosts => false,
        };
        u32::from(counts)
    }
}

/// What the demand on an agent counts after a step, and its mask; `None` where
/// it counts too much.
fn follow(task: &Task, count: u32, [before, mask]: [u32; 2], event: Event) -> Option<(u32, u32)> {
    match (&task.demand, event.from) {
        (Some(demand @ Demand::Wait { steps, .. }), Place::At(v)) => {
            let counts = event.waits() && demand.counts_wait(v, event.clock);
            let run = if counts { count + 1 } else { 0 };
            (run < *steps).then_some((run, mask))
        }
        (Some(Demand::AtMost { cost, most }), _) => {
            let count = count + event.costs(*cost);
            (count <= *most).then_some((count, mask))
        }
        // Leaving sets the bit just where it charged while it was there.
        (Some(Demand::Charge { v, .. }), Place::At(u)) if u == *v => {
            let charged = count.max(u32::from(event.charged));
            if event.waits() {
                return Some((charged, mask));
            }
            let bit = task.demanded_bit();
            let uncharged = mask & !bit | before & bit;
            Some((0, if charged == 0 { uncharged } else { mask }))
        }
        _ => Some((0, mask)),
    }
}
