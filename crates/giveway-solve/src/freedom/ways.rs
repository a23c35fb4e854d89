//! The ways that each agent can choose from in best plans, and all their steps.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    Known, Step, Ways,
    count::CountStep,
    every::Every,
    formula::{Way, names},
};
use crate::{
    budget::Stop,
    sat::{Clauses, Lit},
    single::Place,
};

/// The ways of one agent up to which is counted.
const MOST_WAYS: u32 = 100;
/// Steps of one agent beyond which it is not proved that there are no others.
const MOST_STEPS: usize = 20_000;

/// A step between two vertices, begun at a time.
type Taken = (u32, u32, u32);

/// The ways of one agent.
struct Choice {
    ways: BTreeSet<Way>,
    steps: BTreeSet<Taken>,
    counted: CountStep,
    /// Whether the steps are all that there are.
    all: Known,
}

/// The ways of all agents.
pub(super) struct Choices {
    agents: Vec<Choice>,
    /// Plans that were looked at.
    seen: usize,
}

impl Choices {
    /// Nothing but the plans that were found.
    pub(super) fn new(every: &Every) -> Self {
        let none = |_: &Way| Choice {
            ways: BTreeSet::new(),
            steps: BTreeSet::new(),
            counted: CountStep::Open,
            all: Known::Open,
        };
        let mut choices = Self {
            agents: every.own().iter().map(none).collect(),
            seen: 0,
        };
        choices.learn(every);
        choices
    }

    /// All best plans were found, so that nothing is open.
    pub(super) fn close(&mut self, every: &Every) {
        self.learn(every);
        for choice in &mut self.agents {
            choice.counted = CountStep::All;
            choice.all = Known::Yes;
        }
    }

    /// Settles all of it; ways are counted up to a number.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn settle(&mut self, every: &mut Every, limit: u32) -> Result<(), Stop> {
        for agent in 0..self.agents.len() {
            let counted = self.count(every, agent, limit.min(MOST_WAYS))?;
            let all = counted == CountStep::All || self.all_steps(every, agent)?;
            if let Some(choice) = self.agents.get_mut(agent) {
                choice.counted = counted;
                if all {
                    choice.all = Known::Yes;
                }
            }
        }
        Ok(())
    }

    /// The ways by the agents' names, as far as they are known.
    pub(super) fn told(&self, every: &Every) -> BTreeMap<String, Ways> {
        let cell = |v| every.problem.terrain.cell(v);
        let step = |&(time, from, to): &Taken| Step {
            time,
            from: cell(from),
            to: cell(to),
        };
        let names = names(every.instance).into_iter();
        let each = names.zip(&self.agents).map(|(name, choice)| {
            let ways = Ways {
                number: choice.counted.of(choice.ways.len()),
                steps: choice.steps.iter().map(step).collect(),
                all: choice.all,
            };
            (name, ways)
        });
        each.collect()
    }

    /// Takes in the plans that were found since.
    pub(super) fn learn(&mut self, every: &Every) {
        for plan in every.found().iter().skip(self.seen) {
            for (choice, way) in self.agents.iter_mut().zip(plan) {
                if choice.ways.insert(way.clone()) {
                    choice.steps.extend(steps(every, way));
                }
            }
        }
        self.seen = every.found().len();
    }

    /// Finds the ways of one agent in best plans, until there are no others, or more
    /// than a number.
    fn count(&mut self, every: &mut Every, agent: usize, limit: u32) -> Result<CountStep, Stop> {
        let mut blocked = None;
        let mut done: BTreeSet<Way> = BTreeSet::new();
        let counted = loop {
            self.learn(every);
            let known = self.agents.get(agent).map(|choice| &choice.ways);
            let known = known.into_iter().flatten();
            let new: Vec<Way> = known.filter(|way| !done.contains(way)).cloned().collect();
            if (done.len() + new.len()) as u64 > u64::from(limit) {
                break CountStep::More(limit);
            }
            let selector = *blocked.get_or_insert_with(|| every.formula.fresh());
            for way in new {
                let marks = every.formula.marks(agent, &way).into_iter();
                every.formula.under(selector, marks.map(|lit| !lit));
                done.insert(way);
            }
            if !every.find(&[selector])? {
                break CountStep::All;
            }
        };
        if let Some(selector) = blocked {
            every.formula.retire(selector);
        }
        Ok(counted)
    }

    /// Finds plans with steps of an agent that no plan had before, until there are
    /// none; false where there are too many to ask about.
    fn all_steps(&mut self, every: &mut Every, agent: usize) -> Result<bool, Stop> {
        let possible = possible_steps(every, agent);
        if possible.len() > MOST_STEPS {
            return Ok(false);
        }
        let mut open: BTreeMap<Taken, Lit> = BTreeMap::new();
        for (step, [here, there, arrived]) in possible {
            if self.takes(agent, step) {
                continue;
            }
            let takes = every.formula.fresh();
            for lit in [here, there, !arrived] {
                every.formula.clauses().clause(&[!takes, lit]);
            }
            open.insert(step, takes);
        }
        while !open.is_empty() {
            let another = every.formula.some(open.values().copied());
            let is_found = every.find(&[another])?;
            every.formula.retire(another);
            if !is_found {
                return Ok(true);
            }
            self.learn(every);
            open.retain(|&step, _| !self.takes(agent, step));
        }
        Ok(true)
    }

    fn takes(&self, agent: usize, step: Taken) -> bool {
        let choice = self.agents.get(agent);
        choice.is_some_and(|choice| choice.steps.contains(&step))
    }
}

/// The steps of a way.
fn steps(every: &Every, way: &Way) -> Vec<Taken> {
    let mut steps = Vec::new();
    for (time, place) in way.places.iter().enumerate() {
        let to = match way.places.get(time + 1) {
            Some(&Place::At(to)) => to,
            Some(&Place::Along(arc)) => every.problem.terrain.ends(arc).1,
            None => continue,
        };
        if let Place::At(from) = *place {
            steps.push((time as u32, from, to));
        }
    }
    steps
}

/// The steps that the layers of an agent allow: where it is before and after, and that
/// it has arrived before.
fn possible_steps(every: &Every, agent: usize) -> Vec<(Taken, [Lit; 3])> {
    let mut possible = Vec::new();
    let formula = &every.formula;
    let terrain = &every.problem.terrain;
    for time in 0..formula.cap(agent) {
        for place in formula.places(agent, time) {
            let Place::At(from) = place else { continue };
            let here = formula.at(agent, time, place);
            let wait = std::iter::once((place, from));
            let moves = terrain.arcs(from).iter().map(|arc| {
                let next = if arc.slow {
                    Place::Along(arc.id)
                } else {
                    Place::At(arc.to)
                };
                (next, arc.to)
            });
            for (next, to) in wait.chain(moves) {
                if let (Some(here), Some(there)) = (here, formula.at(agent, time + 1, next)) {
                    let arrived = formula.by(agent, time);
                    possible.push(((time, from, to), [here, there, arrived]));
                }
            }
        }
    }
    possible
}
