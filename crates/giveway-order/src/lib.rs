//! Plans kept by order instead of by clock: temporal plan graphs.
//!
//! A robot on a real floor is late now and then. Where every robot keeps the order in which
//! the plan has them in each cell, none of them collides and none waits for ever, however late
//! they are. [`OrderGraph`] is that order (the temporal plan graph of Hönig et al. 2016): a
//! robot begins its move into a cell no earlier than the one before it begins to leave the
//! cell. It is made of a plan and the world around it alone; no solver is asked.

mod dot;
mod events;
mod graph;
mod late;
mod late_plan;
mod links;
mod loss;
mod order;
mod rules;
mod times;
mod units;
mod vda5050;
mod waypoints;
pub mod words;

pub use dot::dot;
pub use graph::OrderGraph;
pub use late::{Arrival, LateVisit, Lateness, LatenessError, MAX_LATENESS, Outcome};
pub use loss::{Loss, losses};
pub use order::{
    AgentOrder, End, Link, LinkEnd, NoOrder, Order, Rotation, RotationMove, Shift, Visit,
};
pub use vda5050::{Vda5050, vda5050};
pub use waypoints::{Waypoint, csv, waypoints};
