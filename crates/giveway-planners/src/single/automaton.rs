//! The conditions on one agent beside its task, as an automaton over its mask.
//!
//! What forbids or asks for places, crossings and charges is part of the agent's own
//! task: its tables, its MDD and its searches keep to it by construction, and bounds
//! of the agent alone are bounds with the conditions. What must be done sets a bit of
//! the mask, after those of the waypoints; what is counted on the way is a digit above
//! these ([`Counter`]). What costs over a whole walk (fewer moves) is a clause inside the
//! SAT solver and a check on plans found without it.

mod steps;

use std::collections::BTreeMap;

use giveway_model::{Cost, condition::Times};

use super::{Area, Counter, counter::last_of, task::Mask};
use crate::terrain::Vertex;

/// Any number of conditions on one agent.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Automaton {
    /// The forbidden acts.
    pub forbidden: Vec<Forbidden>,
    /// What is counted on the way.
    pub counters: Vec<Counter>,
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
    /// It is at one of these vertices.
    Stand(Area),
    /// It begins to cross one of these arcs, in ascending order.
    Cross(Vec<u32>),
    /// It charges at this vertex, or at any.
    Charge(Option<Vertex>),
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
    /// Something that is counted on the way.
    Counter(&'a Counter),
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
            Self::Counter(counter) => counter.last_time(),
            Self::Required(_, required) => last_of(required.times()),
            Self::Limit(Cost::Makespan, most) => Some(most),
            Self::Limit(
                Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty,
                _,
            ) => None,
        }
    }
}

/// Whether times have this one. Tables know no times, and forbid only what is
/// forbidden at all of them.
fn is_now(times: Times, now: Option<u32>) -> bool {
    now.map_or_else(|| times.are_all(), |now| times.contains(now))
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

    /// Whether it has nothing that tables know but what is forbidden, whatever was done before.
    pub(super) fn only_forbids(&self) -> bool {
        let has_no_set = self.counters.is_empty() && self.required.is_empty();
        has_no_set && self.forbidden.iter().all(|forbidden| forbidden.unless == 0)
    }

    /// Its parts; those of one kind in their order.
    pub fn parts(&self) -> impl Iterator<Item = Part<'_>> {
        let Self {
            forbidden,
            counters,
            required,
            limits,
        } = self;
        let required = required.iter().enumerate();
        let limits = limits.iter().map(|(&cost, &most)| Part::Limit(cost, most));
        let forbidden = forbidden.iter().map(Part::Forbidden);
        forbidden
            .chain(counters.iter().map(Part::Counter))
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
}
