//! One agent alone: all the states that it can have, and its steps from one to
//! the next.

use std::collections::BTreeMap;

use giveway_model::{Agent, Cell, Instance};

use super::contrast::Asked;
use super::law::{Law, Next, Place, State};
use super::price::Price;
use super::world::World;

/// One step of time in the life of an agent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    /// The number of the state in which it ends.
    pub(crate) to: usize,
    /// The edge on which the agent is during the step, from and to.
    pub(crate) edge: Option<(Cell, Cell)>,
    /// What it costs.
    pub(crate) price: Price,
}

/// The states of one agent that it can reach alone, and from which it can
/// arrive alone; the others belong to no plan.
pub(crate) struct Lone {
    /// The name of the agent.
    pub(crate) name: String,
    pub(crate) states: Vec<State>,
    /// The steps from each state.
    pub(crate) steps: Vec<Vec<Step>>,
    /// The states possible at time 0: none where it cannot arrive at all, two
    /// where it may have arrived at once or may step aside first.
    pub(crate) first: Vec<usize>,
    /// The least number of steps from each state to the arrival.
    pub(crate) to_go: Vec<u32>,
}

impl Lone {
    /// Explores the states of an agent that stays where it arrives, or does not, begins
    /// no move before a time, and may come from a cell half way along a slow move.
    pub(crate) fn new(
        world: &World,
        instance: &Instance,
        agent: &Agent,
        stays: bool,
        asked: Option<Asked>,
        (held, transit): (u32, Option<Cell>),
    ) -> Self {
        let law = Law {
            world,
            agent,
            floor: instance.rules().battery_floor,
            stays,
            asked,
            held,
            transit,
        };
        let (states, steps, first) = explore(&law);
        keep_hopeful(agent, &states, &steps, &first)
    }

    /// The vertex that the agent occupies in a state; none in transit, and none
    /// once it has vanished.
    pub(crate) fn occupies(&self, state: usize) -> Option<Cell> {
        match self.states[state].place {
            Place::At(cell) | Place::Arrived(cell) => Some(cell),
            Place::Between(..) | Place::Gone => None,
        }
    }

    /// Whether the agent has arrived for good.
    pub(crate) fn is_done(&self, state: usize) -> bool {
        matches!(self.states[state].place, Place::Arrived(_) | Place::Gone)
    }
}

/// All states that can be reached, the steps from each, and the numbers of the
/// first ones.
fn explore(law: &Law) -> (Vec<State>, Vec<Vec<Step>>, Vec<usize>) {
    let mut states: Vec<State> = law.first();
    let first: Vec<usize> = (0..states.len()).collect();
    let mut numbers: BTreeMap<State, usize> =
        states.iter().enumerate().map(|(i, &s)| (s, i)).collect();
    let mut steps = Vec::new();
    while steps.len() < states.len() {
        let mut from_here = Vec::new();
        for Next { state, edge, price } in law.steps(states[steps.len()]) {
            let to = *numbers.entry(state).or_insert_with(|| {
                states.push(state);
                states.len() - 1
            });
            from_here.push(Step { to, edge, price });
        }
        steps.push(from_here);
    }
    (states, steps, first)
}

/// Leaves out the states from which the agent cannot arrive.
fn keep_hopeful(agent: &Agent, states: &[State], steps: &[Vec<Step>], first: &[usize]) -> Lone {
    let to_go = steps_to_go(states, steps);
    let kept: Vec<usize> = (0..states.len()).filter(|&s| to_go[s].is_some()).collect();
    let number: BTreeMap<usize, usize> = kept.iter().enumerate().map(|(i, &s)| (s, i)).collect();
    let hopeful = |step: &Step| {
        let to = *number.get(&step.to)?;
        Some(Step { to, ..*step })
    };
    Lone {
        name: agent.name.clone(),
        states: kept.iter().map(|&s| states[s]).collect(),
        steps: kept
            .iter()
            .map(|&s| steps[s].iter().filter_map(hopeful).collect())
            .collect(),
        first: first
            .iter()
            .filter_map(|s| number.get(s).copied())
            .collect(),
        to_go: kept.iter().filter_map(|&s| to_go[s]).collect(),
    }
}

/// The least number of steps from each state to an arrival, by rounds: a state
/// is `k + 1` steps away if none of its steps ends nearer than `k` and one ends
/// there. `None` where there is no way.
fn steps_to_go(states: &[State], steps: &[Vec<Step>]) -> Vec<Option<u32>> {
    let done = |s: &State| matches!(s.place, Place::Arrived(_) | Place::Gone).then_some(0);
    let mut to_go: Vec<Option<u32>> = states.iter().map(done).collect();
    for round in 1.. {
        let reached: Vec<usize> = (0..states.len())
            .filter(|&s| to_go[s].is_none() && steps[s].iter().any(|step| to_go[step.to].is_some()))
            .collect();
        if reached.is_empty() {
            break;
        }
        for s in reached {
            to_go[s] = Some(round);
        }
    }
    to_go
}
