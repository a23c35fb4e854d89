//! Giveway for JavaScript, and in a page's worker.
//!
//! [`solve`] and [`check`] answer in the thread that calls them, from and to
//! plain objects. [`serve_messages`] answers the messages of [`protocol`] in a
//! Web Worker. Both go through the solver's one service. Nothing here draws.

mod budget;
mod host;
#[cfg(feature = "javascript")]
mod javascript;
pub mod protocol;
mod worker;

pub use budget::MEMORY_BYTES;
#[cfg(feature = "javascript")]
pub use javascript::{check, read_moving_ai, read_plan, read_scene, solve};
pub use worker::serve_messages;
