//! The interface of a SAT solver.

use std::rc::Rc;

use super::{Lit, placeholders::Freed};
use crate::budget::{Budget, Stop};

/// An incremental SAT solver under assumptions.
pub(super) trait Backend<'h> {
    /// A solver without clauses, which counts its work, stops when the budget is spent,
    /// and tells of places of variables that become free, if it gives any away again.
    fn new(budget: Rc<Budget<'h>>, freed: Freed) -> Self;

    /// Adds a clause; variables come into being with their first clause.
    fn add_clause(&mut self, lits: &[Lit]);

    /// Solves under assumptions: `None` for a model, else some of them that it states to
    /// exclude each other, which nobody has to believe.
    ///
    /// # Errors
    /// When the budget is spent; the solver is lost then.
    fn solve(&mut self, assumptions: &[Lit]) -> Result<Option<Vec<Lit>>, Stop>;

    /// The literals that hold in the last model.
    fn model(&self) -> impl Iterator<Item = Lit>;
}
