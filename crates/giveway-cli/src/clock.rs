//! The clocks that the command lends to the solver.
#![expect(
    clippy::disallowed_types,
    reason = "the command is the front that has a clock; no Wasm is built from it"
)]

use std::time::Instant;

use cpu_time::ProcessTime;
use giveway_solve::Limits;

/// Wall time since the command began, and its CPU time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    begin: Instant,
}

impl Clock {
    /// Starts the clock; the first thing that the command does.
    pub(crate) fn start() -> Self {
        Self {
            begin: Instant::now(),
        }
    }

    /// Wall seconds since the start.
    pub(crate) fn wall_seconds(self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }

    /// The limits of a request where the whole command has so many seconds: reading the input
    /// has taken its part of them.
    pub(crate) fn limits(self, time_limit: Option<f64>) -> Limits {
        Limits {
            seconds: time_limit.map(|limit| (limit - self.wall_seconds()).max(0.0)),
            ..Limits::default()
        }
    }

    /// CPU seconds of the whole process; wall seconds where the system does not
    /// tell them.
    pub(crate) fn cpu_seconds(self) -> f64 {
        ProcessTime::try_now().map_or_else(
            |_| self.wall_seconds(),
            |time| time.as_duration().as_secs_f64(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cpu_time_grows_with_work() {
        let clock = Clock::start();
        let before = clock.cpu_seconds();
        let mut x = 1_u64;
        while clock.wall_seconds() < 0.05 {
            x = std::hint::black_box(x.wrapping_mul(3));
        }
        assert!(clock.cpu_seconds() > before, "{x}");
    }
}
