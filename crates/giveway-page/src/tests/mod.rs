//! Flows with the solver's own answers.

mod change;
mod soak;
mod steer;

pub(crate) use change::{adopted, compared};
