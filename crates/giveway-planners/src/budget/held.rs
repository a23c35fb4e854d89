//! RAII accounting of memory.

use std::cell::Cell;
use std::rc::Rc;

/// The bytes that all parts of a request hold together.
pub type HeldBytes = Rc<Cell<u64>>;

/// The bytes that one thing holds: counted from its making until it is dropped.
#[derive(Default)]
pub struct MemoryUse {
    bytes: u64,
    of: Option<HeldBytes>,
}

impl MemoryUse {
    /// Bytes held from now on.
    pub fn new(of: &HeldBytes, bytes: usize) -> Self {
        let mut held = Self::default();
        held.more(of, bytes);
        held
    }

    /// Further bytes of the same request.
    pub fn more(&mut self, of: &HeldBytes, bytes: usize) {
        let bytes = bytes as u64;
        let of = self.of.get_or_insert_with(|| Rc::clone(of));
        of.set(of.get().saturating_add(bytes));
        self.bytes = self.bytes.saturating_add(bytes);
    }

    /// Some of them are free already.
    pub fn less(&mut self, bytes: usize) {
        let bytes = self.bytes.min(bytes as u64);
        self.bytes -= bytes;
        if let Some(of) = &self.of {
            of.set(of.get().saturating_sub(bytes));
        }
    }
}

impl Drop for MemoryUse {
    fn drop(&mut self) {
        if let Some(of) = &self.of {
            of.set(of.get().saturating_sub(self.bytes));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        budget::{Budget, Unlimited},
        problem::Problem,
        single::Mdd,
        tests::instance,
    };

    #[test]
    fn tables_and_diagrams_are_counted_while_they_are_there() {
        let budget = Unlimited::default();
        let problem = Problem::new(&instance("a . . . A"), &budget).ok().unwrap();
        let tables = budget.held_bytes().get();
        assert!(tables > 0);
        let mut mdd = Mdd::new(&problem.tasks[0], problem.optima[0]);
        let (task, terrain) = (&problem.tasks[0], &problem.terrain);
        let grown = mdd.grow(6, task, terrain, &problem.cost_to_go[0], &budget);
        grown.unwrap();
        assert!(budget.held_bytes().get() > tables);
        drop(mdd);
        assert_eq!(budget.held_bytes().get(), tables);
        drop(problem);
        assert_eq!(budget.held_bytes().get(), 0);
    }

    #[test]
    fn what_is_dropped_is_free() {
        let count = HeldBytes::default();
        let mut one = MemoryUse::new(&count, 10);
        let other = MemoryUse::new(&count, 5);
        one.more(&count, 7);
        assert_eq!(count.get(), 22);
        one.less(12);
        assert_eq!(count.get(), 10);
        drop(one);
        assert_eq!(count.get(), 5);
        drop(other);
        assert_eq!(count.get(), 0);
    }
}
