//! What the inspector tells: of an agent, of a cell, of the plan as a whole.

mod agent;
mod cell;
mod whole;

use giveway_model::Cell;

pub use agent::{AgentFacts, BatteryFacts, agent, planned};
pub use cell::{CellFacts, Pass, cell};
pub use whole::{CostFacts, Whole, whole};

/// A cell in a sentence: `(3,1)`.
pub(crate) fn at(cell: Cell) -> String {
    format!("({},{})", cell.x, cell.y)
}
