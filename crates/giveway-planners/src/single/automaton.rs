//! What conditions ask of one agent beside its task, as an automaton over its mask.
//!
//! What forbids or asks for places, crossings and charges is part of the agent's own
//! task: its tables, its MDD and its searches keep to it by construction, and bounds
//! of the agent alone are bounds with the conditions. What must be done sets a bit of
//! the mask, after those of the waypoints. What counts over a whole walk (fewer moves,
//! no long wait) is a clause inside the SAT solver and a check on plans found without
//! it.

use std::collections::BTreeMap;

use giveway_model::{Cost, condition::Times};

use super::{Place, task::Mask};
use crate::terrain::Vertex;

/// Any number of conditions on one agent.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Automaton {
    /// What it must not do.
    pub forbidden: Vec<Forbidden>,
    /// Waits that it must not make.
    pub waits: Vec<LongWait>,
    /// What it must do; the i-th has the i-th bit after the waypoints.
    pub required: Vec<Required>,
    /// The most that it may have of some costs; the makespan is its arrival.
    pub limits: BTreeMap<Cost, u32>,
}

/// Something that an agent must not do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Forbidden {
    /// What it must not do.
    pub act: Act,
    /// When.
    pub times: Times,
    /// It may do so after one of these waypoints.
    pub unless: Mask,
}

/// What an agent may do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Act {
    /// It is at a vertex.
    Stand(Vertex),
    /// It begins to cross one of these arcs.
    Cross(Vec<u32>),
    /// It charges at this vertex, or at any.
    Charge(Option<Vertex>),
}

/// So many wait steps on end at a vertex, or anywhere, that begin within some times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LongWait {
    /// The vertex; anywhere where it is `None`.
    pub at: Option<Vertex>,
    /// When the steps begin.
    pub times: Times,
    /// The number of steps, at least 1.
    pub steps: u32,
    /// How many of them were made before time 0 already, fewer than that number.
    pub begun: u32,
}

/// Something that an agent must do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Required {
    /// It begins to cross one of these arcs within some times.
    Cross {
        /// The arcs.
        arcs: Vec<u32>,
        /// When.
        times: Times,
    },
    /// It charges at a vertex, and so leaves it.
    Charge {
        /// The vertex.
        at: Vertex,
        /// The arcs that begin there.
        leaving: Vec<u32>,
    },
}

/// Whether times have this one. Tables know no times, and forbid only what is
/// forbidden at all of them.
fn is_now(times: Times, now: Option<u32>) -> bool {
    now.map_or_else(|| times.are_all(), |now| times.contains(now))
}

/// The last time at which it matters whether times have it.
fn last_of(times: Times) -> Option<u32> {
    (!times.are_all()).then(|| times.to.unwrap_or_else(|| times.first()))
}

impl LongWait {
    /// Whether a wait step is one of those that count.
    pub fn counts(&self, at: Vertex, now: u32) -> bool {
        self.at.is_none_or(|v| v == at) && self.times.contains(now)
    }
}

impl Required {
    /// Whether beginning to cross an arc does it. Tables, which know no times, take
    /// the best case.
    fn is_done_by(&self, arc: u32, now: Option<u32>) -> bool {
        match self {
            Self::Cross { arcs, times } => {
                arcs.contains(&arc) && now.is_none_or(|now| times.contains(now))
            }
            Self::Charge { leaving, .. } => leaving.contains(&arc),
        }
    }

    /// The times at which it may be done.
    pub fn times(&self) -> Times {
        match self {
            Self::Cross { times, .. } => *times,
            Self::Charge { .. } => Times::default(),
        }
    }
}

impl Automaton {
    /// Whether there is no condition.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Adds that the agent has at most so much of a cost. Of time it has none but up to
    /// its arrival.
    pub fn limit(&mut self, cost: Cost, most: u32) {
        let cost = match cost {
            Cost::SumOfCosts => Cost::Makespan,
            cost => cost,
        };
        let limit = self.limits.entry(cost).or_insert(most);
        *limit = most.min(*limit);
    }

    /// The latest arrival that is allowed.
    pub fn not_after(&self) -> u32 {
        self.limits
            .get(&Cost::Makespan)
            .copied()
            .unwrap_or(u32::MAX)
    }

    /// The limits of what is counted on the way: charges, moves, waits.
    pub fn counted_limits(&self) -> impl Iterator<Item = (Cost, u32)> + '_ {
        let limits = self.limits.iter().map(|(&cost, &most)| (cost, most));
        limits.filter(|(cost, _)| *cost != Cost::Makespan)
    }

    /// The charges that it must make: the number of each among all that it must do, and
    /// where.
    pub fn charges(&self) -> impl Iterator<Item = (usize, Vertex)> + '_ {
        let required = self.required.iter().enumerate();
        required.filter_map(|(number, required)| match *required {
            Required::Charge { at, .. } => Some((number, at)),
            Required::Cross { .. } => None,
        })
    }

    /// Whether it must charge somewhere.
    pub fn must_charge(&self) -> bool {
        self.charges().next().is_some()
    }

    fn forbids(&self, mask: Mask, now: Option<u32>, is_it: impl Fn(&Act) -> bool) -> bool {
        self.forbidden.iter().any(|forbidden| {
            mask & forbidden.unless == 0 && is_it(&forbidden.act) && is_now(forbidden.times, now)
        })
    }

    /// Whether it may be at a vertex, the waypoints of the mask visited.
    pub fn may_stand(&self, at: Vertex, mask: Mask, now: Option<u32>) -> bool {
        !self.forbids(mask, now, |act| matches!(*act, Act::Stand(v) if v == at))
    }

    /// Whether it may begin to cross an arc.
    pub fn may_cross(&self, arc: u32, now: Option<u32>) -> bool {
        !self.forbids(
            0,
            now,
            |act| matches!(act, Act::Cross(arcs) if arcs.contains(&arc)),
        )
    }

    /// Whether it may charge at a charger.
    pub fn may_charge(&self, at: Vertex, now: Option<u32>) -> bool {
        !self.forbids(
            0,
            now,
            |act| matches!(*act, Act::Charge(v) if v.is_none_or(|v| v == at)),
        )
    }

    /// Whether it may wait a step at a vertex; long waits are counted elsewhere.
    pub fn may_wait(&self, at: Vertex, now: u32) -> bool {
        !self
            .waits
            .iter()
            .any(|wait| wait.steps == 1 && wait.counts(at, now))
    }

    /// The required acts that beginning to cross an arc fulfils, as bits from 0 on.
    pub fn done_by(&self, arc: u32, now: Option<u32>) -> Mask {
        let required = self.required.iter().zip(0..);
        let done = required.filter(|(required, _)| required.is_done_by(arc, now));
        done.fold(0, |bits, (_, number)| bits | 1 << number)
    }

    /// What must be done before this time, as bits from 0 on.
    pub fn due(&self, now: u32) -> Mask {
        let required = self.required.iter().zip(0..);
        let due = required.filter(|(required, _)| required.times().last() < now);
        due.fold(0, |bits, (_, number)| bits | 1 << number)
    }

    /// The last time that a condition on places, moves and charges is about, where one
    /// is about some.
    pub fn last_time_of_ways(&self) -> Option<u32> {
        let forbidden = self.forbidden.iter().map(|forbidden| forbidden.times);
        let required = self.required.iter().map(Required::times);
        forbidden.chain(required).filter_map(last_of).max()
    }

    /// The same of all conditions on what it does on its way.
    pub fn last_time_of_steps(&self) -> Option<u32> {
        let waits = self.waits.iter().filter_map(|wait| last_of(wait.times));
        waits.chain(self.last_time_of_ways()).max()
    }

    /// The same of all conditions.
    pub fn last_time(&self) -> Option<u32> {
        let arrival = self.limits.get(&Cost::Makespan).copied();
        arrival.max(self.last_time_of_steps())
    }

    /// The lengths of the waits that it must not have at time 0.
    pub fn first_runs(&self) -> Vec<u32> {
        self.waits.iter().map(|wait| wait.begun).collect()
    }

    /// The lengths of the waits that it must not have, as they are after a step, if it
    /// may take it.
    pub fn runs(&self, runs: &[u32], from: Place, to: Place, now: u32) -> Option<Vec<u32>> {
        let run = |(wait, run): (&LongWait, &u32)| {
            let counts = matches!(from, Place::At(v) if from == to && wait.counts(v, now));
            let run = if counts { run + 1 } else { 0 };
            (run < wait.steps).then_some(run)
        };
        self.waits.iter().zip(runs).map(run).collect()
    }

    /// Whether the agent has to be inside the SAT solver: plans made outside
    /// keep the conditions by chance only.
    pub fn needs_solver(&self) -> bool {
        let no_charge = |it: &Forbidden| matches!(it.act, Act::Charge(_));
        self.waits.iter().any(|wait| wait.steps > 1)
            || self.counted_limits().next().is_some()
            || self.must_charge() && self.forbidden.iter().any(no_charge)
    }

    /// Whether a walk has none of the waits that it must not have.
    pub fn keeps_waits(&self, walk: &[Place]) -> bool {
        let mut runs = Some(self.first_runs());
        self.waits.is_empty()
            || walk.windows(2).zip(0..).all(|(pair, time)| {
                let before = runs.take().unwrap_or_default();
                runs = self.runs(&before, pair[0], pair[1], time);
                runs.is_some()
            })
    }

    /// The number of counts by which the conditions tell one way from another, costs
    /// apart.
    pub fn counts(&self) -> usize {
        let waits = self.waits.iter().map(|wait| wait.steps as usize);
        let waits = waits.map(|steps| steps.saturating_add(1));
        let charges = self.charges().map(|_| 2);
        waits.chain(charges).fold(1, usize::saturating_mul)
    }
}
