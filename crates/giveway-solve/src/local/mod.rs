//! Plans without proofs: quickly found, then made better.
//!
//! They give an answer early, a bound from above, and the paths of the agents
//! that need no place inside the SAT solver.

mod chance;
mod first_plan;
mod neighbourhood;
mod reservations;
mod space_time;
#[cfg(test)]
mod tests;

pub(crate) use first_plan::{apart, first_plan};
pub(crate) use neighbourhood::Lns;
pub(crate) use reservations::Reservations;
pub(crate) use space_time::{Query, plan_one};
