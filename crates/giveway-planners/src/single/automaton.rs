//! The conditions on one agent beside its task, as an automaton over its mask.
//!
//! What forbids or asks for places, crossings and charges is part of the agent's own
//! task: its tables, its MDD and its searches keep to it by construction, and bounds
//! of the agent alone are bounds with the conditions. What must be done sets a bit of
//! the mask, after those of the waypoints; what is counted on the way is a digit above
//! these ([`Counter`]). What costs over a whole walk (fewer moves) is a clause inside the
//! SAT solver and a check on plans found without it.

use std::collections::BTreeMap;

use giveway_model::{Cost, condition::Times, constraint::Heading};

use super::{
    Area, Counter, Turns,
    counter::{Passage, last_of},
    task::{COUNTS, Mask},
};
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

    fn forbids(&self, mask: Mask, now: Option<u32>, is_it: impl Fn(&Act) -> bool) -> bool {
        self.forbidden.iter().any(|forbidden| {
            mask & forbidden.unless == 0 && is_it(&forbidden.act) && is_now(forbidden.times, now)
        })
    }

    /// Whether it may be at a vertex, the waypoints of the mask visited.
    pub fn may_stand(&self, at: Vertex, mask: Mask, now: Option<u32>) -> bool {
        !self.forbids(mask, now, |act| match act {
            Act::Stand(area) => area.has(at),
            Act::Cross(_) | Act::Charge(_) => false,
        })
    }

    /// Whether it may begin to cross an arc.
    pub fn may_cross(&self, arc: u32, now: Option<u32>) -> bool {
        !self.forbids(0, now, |act| match act {
            Act::Cross(arcs) => arcs.binary_search(&arc).is_ok(),
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
            Part::Required(..) | Part::Forbidden(_) | Part::Counter(_) | Part::Limit(..) => bits,
        })
    }

    /// The last time that a condition is about, where one is about some.
    pub fn last_time(&self) -> Option<u32> {
        self.parts().filter_map(Part::last_time).max()
    }

    /// The last time that a condition on what it does on its way is about.
    pub fn last_time_of_ways(&self) -> Option<u32> {
        let ways = self.parts().filter(|part| match part {
            Part::Forbidden(_) | Part::Required(..) | Part::Counter(_) => true,
            Part::Limit(..) => false,
        });
        ways.filter_map(Part::last_time).max()
    }

    /// Whether tables tell all about its ways: none is about times, and nothing is counted.
    pub fn is_in_tables(&self) -> bool {
        self.counters.is_empty() && self.last_time_of_ways().is_none()
    }

    /// The counts at time 0 of an agent at a vertex, or in transit; `None` where being there
    /// is forbidden.
    pub fn first_counts(&self, at: Option<Vertex>) -> Option<Mask> {
        self.counted(0, |counter, _| counter.first(at))
    }

    /// The counts of a mask after a time step; `None` where the step is forbidden.
    pub fn count(&self, mask: Mask, passage: Passage) -> Option<Mask> {
        self.counted(mask, |counter, count| counter.next(count, passage))
    }

    /// A mask whose counts become other ones, digit by digit; `None` where one of them is none.
    pub(crate) fn counted(
        &self,
        mask: Mask,
        mut next: impl FnMut(&Counter, u32) -> Option<u32>,
    ) -> Option<Mask> {
        let (mut before, mut unit) = (mask >> COUNTS, 1);
        let mut after = mask & ((1 << COUNTS) - 1);
        for counter in &self.counters {
            let size = Mask::from(counter.size());
            let count = next(counter, (before % size) as u32)?;
            before /= size;
            after += (Mask::from(count) * unit) << COUNTS;
            unit *= size;
        }
        Some(after)
    }

    /// Each counter with its count in a mask.
    pub fn counts_in(&self, mask: Mask) -> impl Iterator<Item = (&Counter, u32)> {
        let mut rest = mask >> COUNTS;
        self.counters.iter().map(move |counter| {
            let size = Mask::from(counter.size());
            let count = (rest % size) as u32;
            rest /= size;
            (counter, count)
        })
    }

    /// Whether the counts of a mask allow it to arrive at a vertex at a time.
    pub fn may_end(&self, mask: Mask, v: Vertex, now: u32) -> bool {
        self.counters.is_empty()
            || self
                .counts_in(mask)
                .all(|(counter, count)| counter.may_end(count, v, now))
    }

    /// The steps that it still has to stand somewhere, as the counts of a mask show. Turns
    /// are in the tables, and it may turn while it stands.
    pub fn still_to_stand(&self, mask: Mask) -> u32 {
        if self.turns().is_some() {
            return 0;
        }
        let left = self
            .counts_in(mask)
            .map(|(counter, count)| counter.still_to_stand(count));
        left.max().unwrap_or(0)
    }

    /// The turns that take time.
    pub fn turns(&self) -> Option<&Turns> {
        self.counters.iter().find_map(|counter| match counter {
            Counter::Turns(turns) => Some(turns),
            _ => None,
        })
    }

    /// Where it faces, and how long it has stood, where turns take time.
    pub fn facing(&self, mask: Mask) -> Option<(Option<Heading>, u32)> {
        self.turns()?; // (most agents need no look at their counts)
        self.counts_in(mask)
            .find_map(|(counter, count)| match counter {
                Counter::Turns(turns) => Some(turns.facing(count)),
                _ => None,
            })
    }

    /// Whether masks can hold all counts.
    pub fn fits_into_masks(&self) -> bool {
        let mut sizes = self
            .counters
            .iter()
            .map(|counter| Mask::from(counter.size()));
        let all = sizes.try_fold(1, Mask::checked_mul);
        all.is_some_and(|all| all < 1 << (Mask::BITS - COUNTS))
    }

    /// Whether the agent has to be inside the SAT solver: plans made outside
    /// keep the conditions by chance only.
    pub fn needs_solver(&self) -> bool {
        self.parts().any(|part| match part {
            Part::Forbidden(forbidden) => match forbidden.act {
                Act::Charge(_) => self.must_charge(),
                Act::Stand(_) | Act::Cross(_) => false,
            },
            Part::Counter(_) | Part::Required(..) => false,
            Part::Limit(cost, _) => cost != Cost::Makespan,
        })
    }

    /// The number of counts by which the conditions tell one way from another, costs
    /// apart.
    pub fn counts(&self) -> usize {
        let counts = self.parts().map(|part| match part {
            Part::Counter(counter) => counter.size() as usize,
            Part::Required(_, Required::Charge { .. }) => 2,
            Part::Required(_, Required::Cross { .. }) | Part::Forbidden(_) | Part::Limit(..) => 1,
        });
        counts.fold(1, usize::saturating_mul)
    }
}
