//! The problem, the plan and the judge of Giveway.
//!
//! Multi-modal multi-agent path finding with resources (mMAPF; Bogatarkan and
//! Erdem 2020) on a grid. Cells are `[x, y]` from 0 at the top left, `y` down;
//! time is an integer from 0. Nothing here solves, reads files or draws.

mod agent;
pub mod assumption;
mod cell;
pub mod change;
pub mod check;
pub mod compare;
pub mod condition;
pub mod constraint;
mod cost;
pub mod csv;
mod decimal;
mod fault;
pub mod fleet;
pub mod format;
mod grid;
mod instance;
pub mod message;
mod object;
pub mod parts;
mod plan;
pub mod question;
mod release;
mod rules;
mod scene;
pub mod snapshot;
pub mod sorting;
mod units;
mod version;
pub mod words;

pub use agent::{Agent, Battery, ends_with_rest};
pub use assumption::{Assumption, LeftOutRule};
pub use cell::Cell;
pub use condition::Condition;
pub use constraint::{Constraint, Zone};
pub use cost::{Cost, Costs, Objective, ObjectiveError, UnknownCost};
pub use decimal::decimal;
pub use fault::Fault;
pub use grid::{Grid, GridError, Ground};
pub use instance::{
    Breakdown, ClosedCell, Instance, MAX_AGENTS, MAX_CAPACITY, MAX_SIDE, StartState,
};
pub use plan::{Path, Plan};
pub use question::Question;
pub use release::release;
pub use rules::{AtGoal, Rules};
pub use scene::Scene;
pub use units::{Measure, Units};
pub use version::Version;

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
