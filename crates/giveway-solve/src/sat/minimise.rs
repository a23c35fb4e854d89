//! Large cores made smaller, by leaving out one assumption after the other.
//!
//! Deletion-based extraction of a minimal core (Marques-Silva 2010), given up
//! soon: every agent of a core gets a larger MDD and every core a
//! totalizer, so a large core makes all later calls dearer; but a call with a
//! model is dear too, as it decides every variable, and varisat cannot be
//! stopped within one.

use super::{Core, Lit, Sat};
use crate::budget::Stop;

/// Assumptions found to be needed before the rest is taken to be so, too.
const MOST_FAILURES: usize = 20;
/// Clauses that may be derived before no further call is begun.
const MOST_DERIVED: u64 = 300;

impl Sat<'_> {
    /// Makes the core of the last call smaller. What is left is proved as well:
    /// a call under just these assumptions was unsatisfiable.
    ///
    /// # Errors
    /// When the budget is spent; the solver is lost then.
    pub(crate) fn minimise(&mut self, proved: Core) -> Result<Core, Stop> {
        if proved.len() <= self.small_core() {
            return Ok(proved);
        }
        self.leave_out(proved)
    }

    /// The same for a core of any size.
    pub(super) fn leave_out(&mut self, proved: Core) -> Result<Core, Stop> {
        let mut proved = proved.into_lits();
        let needed = std::mem::take(&mut self.needed);
        let until = self.derived() + MOST_DERIVED;
        let mut failures = 0;
        for lit in proved.clone() {
            if failures == MOST_FAILURES || self.derived() > until {
                break;
            }
            if needed.contains(&lit) || !proved.contains(&lit) {
                continue;
            }
            let rest: Vec<Lit> = proved.iter().copied().filter(|&l| l != lit).collect();
            match self.call(&rest)? {
                Some(core) => {
                    proved = rest;
                    self.follow(core, &mut proved)?;
                }
                None => failures += 1,
            }
        }
        Ok(Core::proved(proved))
    }

    /// Takes over what varisat says to be enough, as far as calls prove it.
    fn follow(&mut self, mut core: Vec<Lit>, proved: &mut Vec<Lit>) -> Result<(), Stop> {
        while core.len() < proved.len() {
            let order: Vec<Lit> = core.iter().rev().copied().collect();
            let Some(smaller) = self.call(&order)? else {
                break; // the core was wrong
            };
            *proved = order;
            core = smaller;
        }
        Ok(())
    }
}
