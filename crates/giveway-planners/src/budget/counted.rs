//! A part of a budget, measured by how often it is asked.

use std::cell::Cell;

use super::{Budget, HeldBytes, Stop};

/// A budget that counts how often it is asked, about once for each state that is
/// looked at, and says no after so many times. That needs no clock, so the same
/// search is cut off at the same place.
pub(crate) struct CountedBudget<'a> {
    budget: &'a dyn Budget,
    most: u64,
    states: Cell<u64>,
}

impl<'a> CountedBudget<'a> {
    pub(crate) const fn new(budget: &'a dyn Budget, most: u64) -> Self {
        Self {
            budget,
            most,
            states: Cell::new(0),
        }
    }

    /// The states so far.
    pub(crate) const fn states(&self) -> u64 {
        self.states.get()
    }

    /// Counts states that were looked at without asking.
    pub(crate) fn count(&self, states: u64) {
        self.states.set(self.states.get().saturating_add(states));
    }

    fn is_spent(&self) -> Result<(), Stop> {
        if self.states.get() > self.most {
            return Err(Stop::Conflicts);
        }
        Ok(())
    }
}

impl Budget for CountedBudget<'_> {
    fn check(&self) -> Result<(), Stop> {
        self.is_spent()?;
        self.budget.check()
    }

    fn tick(&self) -> Result<(), Stop> {
        self.count(1);
        self.is_spent()?;
        self.budget.tick()
    }

    fn spend(&self, states: u64) -> Result<(), Stop> {
        self.is_spent()?;
        self.budget.spend(states)
    }

    fn held_bytes(&self) -> &HeldBytes {
        self.budget.held_bytes()
    }
}
