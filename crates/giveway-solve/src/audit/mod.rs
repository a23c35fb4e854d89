//! A plan of elsewhere, audited: whether it is legal, how far it is from the best,
//! and a better one where there is one.
//!
//! The judge says what is legal. What each agent needs alone is a first bound, told
//! at once; then the search for the best plan begins with the audited one, and its
//! bounds grow.

mod answer;
mod conclude;
mod request;
mod serve;
#[cfg(test)]
mod tests;
pub mod words;

pub use answer::{AuditAnswer, AuditStatus, gap};
pub use request::AuditRequest;
pub(crate) use serve::serve;
