//! A step of a proof looked at more closely: where its agents can be while they keep
//! their limits, where they get into each other's way, and whether they cannot keep
//! them even by themselves.

mod answer;
mod keep;
mod meet;
mod request;
mod serve;
#[cfg(test)]
mod tests;
mod ways;

pub use answer::{Alone, CellTimes, MeetingKind, MustMeet, MustPass, Region, TogetherAnswer};
pub use request::TogetherRequest;
pub(crate) use serve::serve;
