//! The tally of the work of a request.

use std::cell::Cell;

use super::{Budget, work};
use crate::Stats;

impl Budget<'_> {
    /// Adds the work of a part to this tally.
    pub(crate) fn absorb(&self, part: &Self) {
        let add = |cell: &Cell<u64>, more: &Cell<u64>| cell.set(cell.get() + more.get());
        add(&self.calls, &part.calls);
        add(&self.variables, &part.variables);
        add(&self.clauses, &part.clauses);
        add(&self.conflicts, &part.conflicts);
        add(&self.derived, &part.derived);
        self.work.add(part.work.spent());
        self.count_joint(part.joint_given - part.joint_left.get());
    }

    /// Steps of joint states that may still be looked at: a bound that needs no
    /// clock, so that proofs by exhaustion stay as long as they are worth it.
    pub(crate) fn joint_left(&self) -> u64 {
        self.joint_left.get()
    }

    /// Counts steps of joint states that were looked at.
    pub(crate) fn count_joint(&self, steps: u64) {
        self.joint_left
            .set(self.joint_left.get().saturating_sub(steps));
    }

    /// Counts a call of a SAT solver with so many variables.
    pub(crate) fn count_call(&self, variables: u32) {
        self.calls.set(self.calls.get() + 1);
        self.work
            .add(u64::from(variables) / work::VARIABLES_PER_UNIT);
    }

    pub(crate) fn count_variable(&self) {
        self.variables.set(self.variables.get() + 1);
    }

    pub(crate) fn count_clause(&self) {
        self.clauses.set(self.clauses.get() + 1);
        self.work.add(work::CLAUSE);
    }

    pub(crate) fn count_conflicts(&self, conflicts: u64) {
        self.conflicts.set(self.conflicts.get() + conflicts);
        if let Some(recorder) = &self.recorder {
            recorder.count_conflicts(conflicts);
        }
    }

    pub(crate) fn count_derived(&self, clauses: u64) {
        self.derived.set(self.derived.get() + clauses);
        self.work.add(work::DERIVED * clauses);
    }

    /// Conflicts of the SAT solver.
    pub(crate) fn conflicts(&self) -> u64 {
        self.conflicts.get()
    }

    /// Clauses that were given to the SAT solver.
    pub(crate) fn given(&self) -> u64 {
        self.clauses.get()
    }

    /// Clauses that the SAT solver derived: learnt from conflicts, or rewritten
    /// when a literal came to hold for good. A measure of its work, by which
    /// the search paces itself.
    pub(crate) fn derived(&self) -> u64 {
        self.derived.get()
    }

    /// The tally so far.
    pub(crate) fn stats(&self) -> Stats {
        Stats {
            cpu_seconds: self.host.cpu_seconds() - self.cpu_start,
            solver_calls: self.calls.get(),
            variables: self.variables.get(),
            clauses: self.clauses.get(),
            conflicts: self.conflicts.get(),
            work: self.work.spent(),
        }
    }
}
