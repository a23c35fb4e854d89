//! A sum of unary numbers that must not exceed a limit, for good.
//!
//! The numbers come one by one, as agents enter; each is merged into the sum so
//! far by a totalizer that needs no outputs beyond the limit.

use super::totalizer::merge;
use crate::{
    budget::Stop,
    sat::{Clauses, Lit},
};

/// A growing sum with a hard limit.
pub(crate) struct SumLimit {
    most: usize,
    sum: Vec<Lit>,
}

impl SumLimit {
    /// A sum of nothing that must stay at most `most`.
    pub(crate) const fn new(most: usize) -> Self {
        Self {
            most,
            sum: Vec::new(),
        }
    }

    /// A sum of which output `k` says "more than k", up to its limit at least.
    pub(crate) fn of_sum(mut sum: Vec<Lit>, most: usize, out: &mut impl Clauses) -> Self {
        sum.truncate(most.saturating_add(1));
        if let Some(&beyond) = sum.get(most) {
            out.clause(&[!beyond]);
        }
        Self { most, sum }
    }

    /// The limit.
    pub(crate) const fn most(&self) -> usize {
        self.most
    }

    /// Adds a number: digit `d` (from 0) says "more than d".
    ///
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn add(&mut self, digits: &[Lit], out: &mut impl Clauses) -> Result<(), Stop> {
        self.sum = merge(&self.sum, digits, self.most.saturating_add(1), out)?;
        if let Some(&beyond) = self.sum.get(self.most) {
            out.clause(&[!beyond]);
        }
        Ok(())
    }
}
