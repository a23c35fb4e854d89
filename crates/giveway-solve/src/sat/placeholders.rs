//! Why the search takes the same course on every machine.
//!
//! varisat keeps its variables in numbered places. The place of a variable that is
//! fixed for good becomes free, and the next variable that comes takes a free place:
//! whichever comes first in a hash set. Which one that is depends on how wide the
//! words of a machine are, so a browser would search in another order than the
//! command, and might find another plan.
//!
//! So no variable of a formula ever meets a choice of places. After each call,
//! variables that occur in no clause take all the places that became free, and those
//! of the formula go to the end. It makes no difference which of these placeholders
//! is in which place.

use std::cell::Cell;
#[cfg(test)]
use std::cell::RefCell;
use std::rc::Rc;

use varisat_internal_proof::ProofStep;

use super::Lit;

/// A variable with the place that it got, or that it lost its own.
#[cfg(test)]
pub(super) type Told = (u32, Option<u32>);

/// The places that became free and are not taken yet, as the proof tells them.
#[derive(Clone, Default)]
pub(super) struct Freed {
    count: Rc<Cell<u32>>,
    #[cfg(test)]
    told: Rc<RefCell<Vec<Told>>>,
}

impl Freed {
    /// Reads a step of the proof.
    pub(super) fn read(&self, step: &ProofStep) {
        if let ProofStep::SolverVarName { solver: None, .. } = step {
            self.count.set(self.count.get() + 1);
        }
        #[cfg(test)]
        if let ProofStep::SolverVarName { global, solver } = step {
            let place = solver.map(|place| place.index() as u32);
            self.told.borrow_mut().push((global.index() as u32, place));
        }
    }

    /// Takes one, if there is any.
    fn take(&self) -> bool {
        let freed = self.count.get();
        self.count.set(freed.saturating_sub(1));
        freed > 0
    }
}

/// Fills the free placeholders of one solver.
///
/// A placeholder is mentioned once, in a clause that is true: varisat drops the clause
/// and keeps the variable, as it never asks whether one has left its last clause. A
/// model gives it a value, and nothing else comes of it.
pub(super) struct Placeholders {
    freed: Freed,
    /// Holds for good, so its place becomes free with every other.
    truth: Option<Lit>,
    /// The truth has its place again since places became free.
    in_place: bool,
    #[cfg(test)]
    pub(super) in_use: bool,
}

impl Placeholders {
    pub(super) fn new(freed: Freed) -> Self {
        Self {
            freed,
            truth: None,
            in_place: false,
            #[cfg(test)]
            in_use: true,
        }
    }

    /// The events of placeholders, in order.
    #[cfg(test)]
    pub(super) fn told(&self) -> Vec<Told> {
        self.freed.told.borrow().clone()
    }

    /// The clause by which one more free place is taken; none when none is free. A new
    /// variable is the next of those that are counted.
    pub(super) fn next(&mut self, variables: &mut u32) -> Option<Vec<Lit>> {
        #[cfg(test)]
        if !self.in_use {
            return None;
        }
        if !self.freed.take() {
            self.in_place = false;
            return None;
        }
        let mut fresh = || {
            let lit = Lit::positive(*variables);
            *variables += 1;
            lit
        };
        let truth = *self.truth.get_or_insert_with(&mut fresh);
        if self.in_place {
            Some(vec![fresh(), truth])
        } else {
            self.in_place = true;
            Some(vec![truth])
        }
    }
}
