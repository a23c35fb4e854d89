//! Literals, and the collector that encodings write to.

use std::fmt;
use std::ops::Not;

use crate::budget::Stop;

/// A literal: a variable (from 0) or its negation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Lit(u32);

impl Lit {
    /// The positive literal of a variable.
    pub(crate) const fn positive(variable: u32) -> Self {
        Self(variable << 1)
    }

    /// The literal of a variable, negated or not.
    pub(crate) const fn new(variable: u32, positive: bool) -> Self {
        Self(variable << 1 | !positive as u32)
    }

    /// The variable.
    pub(crate) const fn variable(self) -> u32 {
        self.0 >> 1
    }

    /// Whether it is not negated.
    pub(crate) const fn is_positive(self) -> bool {
        self.0 & 1 == 0
    }
}

impl Not for Lit {
    type Output = Self;

    fn not(self) -> Self {
        Self(self.0 ^ 1)
    }
}

impl fmt::Debug for Lit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.is_positive() { "" } else { "-" };
        write!(f, "{sign}{}", self.variable())
    }
}

/// The sink of an encoding: it makes variables and takes clauses. An encoding never sees a solver.
pub(crate) trait Clauses {
    /// A new variable, as its positive literal.
    fn fresh(&mut self) -> Lit;

    /// Adds the disjunction of some literals.
    fn clause(&mut self, lits: &[Lit]);

    /// Whether to go on writing.
    ///
    /// # Errors
    /// When the budget is spent.
    fn check(&self) -> Result<(), Stop>;
}
