//! At most one of a growing set of literals.
//!
//! Pairwise while the set is small; then groups are closed one after the other
//! and each is represented by one new literal (a chain of commanders; Klieber
//! and Kwon 2007), so that a set of n takes about 3 n clauses and may grow for
//! ever.

use crate::sat::{Clauses, Lit};

/// Literals that exclude each other directly before a group is closed.
const GROUP: usize = 5;

/// A growing set of which at most one may hold.
#[derive(Clone, Debug, Default)]
pub(crate) struct AtMostOne {
    group: Vec<Lit>,
}

impl AtMostOne {
    /// Adds a literal to the set.
    pub(crate) fn add(&mut self, lit: Lit, out: &mut impl Clauses) {
        if self.group.len() == GROUP {
            let commander = out.fresh();
            for &other in &self.group {
                out.clause(&[!other, commander]);
            }
            self.group.clear();
            self.group.push(commander);
        }
        for &other in &self.group {
            out.clause(&[!other, !lit]);
        }
        self.group.push(lit);
    }
}
