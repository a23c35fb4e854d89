//! What the parts of an automaton allow, and what they note of a step.

use giveway_model::{Cost, constraint::Heading};

use super::{Act, Automaton, Counter, Part, Required, is_now};
use crate::single::{
    Turns,
    counter::Passage,
    task::{COUNTS, Mask},
};
use crate::terrain::Vertex;

impl Automaton {
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
