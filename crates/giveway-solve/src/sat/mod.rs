//! The SAT solver behind one small interface.
//!
//! This folder is the only place that names varisat. Encodings see
//! [`Clauses`]; searches see [`Sat`].

mod lit;
mod minimise;
mod placeholders;
mod proof_listener;
mod solver;
#[cfg(test)]
mod tests;

pub(crate) use lit::{Clauses, Lit};
pub(crate) use solver::{Outcome, Sat};
