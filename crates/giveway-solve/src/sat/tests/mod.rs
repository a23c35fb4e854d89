//! The solver against a second one, and against its budgets.

mod budget;
mod cores;
mod second;
mod session;
