//! Unsatisfiable cores as proofs.

use std::ops::Deref;

use super::Lit;

/// Assumptions that exclude each other: a call under just these was
/// unsatisfiable. Only this folder makes one, so whoever holds one holds a proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Core(Vec<Lit>);

impl Core {
    /// Of a call that was unsatisfiable under these assumptions.
    pub(super) const fn proved(assumptions: Vec<Lit>) -> Self {
        Self(assumptions)
    }

    /// Its assumptions, given away.
    pub(super) fn into_lits(self) -> Vec<Lit> {
        self.0
    }
}

impl Deref for Core {
    type Target = [Lit];

    fn deref(&self) -> &[Lit] {
        &self.0
    }
}
