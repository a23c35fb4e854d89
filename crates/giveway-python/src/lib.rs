//! Giveway for Python.
//!
//! The layer in Rust is small: [`call()`] takes the name of a function and its request as
//! JSON, and gives its answer as JSON. The module that Python loads (`module`, a feature)
//! hands texts through, lets other threads run meanwhile, and lends callbacks and signals
//! to the solver. Everything else that a person meets is in `python/giveway/`.

mod call;
mod export;
mod files;
mod host;
#[cfg(feature = "module")]
mod module;
mod sweep;

pub use call::{Code, Failure, call};
pub use host::{Asked, NativeHost};
