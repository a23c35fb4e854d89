//! From an instance to a proved answer.
//!
//! [`service::serve`] is the one door: plain-data requests in, plain-data
//! progress and responses out. The command, the worker and the Wasm package all
//! call it. Nothing here draws, reads files or looks at a clock: the front hands
//! in a [`Host`].

mod answer;
mod assumed;
pub mod audit;
mod budget;
mod calmed;
mod certify;
pub mod change;
pub mod delays;
mod encode;
mod ended;
pub mod explain;
pub mod freedom;
mod hitting;
mod host;
mod impose;
mod joint;
mod judged;
pub mod order;
mod pareto;
pub mod plan;
pub mod price;
mod problem;
mod progress;
mod proved_best;
mod reach;
mod reason;
mod request;
mod sat;
mod search;
pub mod service;
mod shut_in;
pub mod sizing;
mod solve;
#[cfg(test)]
mod tests;
mod thresholds;
pub mod together;
pub mod trace;
mod verify;
pub mod words;

pub use giveway_planners::budget::Stop;
use giveway_planners::{calm, first, lns, local, single, terrain, walk};

pub use answer::{CheckAnswer, FrontAnswer, SolveAnswer, Stats, Status};
pub use certify::{Certificate, CertifyRequest, ExportAnswer, ExportRequest};
pub use ended::Ended;
pub use host::{Host, SilentHost};
pub use progress::Progress;
pub use proved_best::ProvedBest;
pub use reach::Reach;
pub use reason::Reason;
pub use request::{Basic, CheckRequest, Limits, Request, SolveRequest};
pub use service::{Proofs, Refusal, Response, serve, serve_basic};
pub use thresholds::Thresholds;
pub use verify::verify;

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
