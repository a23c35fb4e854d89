//! What each rule of a scene's own costs: the best plan with all of them beside the best
//! plan without one. Where all of them together leave no plan: which exclude each other,
//! and the fewest whose switching off leaves one.
//!
//! How little a rule has to be loosened so that something changes.
//!
//! A price is a difference of two proved optima, all else as it is.

mod answer;
mod compared;
mod conflict;
mod loosen;
mod request;
mod serve;
#[cfg(test)]
mod tests;
pub mod words;

pub use answer::{Loosened, LooserRule, Price, PriceAnswer, RulePrice, SwitchOff};
pub use request::{KnownPrices, PriceRequest};
pub(crate) use serve::serve;
