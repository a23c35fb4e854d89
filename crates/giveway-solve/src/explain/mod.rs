//! Why a plan is as it is, or why there is none: reasons as data.
//!
//! - [`ask`]: the search, asked about a changed instance;
//! - `explanation`: the question to the service, and its answer as far as known;
//! - [`engine`]: the order of the parts;
//! - [`verdict`]: the best other plan beside the one asked about;
//! - [`answer`]: reasons in the shapes in which they are written as JSON.

pub mod answer;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod ask;
pub(crate) mod engine;
mod explanation;
#[cfg(test)]
mod tests;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod verdict;

pub use answer::{Class, Core, Edit, Fact, FactKind, Repair, WitnessEntry};
pub use explanation::{ExplainAnswer, ExplainRequest, Part, Verdict};
