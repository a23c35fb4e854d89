//! Plans that need a map and a scenario: of the MAPF tracker, and with a line for
//! each robot or for each time step.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

mod losses;
mod paths;
mod result;
mod support;
mod tracker;
