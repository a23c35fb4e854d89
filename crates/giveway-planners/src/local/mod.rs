//! Plans without proofs: quickly found, then made better.
//!
//! They give an answer early, a bound from above, and the paths of the agents
//! that need no place inside the SAT solver.

pub(crate) mod chance;
mod first_plan;
mod neighbourhood;
mod reservations;
mod space_time;
#[cfg(test)]
mod tests;

pub use first_plan::{apart, first_plan};
pub use neighbourhood::Lns;
pub use reservations::Reservations;
pub use space_time::{DEAR, Query, plan_one};
