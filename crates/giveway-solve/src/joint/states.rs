//! The states of one agent that were met, by number, each with the steps that begin in it and
//! the least that the agent alone still pays.

use std::rc::Rc;

use giveway_model::Cost;
use rustc_hash::FxBuildHasher;

use super::{
    Joint, NO_LIMITS,
    agent::Single,
    event,
    tally::{TalliedCosts, Tally},
};
use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    problem::Problem,
    single::{CostToGo, Metric, Place},
    terrain::Vertex,
};

/// A state of one agent, in the order in which they were met.
pub(super) type StateId = u32;

#[expect(
    clippy::disallowed_types,
    reason = "only looked up, never iterated, so its order cannot matter"
)]
pub(super) type Table<K> = std::collections::HashMap<K, u32, FxBuildHasher>;

/// A step of one agent.
#[derive(Clone, Copy)]
pub(super) struct AgentStep {
    pub(super) to: StateId,
    /// The vertex that the agent holds after it.
    pub(super) stands: Option<Vertex>,
    /// The arc that is crossed in it.
    pub(super) arc: Option<u32>,
    pub(super) cost: Tally,
}

/// A state that was met.
struct Met {
    state: Single,
    /// The least that the agent alone still pays.
    to_go: Tally,
    /// The steps that the agent alone still needs at the least.
    steps_to_go: u32,
    /// The steps that begin here, as soon as they are asked for.
    steps: Option<Rc<[AgentStep]>>,
}

/// The states of one agent.
pub(super) struct States<'a> {
    joint: &'a Joint<'a>,
    /// The agent, by its place among those of the search.
    agent: usize,
    charges: Option<CostToGo>,
    moves: Option<CostToGo>,
    numbers: Table<Single>,
    met: Vec<Met>,
}

impl<'a> States<'a> {
    /// None so far.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn new(joint: &'a Joint<'_>, agent: usize, budget: &Budget) -> Result<Self, Stop> {
        let (task, problem) = (joint.task(agent), joint.problem);
        let table = |cost, metric| {
            let is_counted = joint.counted.has(cost);
            let table = is_counted.then(|| CostToGo::new(task, &problem.terrain, metric, budget));
            table.transpose()
        };
        let charges = match task.reserve {
            Some(_) => table(Cost::Charges, Metric::Charges)?,
            None => None,
        };
        let moves = table(Cost::Moves, Metric::Moves)?;
        Ok(Self {
            joint,
            agent,
            charges,
            moves,
            numbers: Table::default(),
            met: Vec::new(),
        })
    }

    /// The number of a state; `None` where the task cannot be ended from there.
    pub(super) fn number(&mut self, state: Single) -> Option<StateId> {
        if let Some(&number) = self.numbers.get(&state) {
            return Some(number);
        }
        let (to_go, steps_to_go) = self.to_go_from(state)?;
        let number = self.met.len() as StateId;
        self.met.push(Met {
            state,
            to_go,
            steps_to_go,
            steps: None,
        });
        self.numbers.insert(state, number);
        Some(number)
    }

    pub(super) fn state(&self, id: StateId) -> Single {
        self.met[id as usize].state
    }

    /// The least that the agent alone still pays.
    pub(super) fn to_go(&self, id: StateId) -> Tally {
        self.met[id as usize].to_go
    }

    /// The steps that the agent alone still needs at the least.
    pub(super) fn steps_to_go(&self, id: StateId) -> u32 {
        self.met[id as usize].steps_to_go
    }

    /// The steps that begin in a state.
    pub(super) fn steps(&mut self, id: StateId) -> Rc<[AgentStep]> {
        if let Some(steps) = &self.met[id as usize].steps {
            return Rc::clone(steps);
        }
        let moves = self.joint.moves(self.agent, self.state(id));
        let steps = moves.into_iter().filter_map(|step| {
            Some(AgentStep {
                to: self.number(step.to)?,
                stands: Joint::stands(step.to),
                arc: step.arc,
                cost: step.cost,
            })
        });
        let steps: Rc<[AgentStep]> = steps.collect();
        self.met[id as usize].steps = Some(Rc::clone(&steps));
        steps
    }

    /// The least that the agent alone pays from a state, and the steps that it needs: the exact
    /// tables know neither times nor what conditions count, and take the best case.
    fn to_go_from(&self, state: Single) -> Option<(Tally, u32)> {
        let Single::Going {
            place,
            mask,
            battery,
            clock,
            ..
        } = state
        else {
            return Some((Tally::default(), 0));
        };
        let Joint {
            problem, counted, ..
        } = self.joint;
        let (v, delay) = arrival(problem, place);
        let task = self.joint.task(self.agent);
        let mask = mask | task.bit(v);
        let from = |table: &CostToGo| table.from(v, mask, battery);
        let time = from(&problem.cost_to_go[self.joint.agents[self.agent]])? + delay;
        let charges = self.charges.as_ref().map_or(Some(0), from)?;
        let moves = self.moves.as_ref().map_or(Some(0), from)?;
        let to_go = counted.tally(|cost| match cost {
            Cost::Makespan | Cost::SumOfCosts => time,
            Cost::Charges => charges,
            Cost::Moves => moves,
            Cost::Waits => 0,
            Cost::Penalty => task.penalty_of_time(clock, clock.saturating_add(time)),
        });
        Some((to_go, time))
    }
}

/// How many states an agent reaches alone, of those in which its task can still be ended; once
/// there are more than `most`, no more are looked for.
///
/// # Errors
/// When the budget is spent.
#[inline(never)]
pub(super) fn reached_alone(
    problem: &Problem,
    agent: AgentId,
    most: usize,
    budget: &Budget,
) -> Result<usize, Stop> {
    let agents = [agent];
    let joint = Joint {
        problem,
        agents: &agents,
        counted: TalliedCosts::new(&[], &NO_LIMITS),
    };
    if !event::can_count(joint.task(0)) {
        return Ok(usize::MAX);
    }
    let mut states = States::new(&joint, 0, budget)?;
    for (start, _) in joint.starts() {
        states.number(start[0]);
    }
    let mut next = 0;
    while next < states.met.len() && states.met.len() <= most {
        budget.tick()?;
        states.steps(next as StateId);
        next += 1;
    }
    Ok(states.met.len())
}

/// The vertex at which an agent is, or is in one step.
fn arrival(problem: &Problem, place: Place) -> (Vertex, u32) {
    match place {
        Place::At(v) => (v, 0),
        Place::Along(arc) => (problem.terrain.ends(arc).1, 1),
    }
}

/// The least that agents still pay together in a joint state.
pub(super) fn to_go(counted: &TalliedCosts, states: &[States<'_>], joint: &[StateId]) -> Tally {
    let each = states
        .iter()
        .zip(joint)
        .map(|(states, &id)| states.to_go(id));
    each.fold(Tally::default(), |all, own| counted.join(all, own))
}
