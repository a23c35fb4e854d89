//! All agents together: joint states, joint steps, and what is a collision.

use std::collections::BTreeSet;

use giveway_model::{Cell, Instance};

use super::contrast::{Asked, Contrast};
use super::leniency::Leniency;
use super::lone::{Lone, Step};
use super::price::Price;
use super::together::Together;
use super::world::World;

/// The agents of an instance, each with its own states and steps.
pub(crate) struct Joint {
    pub(crate) agents: Vec<Lone>,
    /// Who must have been at a cell before whom, where a question asks for it.
    precedence: Option<(usize, usize, Cell)>,
    /// Who ignores whom, both ways.
    ignored: BTreeSet<(usize, usize)>,
}

/// One state of each agent, as one number: the states are its digits, and the
/// numbers of states of the agents are the bases.
pub(crate) type Code = u64;

impl Joint {
    /// Explores each agent alone.
    pub(crate) fn new(instance: &Instance) -> Self {
        Self::asked(instance, None, &Leniency::default())
    }

    /// The same with what a question asks for, and some rules left out.
    pub(crate) fn asked(
        instance: &Instance,
        contrast: Option<Contrast>,
        leniency: &Leniency,
    ) -> Self {
        let world = World::new(&instance.to_scene().map);
        let agents: Vec<Lone> = instance
            .agents()
            .iter()
            .map(|agent| {
                let stays = instance.stays() || agent.goal.is_none();
                let stays = stays && !leniency.gone.contains(&agent.name);
                let waited = leniency.waited.get(&agent.name).copied().unwrap_or(0);
                let asked = contrast.and_then(|c| Asked::of(c, &agent.name, stays));
                let asked = asked.map(|asked| asked.having_waited(waited));
                let held = leniency.held.get(&agent.name).copied().unwrap_or(0);
                let transit = leniency.transit.get(&agent.name).copied();
                Lone::new(&world, instance, agent, stays, asked, (held, transit))
            })
            .collect();
        let size = agents
            .iter()
            .try_fold(1_u64, |size, a| size.checked_mul(a.states.len() as u64));
        assert!(size.is_some(), "too many joint states for the oracle");
        let number = |name: &str| agents.iter().position(|a| a.name == name);
        let precedence = match contrast.and_then(|contrast| contrast.together()) {
            Some(Together::Before(agent, to, at)) => {
                number(agent).zip(number(to)).map(|(a, b)| (a, b, at))
            }
            Some(Together::Less(_)) | None => None,
        };
        let pairs = leniency.ignoring.iter();
        let pairs = pairs.filter_map(|(a, b)| number(a).zip(number(b)));
        let ignored = pairs.flat_map(|(a, b)| [(a, b), (b, a)]).collect();
        Self {
            agents,
            precedence,
            ignored,
        }
    }

    /// The least arrival of each agent alone; `None` where it has none.
    pub(crate) fn lone_optima(&self) -> Vec<Option<u32>> {
        let least = |a: &Lone| a.first.iter().map(|&s| a.to_go[s]).min();
        self.agents.iter().map(least).collect()
    }

    /// The states as digits of one number.
    pub(crate) fn encode(&self, states: &[usize]) -> Code {
        let digits = self.agents.iter().zip(states);
        digits.fold(0, |code, (a, &s)| code * a.states.len() as u64 + s as u64)
    }

    /// The state of each agent.
    pub(crate) fn decode(&self, code: Code) -> Vec<usize> {
        let mut rest = code;
        let mut states: Vec<usize> = Vec::with_capacity(self.agents.len());
        for a in self.agents.iter().rev() {
            let base = a.states.len() as u64;
            states.push((rest % base) as usize);
            rest /= base;
        }
        states.reverse();
        states
    }

    /// Whether every agent has arrived for good.
    pub(crate) fn is_done(&self, states: &[usize]) -> bool {
        self.agents.iter().zip(states).all(|(a, &s)| a.is_done(s))
    }

    /// No plan from here ends in fewer steps.
    pub(crate) fn to_go(&self, states: &[usize]) -> u32 {
        let each = self.agents.iter().zip(states).map(|(a, &s)| a.to_go[s]);
        each.max().unwrap_or(0)
    }

    /// The joint states at time 0.
    pub(crate) fn first(&self) -> Vec<Code> {
        // To be somewhere at time 0 is like a step that comes from nowhere.
        let choices: Vec<Vec<Step>> = self
            .agents
            .iter()
            .map(|a| {
                let appear = |&to: &usize| Step {
                    to,
                    edge: None,
                    price: Price::default(),
                };
                a.first.iter().map(appear).collect()
            })
            .collect();
        let mut found = Vec::new();
        let choices: Vec<&[Step]> = choices.iter().map(Vec::as_slice).collect();
        self.combine(&choices, &mut Vec::new(), &mut |to, _| found.push(to));
        found
    }

    /// Calls `each` for every joint step: where it ends and what it costs.
    pub(crate) fn steps(&self, states: &[usize], mut each: impl FnMut(Code, Price)) {
        self.each_step(states, |to, price, _| each(to, price));
    }

    /// The same with the agents that charge, a bit each.
    pub(crate) fn each_step(&self, states: &[usize], mut each: impl FnMut(Code, Price, u32)) {
        self.each_of_all(states, |to, chosen| {
            let price = chosen
                .iter()
                .fold(Price::default(), |sum, step| sum.and(step.price));
            let charges = (0..chosen.len()).filter(|&i| chosen[i].price.charges > 0);
            each(to, price, charges.fold(0, |set, i| set | 1 << i));
        });
    }

    /// The same with the step of each agent.
    pub(crate) fn each_of_all(&self, states: &[usize], mut each: impl FnMut(Code, &[Step])) {
        let choices: Vec<&[Step]> = self
            .agents
            .iter()
            .zip(states)
            .map(|(a, &s)| a.steps[s].as_slice())
            .collect();
        self.combine(&choices, &mut Vec::new(), &mut each);
    }

    /// Every choice of one step for each agent in which no two collide.
    fn combine(
        &self,
        choices: &[&[Step]],
        chosen: &mut Vec<Step>,
        each: &mut impl FnMut(Code, &[Step]),
    ) {
        let a = chosen.len();
        let Some(steps) = choices.get(a) else {
            let states: Vec<usize> = chosen.iter().map(|step| step.to).collect();
            if !self.in_order(&states) {
                return;
            }
            each(self.encode(&states), chosen);
            return;
        };
        for &step in *steps {
            let free = chosen.iter().enumerate().all(|(b, other)| {
                self.ignored.contains(&(a, b))
                    || !meet(self.cell_after(a, step), self.cell_after(b, *other))
                        && !swap(step.edge, other.edge)
            });
            if free {
                chosen.push(step);
                self.combine(choices, chosen, each);
                chosen.pop();
            }
        }
    }

    /// Whether the one that must have been at a cell first has been there, if
    /// the other is there.
    fn in_order(&self, states: &[usize]) -> bool {
        let Some((first, second, cell)) = self.precedence else {
            return true;
        };
        let (a, b) = (&self.agents[first], &self.agents[second]);
        let been = a.is_done(states[first]) || a.states[states[first]].memory.done;
        been || b.occupies(states[second]) != Some(cell)
    }

    fn cell_after(&self, agent: usize, step: Step) -> Option<Cell> {
        self.agents[agent].occupies(step.to)
    }
}

/// A vertex collision: two agents at one vertex at one time. An agent in
/// transit, or one that has vanished, is at none.
fn meet(a: Option<Cell>, b: Option<Cell>) -> bool {
    a.is_some() && a == b
}

/// A swap: two agents on one edge in opposite directions in the same step. This
/// is the slow swap as well: on a slow edge each agent is for two steps, which
/// have one in common if, and only if, the agents leave less than 2 apart.
fn swap(a: Option<(Cell, Cell)>, b: Option<(Cell, Cell)>) -> bool {
    a.is_some() && a == b.map(|(u, v)| (v, u))
}
