//! How many robots does a floor bear? The best plan of the first robots, for several numbers
//! of them, and beside it on another floor.
//!
//! Each plan is a solve of its own, with a budget of its own.

mod answer;
mod findings;
mod request;
mod serve;
mod table;
#[cfg(test)]
mod tests;
pub mod words;

pub use answer::{SizingAnswer, SizingFloor, SizingPoint, SlowestAlone};
pub use findings::{Finding, findings};
pub use request::SizingRequest;
pub(crate) use serve::serve;
pub use table::csv;
