//! A plan around which the world changes: how to go on with it.
//!
//! At the time of a change the past is frozen. Three methods make a new plan
//! from there: *revise* keeps each old agent's sequence of cells and chooses
//! other times (revise and augment; Bogatarkan, Patoglu and Erdem 2019),
//! *tunnel* keeps it near its old path (Bogatarkan and Erdem 2025), *replan*
//! lets everyone go anywhere. Each is the same search over a
//! [`Snapshot`](giveway_model::snapshot::Snapshot) of the plan at that time, with
//! [`Bounds`](crate::single::Bounds) on the old agents ([`keep`]); where these leave no
//! plan, the fewest agents are freed ([`freed`]). The new plan is put behind the past and
//! judged in the world of each time.

mod answer;
mod compare;
mod freed;
mod horizon;
mod keep;
mod method;
mod method_case;
mod request;
mod rule;
mod serve;
pub(crate) mod words;

#[cfg(test)]
mod tests;

pub use answer::{Cause, CauseKind, CauseRule, ChangeAnswer, MethodAnswer, Methods, Step};
pub use request::{ChangeRequest, Method, UnknownMethod};
pub use serve::makespan_first;
pub(crate) use serve::serve;
pub use words::{names, notes};
