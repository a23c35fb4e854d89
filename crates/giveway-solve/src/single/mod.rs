//! One agent alone: its task, its exact distances, its MDD of good plans.

mod cost_to_go;
mod demand;
mod earliest;
mod hopeless;
mod mdd;
mod onward;
mod task;
#[cfg(test)]
mod tests;

pub(crate) use cost_to_go::{CostToGo, Metric};
pub(crate) use demand::TaskConstraint;
pub(crate) use earliest::earliest;
pub(crate) use hopeless::{Hopeless, has_to_be_at};
pub(crate) use mdd::{Mdd, Node, NodeId, Place};
pub(crate) use onward::State;
pub(crate) use task::{Bounds, MAX_WAYPOINTS, Reserve, Task};
