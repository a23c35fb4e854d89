//! Flows with the solver's own answers.

mod change;

pub(crate) use change::adopted;
