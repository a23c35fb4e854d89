//! One agent alone: its task, its exact distances, its diagram of good plans.

mod demand;
mod diagram;
mod earliest;
mod task;
#[cfg(test)]
mod tests;
mod to_go;

pub(crate) use demand::Demand;
pub(crate) use diagram::{Diagram, Node, NodeId, Place};
pub(crate) use earliest::earliest;
pub(crate) use task::{Bounds, MAX_WAYPOINTS, Reserve, State, Task};
pub(crate) use to_go::{Metric, ToGo};
