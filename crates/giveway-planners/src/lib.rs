//! Planners of the textbook for multi-agent path finding, and what they stand on.
//!
//! [`Problem`](problem::Problem) is an instance as every planner sees it: a graph
//! ([`terrain`]), and of each agent its task, exact distances and MDD ([`single`]).
//! Nothing here knows SAT, a clock, or a page.

pub mod bottleneck;
pub mod budget;
pub mod calm;
pub mod cbs;
mod chance;
pub mod first;
pub mod lacam;
pub mod lns;
pub mod local;
pub mod lost;
pub mod pibt;
pub mod plain;
pub mod planner;
pub mod prioritised;
pub mod problem;
pub mod rules;
pub mod single;
pub mod terrain;
#[cfg(test)]
mod tests;
pub mod walk;

/// An agent by its number in the instance.
pub type AgentId = usize;

/// The example of the README is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
