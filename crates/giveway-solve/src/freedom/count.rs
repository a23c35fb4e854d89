//! How many best plans there are, and the ways that each agent can choose from.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    Known, PlanCount, Plans, Step, Ways,
    every::Every,
    formula::{Way, names},
};
use crate::{
    budget::Stop,
    sat::{Clauses, Lit},
    single::Place,
};

/// The ways of one agent up to which is counted where plans are too many.
const MOST_WAYS: u32 = 100;
/// Steps of one agent beyond which it is not proved that there are no others.
const MOST_STEPS: usize = 20_000;

/// The count, as far as it is known.
pub(super) struct Count {
    limit: u32,
    plans: Counted,
    ways: Vec<Counted>,
    steps: Vec<Known>,
}

/// How counting ended.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Counted {
    /// It was cut off.
    Open,
    /// There are no others.
    All,
    /// There are more than were to be counted: this many.
    More(u32),
}

impl Counted {
    fn of(self, found: usize) -> PlanCount {
        match self {
            Self::Open => PlanCount::AtLeast(found as u32),
            Self::All => PlanCount::Exactly(found as u32),
            Self::More(limit) => PlanCount::MoreThan(limit),
        }
    }
}

impl Count {
    /// Nothing is known yet.
    pub(super) fn new(every: &Every, limit: u32) -> Self {
        let agents = every.own().len();
        Self {
            limit,
            plans: Counted::Open,
            ways: vec![Counted::Open; agents],
            steps: vec![Known::Open; agents],
        }
    }

    /// Whether all best plans were found.
    pub(super) fn is_exact(&self) -> bool {
        self.plans == Counted::All
    }

    /// Settles all of it.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn settle(&mut self, every: &mut Every) -> Result<(), Stop> {
        self.plans = enumerate(every, self.limit)?;
        if self.is_exact() {
            self.ways.fill(Counted::All);
            self.steps.fill(Known::Yes);
            return Ok(());
        }
        for agent in 0..self.ways.len() {
            self.ways[agent] = enumerate_ways(every, agent, self.limit.min(MOST_WAYS))?;
            if self.ways[agent] == Counted::All || all_steps(every, agent)? {
                self.steps[agent] = Known::Yes;
            }
        }
        Ok(())
    }

    /// What is known.
    pub(super) fn told(&self, every: &Every) -> Plans {
        let mut ways = BTreeMap::new();
        for (agent, name) in names(every.instance).into_iter().enumerate() {
            let known = self.steps.get(agent).copied();
            let counted = self.ways.get(agent).copied().unwrap_or(Counted::Open);
            let steps = steps(every, agent).into_iter();
            let cell = |v| every.problem.terrain.cell(v);
            let told = Ways {
                number: counted.of(own_ways(every, agent).len()),
                steps: steps
                    .map(|(time, from, to)| Step {
                        time,
                        from: cell(from),
                        to: cell(to),
                    })
                    .collect(),
                all: known.unwrap_or(Known::Open),
            };
            ways.insert(name, told);
        }
        Plans {
            number: self.plans.of(every.found().len()),
            ways,
        }
    }
}

/// Finds best plans until there are no others, or more than a number.
fn enumerate(every: &mut Every, limit: u32) -> Result<Counted, Stop> {
    let blocked = every.formula.fresh();
    let mut next = 0;
    loop {
        while let Some(plan) = every.found().get(next).cloned() {
            if next as u32 >= limit {
                every.formula.retire(blocked);
                return Ok(Counted::More(limit));
            }
            let marks = every.marks(&plan);
            let others = marks.into_iter().map(|lit| !lit);
            every.formula.under(blocked, others);
            next += 1;
        }
        if !every.find(&[blocked])? {
            every.formula.retire(blocked);
            return Ok(Counted::All);
        }
    }
}

/// Finds the ways of one agent in best plans, until there are no others, or more than
/// a number.
fn enumerate_ways(every: &mut Every, agent: usize, limit: u32) -> Result<Counted, Stop> {
    let blocked = every.formula.fresh();
    let mut known: BTreeSet<Way> = BTreeSet::new();
    loop {
        for way in own_ways(every, agent) {
            if known.contains(&way) {
                continue;
            }
            if known.len() as u32 >= limit {
                every.formula.retire(blocked);
                return Ok(Counted::More(limit));
            }
            let marks = every.formula.marks(agent, &way).into_iter();
            every.formula.under(blocked, marks.map(|lit| !lit));
            known.insert(way);
        }
        if !every.find(&[blocked])? {
            every.formula.retire(blocked);
            return Ok(Counted::All);
        }
    }
}

/// The ways of an agent in the plans that were found.
fn own_ways(every: &Every, agent: usize) -> BTreeSet<Way> {
    let plans = every.found().iter();
    plans.filter_map(|plan| plan.get(agent)).cloned().collect()
}

/// A step between two vertices, begun at a time.
type Taken = (u32, u32, u32);

/// The steps of an agent in the plans that were found.
fn steps(every: &Every, agent: usize) -> BTreeSet<Taken> {
    let mut steps = BTreeSet::new();
    for way in every.found().iter().filter_map(|plan| plan.get(agent)) {
        for (time, place) in way.places.iter().enumerate() {
            let to = match way.places.get(time + 1) {
                Some(&Place::At(to)) => to,
                Some(&Place::Along(arc)) => every.problem.terrain.ends(arc).1,
                None => continue,
            };
            if let Place::At(from) = *place {
                steps.insert((time as u32, from, to));
            }
        }
    }
    steps
}

/// Finds plans with steps of an agent that no plan had before, until there are none;
/// false where there are too many to ask about.
fn all_steps(every: &mut Every, agent: usize) -> Result<bool, Stop> {
    let possible = possible_steps(every, agent);
    if possible.len() > MOST_STEPS {
        return Ok(false);
    }
    let mut open: BTreeMap<Taken, Lit> = BTreeMap::new();
    let taken = steps(every, agent);
    for (step, [here, there, arrived]) in possible {
        if taken.contains(&step) {
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
        for step in steps(every, agent) {
            open.remove(&step);
        }
    }
    Ok(true)
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
