//! From an instance to a proved answer.
//!
//! [`service::serve`] is the one door: plain-data requests in, plain-data
//! progress and responses out. The command, the worker and the Wasm package all
//! call it. Nothing here draws, reads files or looks at a clock: the front hands
//! in a [`Host`].

mod answer;
mod host;
mod progress;
mod request;
pub mod service;

pub use answer::{CheckAnswer, FrontAnswer, SolveAnswer, Stats, Status};
pub use host::{Host, SilentHost};
pub use progress::Progress;
pub use request::{CheckRequest, Limits, Request, SolveRequest};
pub use service::{Refusal, Response, serve};
