//! Encodings: each writes clauses to a collector and never sees a solver.

pub(crate) mod agent;
pub(crate) mod at_most_one;
pub(crate) mod battery;
pub(crate) mod collisions;
pub(crate) mod count;
pub(crate) mod limit;
pub(crate) mod rules;
#[cfg(test)]
mod tests;
pub(crate) mod totalizer;
pub(crate) mod weighted;
