//! What a worker tells of its job.

use giveway_solve::{Progress, Response};

/// A worker tells of the job that it was given.
#[derive(Clone, Debug, PartialEq)]
pub enum WorkerAction {
    /// The worker got to know something.
    Progress {
        /// The number of the job.
        job: u64,
        /// What became known.
        event: Progress,
    },
    /// The worker answered.
    Respond {
        /// The number of the job.
        job: u64,
        /// The answer.
        response: Box<Response>,
    },
    /// The worker ended without an answer.
    Crash {
        /// The number of the job.
        job: u64,
        /// Why, as a sentence.
        sentence: String,
        /// Whether it broke off and was replaced; else it did not even start.
        had_started: bool,
    },
}
