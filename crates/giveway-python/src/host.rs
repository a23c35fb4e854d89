//! What the process lends to the solver: clocks, an ear, a way to say stop.
#![expect(
    clippy::disallowed_types,
    reason = "Python runs on a system that has a clock; no Wasm is built from this"
)]

use std::cell::Cell;
use std::time::Instant;

use cpu_time::ThreadTime;
use giveway_solve::{Host, Progress};

/// Seconds between two reports of the size, and between two questions whether to stop. Each
/// question waits for Python's lock where another thread has it.
const INTERVAL: f64 = 0.1;

/// What the caller wants to be asked and told.
pub trait Asked {
    /// Something became known.
    fn hear(&self, event: &Progress);

    /// Whether to stop.
    fn should_stop(&self) -> bool;
}

/// The surroundings of one request, which runs in the thread that made them.
pub struct NativeHost<'a> {
    asked: &'a dyn Asked,
    begin: Instant,
    cpu: Option<ThreadTime>,
    reported: Cell<f64>,
    questioned: Cell<f64>,
}

impl<'a> NativeHost<'a> {
    /// The surroundings of a request that begins now.
    pub fn new(asked: &'a dyn Asked) -> Self {
        Self {
            asked,
            begin: Instant::now(),
            cpu: ThreadTime::try_now().ok(),
            reported: Cell::new(0.0),
            questioned: Cell::new(0.0),
        }
    }

    /// Whether the time has come; if so, the next is an interval later.
    fn is_due(&self, next: &Cell<f64>) -> bool {
        let now = self.wall_seconds();
        let due = now >= next.get();
        if due {
            next.set(now + INTERVAL);
        }
        due
    }
}

impl Host for NativeHost<'_> {
    fn wall_seconds(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }

    fn cpu_seconds(&self) -> f64 {
        let elapsed = self.cpu.and_then(|begin| begin.try_elapsed().ok());
        elapsed.map_or_else(|| self.wall_seconds(), |time| time.as_secs_f64())
    }

    fn cancelled(&self) -> bool {
        self.is_due(&self.questioned) && self.asked.should_stop()
    }

    fn progress(&self, event: &Progress) {
        // Bounds and plans are news; sizes only tell that it works.
        let news = !matches!(event, Progress::Size { .. });
        if news || self.is_due(&self.reported) {
            self.asked.hear(event);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Default)]
    struct Counting {
        heard: Cell<u32>,
        asked: Cell<u32>,
    }

    impl Asked for Counting {
        fn hear(&self, _: &Progress) {
            self.heard.set(self.heard.get() + 1);
        }

        fn should_stop(&self) -> bool {
            self.asked.set(self.asked.get() + 1);
            true
        }
    }

    #[test]
    fn it_is_asked_at_once_and_then_seldom_and_told_all_news() {
        let counting = Counting::default();
        let host = NativeHost::new(&counting);
        let stops = (0..100).filter(|_| host.cancelled()).count();
        assert!((1..10).contains(&stops), "{stops}");
        assert_eq!(counting.asked.get() as usize, stops);
        let size = Progress::Size {
            variables: 1,
            clauses: 1,
            conflicts: 1,
        };
        (0..100).for_each(|_| host.progress(&size));
        assert!(counting.heard.get() < 10);
        let before = counting.heard.get();
        let news = Progress::Certifying {
            claim: String::new(),
            checking: true,
        };
        (0..100).for_each(|_| host.progress(&news));
        assert_eq!(counting.heard.get(), before + 100);
        assert!(host.cpu_seconds() <= host.wall_seconds() + 0.1);
    }
}
