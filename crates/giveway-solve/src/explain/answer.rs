//! Reasons as data, in the shapes in which they are written as JSON.

mod facts;
mod repairs;
mod witness;

pub use facts::{Core, Fact, FactKind, Helps};
pub use repairs::{Edit, Repair};
pub use witness::{Class, Excess, WitnessEntry};
