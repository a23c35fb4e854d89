//! Certificates: what a solver claims, proved again so that nobody need trust it.
//!
//! A [`Claim`] says that there is no plan of some kind. [`plain`] writes it as a
//! formula straight from the rules of the problem, [`prove()`] finds a proof in
//! the standard format DRAT, and [`drat`] checks one, knowing nothing of either.
//! What rests on search instead is searched again by [`exhaust`], or counted again by [`queue`]. A [`Bundle`]
//! is a folder with all of it; [`verify()`] accepts or rejects one. [`confirm()`]
//! does the same without a folder.
//!
//! Nothing here reads files or knows the solver whose claims it certifies.

mod again;
pub mod bundle;
mod claim;
mod conclude;
mod condition;
mod confirm;
pub mod drat;
mod escape;
pub mod exhaust;
mod lemma;
pub mod plain;
mod prove;
pub mod queue;
mod report;
mod search;
mod show;
mod solved;
mod verify;

pub use bundle::{Bundle, export};
pub use claim::Claim;
pub use conclude::Conclusion;
pub use confirm::confirm;
pub use lemma::{Hint, Least, Lemma, ProvedLemma};
pub use prove::{Outcome, prove};
pub use report::{Certified, Checked, CheckedLemma, Report};
pub use solved::Solved;
pub use verify::verify;

/// The limits of a certificate, and its progress reports. Where a limit is reached, a claim stays without a
/// proof and says so.
#[derive(Clone, Copy)]
pub struct Budget<'a> {
    /// The clauses of one formula.
    pub clauses: usize,
    /// The bytes of one proof.
    pub proof_bytes: usize,
    /// The states of one search.
    pub states: usize,
    /// The clauses of a formula of all agents that is tried before [lemmas](Lemma).
    pub small_formula: usize,
    /// Asked now and then; work ends soon after it says no.
    pub go_on: &'a dyn Fn() -> bool,
    /// Told of each claim that is come to.
    pub tell: &'a dyn Fn(&Claim),
}

impl Default for Budget<'_> {
    /// The work of about a minute on a machine of today.
    fn default() -> Self {
        Self {
            clauses: 4_000_000,
            proof_bytes: 64 << 20,
            states: 400_000,
            small_formula: 400_000,
            go_on: &|| true,
            tell: &|_| {},
        }
    }
}
