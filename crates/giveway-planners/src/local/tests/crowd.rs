//! Agents that walk about by chance, and their collisions by the rules.

use std::collections::BTreeMap;

use fastrand::Rng;
use giveway_model::{Cell, Instance};

use crate::{
    budget::Unlimited,
    problem::Problem,
    single::{Metric, Place},
    tests::{Lone, Spot, State, random},
    walk::Walk,
};

/// An instance with a walk for each agent, made by chance; they may collide.
pub(super) struct Crowd {
    pub(super) instance: Instance,
    pub(super) problem: Problem,
    pub(super) ways: Vec<Vec<Spot>>,
    pub(super) rng: Rng,
}

impl Crowd {
    /// A crowd; `None` where an agent has no way even alone.
    pub(super) fn random(seed: u64, agents: usize) -> Option<Self> {
        let instance = random(seed, agents);
        let budget = Unlimited::default();
        let problem = Problem::new(&instance, &budget).ok()?;
        let mut rng = Rng::with_seed(seed);
        let ways = (0..agents).map(|i| wander(&instance, i, &mut rng));
        Some(Self {
            ways: ways.collect(),
            instance,
            problem,
            rng,
        })
    }

    /// Another walk of an agent.
    pub(super) fn wander(&mut self, agent: usize) -> Vec<Spot> {
        wander(&self.instance, agent, &mut self.rng)
    }

    /// The spots as the search names them.
    pub(super) fn walk(&self, way: &[Spot]) -> Walk {
        let terrain = &self.problem.terrain;
        way.iter().map(|spot| spot.place(terrain)).collect()
    }

    /// The search's places as spots.
    pub(super) fn way(&self, walk: &[Place]) -> Vec<Spot> {
        let terrain = &self.problem.terrain;
        let spot = |place: &Place| match *place {
            Place::At(v) => Spot::At(terrain.cell(v)),
            Place::Along(arc) => {
                let (u, v) = terrain.ends(arc);
                Spot::Amid(terrain.cell(u), terrain.cell(v))
            }
        };
        walk.iter().map(spot).collect()
    }

    /// The collisions of two walks, each counted by time.
    pub(super) fn collisions(&self, a: &[Spot], b: &[Spot]) -> u32 {
        let stays = self.instance.stays();
        let last = a.len().max(b.len());
        let met = |&t: &usize| at(a, t, stays).is_some() && at(a, t, stays) == at(b, t, stays);
        let mut collisions = (0..last).filter(met).count() as u32;
        for (u, v, s, steps) in moves(a) {
            for (from, to, other, _) in moves(b) {
                if (from, to) == (v, u) {
                    collisions += steps.saturating_sub(s.abs_diff(other));
                }
            }
        }
        collisions
    }

    /// The collisions of a walk with those of some agents.
    pub(super) fn met(&self, way: &[Spot], others: &[usize]) -> u32 {
        let others = others.iter();
        others
            .map(|&other| self.collisions(way, &self.ways[other]))
            .sum()
    }
}

/// Steps by chance, then a shortest way to the end.
fn wander(instance: &Instance, agent: usize, rng: &mut Rng) -> Vec<Spot> {
    let lone = Lone::new(instance, agent);
    let cost_to_go = lone.cost_to_go(Metric::Time);
    let mut choose = |state: &State, cost_to_go: &BTreeMap<State, u32>, most: u32| {
        let onward = lone.onward(state).into_iter().map(|(to, _)| to);
        let onward: Vec<State> = onward
            .filter(|to| cost_to_go.get(to).is_some_and(|&rest| rest <= most))
            .collect();
        onward[rng.usize(..onward.len())]
    };
    let mut state = lone.start().unwrap();
    let mut way = vec![state.spot];
    let detours = agent * 2;
    for _ in 0..detours {
        // A battery may leave no choice but to end.
        if lone.is_end(&state) {
            break;
        }
        state = choose(&state, &cost_to_go, u32::MAX);
        way.push(state.spot);
    }
    while !lone.is_end(&state) {
        state = choose(&state, &cost_to_go, cost_to_go[&state] - 1);
        way.push(state.spot);
    }
    way
}

/// The cell at a time; none in transit, nor after an arrival under `vanish`.
fn at(way: &[Spot], time: usize, stays: bool) -> Option<Cell> {
    let spot = match way.get(time) {
        None if stays => way.last(),
        spot => spot,
    };
    match spot {
        Some(&Spot::At(cell)) => Some(cell),
        _ => None,
    }
}

/// The moves: from, to, the time of leaving, the steps that it takes.
fn moves(way: &[Spot]) -> Vec<(Cell, Cell, u32, u32)> {
    let mut moves = Vec::new();
    for (time, pair) in (0..).zip(way.windows(2)) {
        match (pair[0], pair[1]) {
            (Spot::At(u), Spot::At(v)) if u != v => moves.push((u, v, time, 1)),
            (Spot::At(_), Spot::Amid(u, v)) => moves.push((u, v, time, 2)),
            _ => {}
        }
    }
    moves
}
