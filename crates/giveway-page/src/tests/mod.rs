//! Flows with the solver's own answers.

mod change;
mod steer;

pub(crate) use change::{adopted, compared};
