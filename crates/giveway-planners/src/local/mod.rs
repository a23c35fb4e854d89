//! Plans without proofs: quickly found, then made better.
//!
//! They give an answer early, a bound from above, and the paths of the agents
//! that need no place inside the SAT solver.

mod others;
mod repair;
mod reservations;
mod safe_interval;
mod shared_rules;
mod space_time;
#[cfg(test)]
mod tests;
mod timetable;

pub use others::OtherAgents;
pub use repair::{apart, repair};
pub use reservations::Reservations;
pub use space_time::{DEAR, Query, plan_one};
pub use timetable::Timetable;
