//! Giveway for JavaScript, and in a page's worker.
//!
//! [`solve`], [`check`], [`explain`] and the others answer in the thread that calls
//! them, from and to plain objects. [`serve_messages`] answers the messages of
//! [`protocol`] in a Web Worker, [`serve_basic_messages`] the first of them in a smaller
//! program. All go through the solver's one service. Nothing here draws.

mod budget;
mod host;
#[cfg(feature = "javascript")]
mod javascript;
pub mod language;
pub mod protocol;
mod worker;

pub use budget::MEMORY_BYTES;
#[cfg(feature = "javascript")]
pub use javascript::{
    audit, certify, change, check, compare_plans, convert, delays, explain, export_certificates,
    freedom, order, plan, price, read_files, read_moving_ai, read_plan, read_scene, schema, sizing,
    solve, together, verify,
};
pub use worker::{serve_basic_messages, serve_messages};
