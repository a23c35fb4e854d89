//! What a browser lends to the solver: a clock, the memory's size, an ear.

use std::cell::Cell;

use giveway_solve::{Host, Progress};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    /// Milliseconds; there in a page, in a worker and in Node.
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// Seconds between two reports of the size, and between two questions whether
/// to stop.
const REPORT_INTERVAL: f64 = 0.1;
const QUESTION_INTERVAL: f64 = 0.01;

/// The surroundings of one request.
pub(crate) struct WebHost<'a> {
    listen: &'a dyn Fn(&Progress),
    should_stop: Option<&'a dyn Fn() -> bool>,
    reported: Pace,
    asked: Pace,
}

impl<'a> WebHost<'a> {
    /// A host that hands on what it hears; `should_stop` is asked often.
    pub(crate) fn new(
        listen: &'a dyn Fn(&Progress),
        should_stop: Option<&'a dyn Fn() -> bool>,
    ) -> Self {
        Self {
            listen,
            should_stop,
            reported: Pace::new(REPORT_INTERVAL),
            asked: Pace::new(QUESTION_INTERVAL),
        }
    }
}

impl Host for WebHost<'_> {
    fn wall_seconds(&self) -> f64 {
        now() / 1000.0
    }

    fn memory_bytes(&self) -> u64 {
        memory_bytes()
    }

    fn cancelled(&self) -> bool {
        self.should_stop
            .is_some_and(|ask| self.asked.is_due(self.wall_seconds()) && ask())
    }

    fn progress(&self, event: &Progress) {
        // Bounds and plans are news; sizes only tell that it works.
        let news = !matches!(event, Progress::Size { .. });
        if news || self.reported.is_due(self.wall_seconds()) {
            (self.listen)(event);
        }
    }
}

/// The size of the linear memory.
#[cfg(target_arch = "wasm32")]
fn memory_bytes() -> u64 {
    const PAGE: u64 = 65_536;
    core::arch::wasm32::memory_size::<0>() as u64 * PAGE
}

#[cfg(not(target_arch = "wasm32"))]
fn memory_bytes() -> u64 {
    0
}

/// Lets something through once in a while.
struct Pace {
    interval: f64,
    next: Cell<f64>,
}

impl Pace {
    const fn new(interval: f64) -> Self {
        Self {
            interval,
            next: Cell::new(f64::NEG_INFINITY),
        }
    }

    /// Whether it is time again; if so, it is not for another interval.
    fn is_due(&self, now: f64) -> bool {
        let due = now >= self.next.get();
        if due {
            self.next.set(now + self.interval);
        }
        due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pace_lets_the_first_through_and_then_one_an_interval() {
        let pace = Pace::new(0.1);
        let times = [5.0, 5.01, 5.09, 5.11, 5.12, 9.0, 9.05];
        let through: Vec<bool> = times.iter().map(|&now| pace.is_due(now)).collect();
        assert_eq!(through, [true, false, false, true, false, true, false]);
    }
}
