//! The conditions on one agent beside its task, as an automaton over its mask.
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
    /// The forbidden acts.
    pub forbidden: Vec<Forbidden>,
    /// Waits that it must not make.
    pub waits: Vec<LongWait>,
    /// The required acts; the i-th has the i-th bit after the waypoints.
    pub required: Vec<Required>,
    /// The most that it may have of some costs; the makespan is its arrival.
    pub limits: BTreeMap<Cost, u32>,
}

/// Something that an agent must not do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Forbidden {
    /// The forbidden act.
    pub act: Act,
    /// When.
    pub times: Times,
    /// It may do so after one of these waypoints.
    pub unless: Mask,
}

/// An act of an agent.
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

/// One part of an automaton: an interpreter of conditions is a match over these.
#[derive(Clone, Copy, Debug)]
pub enum Part<'a> {
    /// Something that it must not do.
    Forbidden(&'a Forbidden),
    /// A wait that it must not make.
    LongWait(&'a LongWait),
    /// Something that it must do, and its number.
    Required(usize, &'a Required),
    /// The most that it may have of a cost.
    Limit(Cost, u32),
}

impl Part<'_> {
    /// The last time that it is about, where it is about some.
    fn last_time(self) -> Option<u32> {
        match self {
            Self::Forbidden(forbidden) => last_of(forbidden.times),
            Self::LongWait(wait) => last_of(wait.times),
            Self::Required(_, required) => last_of(required.times()),
            Self::Limit(Cost::Makespan, most) => Some(most),
            Self::Limit(Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits, _) => None,
        }
    }
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

    /// The number of steps waited so far, after one more step.
    pub fn count(&self, waited: u32, from: Place, to: Place, now: u32) -> u32 {
        match from {
            Place::At(v) if from == to && self.counts(v, now) => waited + 1,
            Place::At(_) | Place::Along(_) => 0,
        }
    }

    /// Whether a walk does not have it.
    pub fn is_kept(&self, walk: &[Place]) -> bool {
        let mut waited = self.begun;
        walk.windows(2).zip(0..).all(|(pair, now)| {
            waited = self.count(waited, pair[0], pair[1], now);
            waited < self.steps
        })
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

    /// Its parts; those of one kind in their order.
    pub fn parts(&self) -> impl Iterator<Item = Part<'_>> {
        let Self {
            forbidden,
            waits,
            required,
            limits,
        } = self;
        let required = required.iter().enumerate();
        let limits = limits.iter().map(|(&cost, &most)| Part::Limit(cost, most));
        let forbidden = forbidden.iter().map(Part::Forbidden);
        forbidden
            .chain(waits.iter().map(Part::LongWait))
            .chain(required.map(|(number, it)| Part::Required(number, it)))
            .chain(limits)
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
        !self.forbids(mask, now, |act| match act {
            Act::Stand(v) => *v == at,
            Act::Cross(_) | Act::Charge(_) => false,
        })
    }

    /// Whether it may begin to cross an arc.
    pub fn may_cross(&self, arc: u32, now: Option<u32>) -> bool {
        !self.forbids(0, now, |act| match act {
            Act::Cross(arcs) => arcs.contains(&arc),
            Act::Stand(_) | Act::Charge(_) => false,
        })
    }

    /// Whether it may charge at a charger.
    pub fn may_charge(&self, at: Vertex, now: Option<u32>) -> bool {
        !self.forbids(0, now, |act| match act {
            Act::Charge(v) => v.is_none_or(|v| v == at),
            Act::Stand(_) | Act::Cross(_) => false,
        })
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

    /// The required acts that are due before this time, as bits from 0 on.
    pub fn due(&self, now: u32) -> Mask {
        self.parts().fold(0, |bits, part| match part {
            Part::Required(number, required) if required.times().last() < now => bits | 1 << number,
            Part::Required(..) | Part::Forbidden(_) | Part::LongWait(_) | Part::Limit(..) => bits,
        })
    }

    /// The last time that a condition on places, moves and charges is about, where one
    /// is about some.
    pub fn last_time_of_ways(&self) -> Option<u32> {
        let ways = self.parts().filter(|part| match part {
            Part::Forbidden(_) | Part::Required(..) => true,
            Part::LongWait(_) | Part::Limit(..) => false,
        });
        ways.filter_map(Part::last_time).max()
    }

    /// The same of all conditions on what it does on its way.
    pub fn last_time_of_steps(&self) -> Option<u32> {
        let steps = self.parts().filter(|part| match part {
            Part::Forbidden(_) | Part::Required(..) | Part::LongWait(_) => true,
            Part::Limit(..) => false,
        });
        steps.filter_map(Part::last_time).max()
    }

    /// The same of all conditions.
    pub fn last_time(&self) -> Option<u32> {
        self.parts().filter_map(Part::last_time).max()
    }

    /// The lengths of the waits that it must not have at time 0.
    pub fn first_runs(&self) -> Vec<u32> {
        self.waits.iter().map(|wait| wait.begun).collect()
    }

    /// The lengths of the waits that it must not have, as they are after a step, if it
    /// may take it.
    pub fn runs(&self, runs: &[u32], from: Place, to: Place, now: u32) -> Option<Vec<u32>> {
        let run = |(wait, &run): (&LongWait, &u32)| {
            let run = wait.count(run, from, to, now);
            (run < wait.steps).then_some(run)
        };
        self.waits.iter().zip(runs).map(run).collect()
    }

    /// Whether the agent has to be inside the SAT solver: plans made outside
    /// keep the conditions by chance only.
    pub fn needs_solver(&self) -> bool {
        self.parts().any(|part| match part {
            Part::Forbidden(forbidden) => match forbidden.act {
                Act::Charge(_) => self.must_charge(),
                Act::Stand(_) | Act::Cross(_) => false,
            },
            Part::LongWait(wait) => wait.steps > 1,
            Part::Required(..) => false,
            Part::Limit(cost, _) => cost != Cost::Makespan,
        })
    }

    /// The number of counts by which the conditions tell one way from another, costs
    /// apart.
    pub fn counts(&self) -> usize {
        let counts = self.parts().map(|part| match part {
            Part::LongWait(wait) => (wait.steps as usize).saturating_add(1),
            Part::Required(_, Required::Charge { .. }) => 2,
            Part::Required(_, Required::Cross { .. }) | Part::Forbidden(_) | Part::Limit(..) => 1,
        });
        counts.fold(1, usize::saturating_mul)
    }
}
