//! What the inspector tells: of an agent, of a cell, of the plan as a whole.

mod agent;
mod cell;
mod whole;

pub use agent::{AgentFacts, BatteryFacts, agent, planned};
pub use cell::{CellFacts, Pass, cell};
pub(crate) use whole::claim;
pub use whole::{CostFacts, Whole, whole};
