//! Why a plan is as it is, or why there is none: reasons as data.
//!
//! - [`ask`]: the search, asked about a changed instance;
//! - `explanation`: the question to the service, and its answer as far as known;
//! - [`engine`]: the order of the parts;
//! - [`verdict`]: the best other plan beside the one asked about;
//! - [`relax`], [`edits`]: facts left out, edits made;
//! - [`core`]: facts that together make it impossible;
//! - [`soft`]: plans that break as few rules as can be;
//! - [`repairs`]: edits that help;
//! - [`waits`]: what would happen without a wait;
//! - [`own_plan`]: a person's own plan beside the best;
//! - [`unsolvable`]: all of these, where there is no plan;
//! - [`answer`]: reasons in the shapes in which they are written as JSON;
//! - [`words`]: reasons in words.

pub mod answer;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod ask;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod core;
pub(crate) mod edits;
pub(crate) mod engine;
mod explanation;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod own_plan;
pub(crate) mod relax;
pub(crate) mod repairs;
pub(crate) mod soft;
#[cfg(test)]
mod tests;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod unsolvable;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod verdict;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod waits;
#[allow(dead_code, reason = "the parts that ask come one by one")]
pub(crate) mod words;

pub use answer::{Class, Core, Edit, Excess, Fact, FactKind, Repair, WitnessEntry};
pub use edits::edited_scene;
pub use explanation::{ExplainAnswer, ExplainRequest, Part, Verdict};
