//! The SAT solver behind one small interface.
//!
//! This folder is the only place that names varisat, behind a trait ([`backend`]) by
//! which tests run the whole search on another solver. Encodings see
//! [`Clauses`]; searches see [`Sat`].

mod backend;
mod core;
mod lit;
mod minimise;
mod placeholders;
mod proof_listener;
mod solver;
#[cfg(test)]
mod tests;
mod varisat;

pub(crate) use core::Core;
pub(crate) use lit::{Clauses, Lit};
pub(crate) use solver::{Outcome, Sat};
