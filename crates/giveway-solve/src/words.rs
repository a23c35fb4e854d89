//! Answers in sentences: one text for the page and the command.

mod bounds;
mod claims;
mod headline;
mod reasons;

pub use bounds::known;
pub use claims::{
    FOR_EVER, claim, claim_under, front, may_differ, on_paper, proved, reach, reach_of_bounds,
};
pub use headline::{Headline, headline};
pub use reasons::reason;
pub(crate) use reasons::{called, clash};
