//! What all best plans share (the backbone), and what is free to choose.

mod answer;
mod backbone;
mod cell_rules;
mod certificates;
mod count;
mod critical;
mod every;
mod farthest;
mod formula;
mod hold;
mod later;
mod parts;
mod request;
mod serve;
mod variations;
mod ways;
pub mod words;

pub use answer::{
    About, Closed, CriticalCell, Farthest, FreedomAnswer, Hold, Known, Later, Need, PlanCount,
    Plans, Shared, Slack, Step, Visit, Ways, same_steps,
};
pub(crate) use critical::CellNeeded;
pub use request::{DEFAULT_COUNT, FreedomPart, FreedomRequest};
pub(crate) use serve::serve;
