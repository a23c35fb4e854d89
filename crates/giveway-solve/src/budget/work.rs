//! Work: how much a search has done, in a unit that needs no clock.
//!
//! A unit is one state that a planner, a table, local search or an encoding looks at.
//! Everything else weighs about as many units as it takes of the time of one state. The
//! weights are whole numbers and the same on every machine, so a limit of work ends a
//! search at the same place natively and in a browser.

use std::cell::Cell;

/// A clause that is given to the SAT solver.
pub(super) const CLAUSE: u64 = 1;
/// A clause that the SAT solver derives: learnt from a conflict, or rewritten. Local search
/// has as many states for each, to get its share of the time (`search/stage/polish.rs`).
pub(super) const DERIVED: u64 = 60;
/// A call of the SAT solver, for each so many variables.
pub(super) const VARIABLES_PER_UNIT: u64 = 8;

/// Units between two looks at the clock.
const LOOK_INTERVAL: u64 = 1024;

/// The work of one request, or of a part of one, and its limit.
pub(super) struct Work {
    most: u64,
    /// Units up to the next look at the limits.
    until_look: Cell<u64>,
    /// Units up to that look, those that are still to come included.
    at_look: Cell<u64>,
}

impl Work {
    /// Nothing done yet; `None` for no limit.
    pub(super) fn new(most: Option<u64>) -> Self {
        let most = most.unwrap_or(u64::MAX);
        let first = most.min(LOOK_INTERVAL);
        Self {
            most,
            until_look: Cell::new(first),
            at_look: Cell::new(first),
        }
    }

    /// The units so far.
    pub(super) fn spent(&self) -> u64 {
        self.at_look.get() - self.until_look.get()
    }

    /// The units that are left, where they are limited.
    pub(super) fn left(&self) -> Option<u64> {
        (self.most < u64::MAX).then(|| self.most.saturating_sub(self.spent()))
    }

    /// Whether the limit is passed.
    pub(super) fn is_over(&self) -> bool {
        self.spent() > self.most
    }

    /// Counts units; whether it is time to look at the limits.
    pub(super) fn spend(&self, units: u64) -> bool {
        let left = self.until_look.get();
        if units <= left {
            self.until_look.set(left - units);
            return false;
        }
        let spent = self.spent().saturating_add(units);
        let next = self.most.saturating_sub(spent).min(LOOK_INTERVAL);
        self.at_look.set(spent.saturating_add(next));
        self.until_look.set(next);
        true
    }

    /// Counts units where nobody can stop; the next state looks at the limits if it is
    /// time.
    pub(super) fn add(&self, units: u64) {
        let left = self.until_look.get();
        self.until_look.set(left.saturating_sub(units));
        let beyond = units.saturating_sub(left);
        self.at_look.set(self.at_look.get().saturating_add(beyond));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_counts_once() {
        let work = Work::new(None);
        let mut spent = 0;
        for units in [1, 5, 1023, 1, 4000, 0, 7, 1024] {
            work.spend(units);
            work.add(2 * units);
            spent += 3 * units;
            assert_eq!(work.spent(), spent);
        }
        assert_eq!(work.left(), None);
    }

    #[test]
    fn the_limit_is_seen_at_the_very_unit() {
        for most in [0, 1, 1023, 1024, 1025, 5000] {
            let work = Work::new(Some(most));
            let mut states = 0;
            while !(work.spend(1) && work.is_over()) {
                states += 1;
            }
            assert_eq!((states, work.left()), (most, Some(0)));
        }
    }

    #[test]
    fn the_limits_are_looked_at_even_where_most_work_cannot_stop() {
        let work = Work::new(None);
        let looks = (0..10_000).filter(|_| {
            work.add(50);
            work.spend(1)
        });
        assert!(looks.count() > 400);
    }
}
