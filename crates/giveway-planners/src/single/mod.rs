//! One agent alone: its task, its exact distances, its MDD of good plans.

mod area;
mod automaton;
mod cost_to_go;
mod counter;
mod distances;
mod earliest;
mod left;
mod mdd;
mod no_plan_alone;
mod onward;
mod task;
#[cfg(test)]
mod tests;

pub use area::Area;
pub use automaton::{Act, Automaton, Forbidden, Part, Required};
pub use cost_to_go::{CostToGo, Metric};
pub use counter::{Counter, LongWait, Passage, Stay, Turns};
pub use earliest::earliest;
pub(crate) use earliest::earliest_from;
pub use left::{Entry, Left};
pub use mdd::{Mdd, Node, NodeId, Place};
pub use no_plan_alone::{NoPlanAlone, has_to_be_at};
pub use onward::{Onward, State};
pub use task::{Bounds, MAX_WAYPOINTS, Mask, Penalty, Reserve, Task};
