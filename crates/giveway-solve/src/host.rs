//! The surroundings of the solver: a clock, progress reports, cancellation.

use crate::{Progress, Thresholds};

/// The surroundings of one request.
///
/// The solver never looks at a clock by itself, since there is none in Wasm,
/// and since time decides nothing but when to give up.
pub trait Host {
    /// Wall seconds since some fixed moment.
    fn wall_seconds(&self) -> f64;

    /// CPU seconds used so far by this thread or process; wall seconds where
    /// there is no better clock.
    fn cpu_seconds(&self) -> f64 {
        self.wall_seconds()
    }

    /// Whether the person asked to stop. Asked often.
    fn cancelled(&self) -> bool {
        false
    }

    /// Bytes that the program holds of the surroundings' memory, where they can
    /// tell: in Wasm the size of the linear memory. A request that makes it
    /// grow beyond its memory limit is stopped.
    fn memory_bytes(&self) -> u64 {
        0
    }

    /// The pace of the search.
    fn thresholds(&self) -> Thresholds {
        Thresholds::default()
    }

    /// Whether the search runs on the second SAT solver, to be compared.
    #[cfg(test)]
    fn uses_second_solver(&self) -> bool {
        false
    }

    /// Something became known. Called at most a few hundred times a second.
    fn progress(&self, event: &Progress);
}

/// A host without a clock that listens to nothing: only budgets in conflicts
/// and memory can stop a request.
#[derive(Clone, Copy, Debug, Default)]
pub struct SilentHost;

impl Host for SilentHost {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn progress(&self, _: &Progress) {}
}
