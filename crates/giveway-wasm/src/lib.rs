//! Giveway in a page's worker.
//!
//! [`serve_messages`] answers the messages of [`protocol`] in a Web Worker,
//! through the solver's one service. Nothing here draws, and nothing but the
//! worker itself needs a browser.

mod budget;
mod host;
pub mod protocol;
mod worker;

pub use budget::MEMORY_BYTES;
pub use worker::serve_messages;
