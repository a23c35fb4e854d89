//! One agent alone: its task, its exact distances, its diagram of good plans.

mod diagram;
mod task;
#[cfg(test)]
mod tests;
mod to_go;

pub(crate) use diagram::{Diagram, Node, NodeId, Place};
pub(crate) use task::{MAX_WAYPOINTS, Reserve, Task};
pub(crate) use to_go::{Metric, ToGo};
