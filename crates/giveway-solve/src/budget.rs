//! The budget of one request: its limits and cooperative cancellation.
//!
//! Inner loops ask it whether to go on. It decides nothing else, so that time cannot
//! change an answer but only cut it short. A limit of work cuts it short at the same
//! place each time.

mod counts;
mod tell;
#[cfg(test)]
mod tests;
mod work;

use std::cell::Cell;
use std::rc::Rc;

use giveway_planners::budget as planners;

use crate::{Host, Limits, Thresholds, trace::Recorder};

pub(crate) use planners::{HeldBytes, MemoryUse, Stop};
use work::Work;

/// Bytes that a request may hold where its limits say nothing: a browser tab
/// stands it, and so does a small machine.
const DEFAULT_MEMORY: u64 = 1_500_000_000;

/// Steps of joint states that a request may look at, and a part of one.
const JOINT_STEPS: u64 = 12_000_000;
const PART_JOINT_STEPS: u64 = 2_000_000;

/// The budget and the tally; shared by all parts of one request.
pub(crate) struct Budget<'h> {
    host: &'h dyn Host,
    limits: Limits,
    thresholds: Thresholds,
    wall_start: f64,
    cpu_start: f64,
    memory_start: u64,
    calls: Cell<u64>,
    variables: Cell<u64>,
    clauses: Cell<u64>,
    conflicts: Cell<u64>,
    derived: Cell<u64>,
    work: Work,
    held: HeldBytes,
    reported_at: Cell<u64>,
    stopped: Cell<Option<Stop>>,
    /// Whether the host hears nothing of what becomes known.
    quiet: bool,
    /// Records the events of the search, where a trace is asked for.
    recorder: Option<Rc<Recorder>>,
    /// Steps of joint states that may be looked at, and what is left of them.
    joint_given: u64,
    joint_left: Cell<u64>,
    /// Clauses that may be written: a measure of work that needs no clock, so
    /// that the same request is cut off at the same place.
    most_clauses: u64,
    /// Clauses that the SAT solver may derive: the same for its work.
    most_derived: u64,
    /// Bytes that may be held, by its own estimate.
    most_held: u64,
}

impl<'h> Budget<'h> {
    pub(crate) fn new(host: &'h dyn Host, limits: Limits) -> Self {
        Self {
            host,
            limits,
            thresholds: host.thresholds(),
            wall_start: host.wall_seconds(),
            cpu_start: host.cpu_seconds(),
            memory_start: host.memory_bytes(),
            calls: Cell::new(0),
            variables: Cell::new(0),
            clauses: Cell::new(0),
            conflicts: Cell::new(0),
            derived: Cell::new(0),
            work: Work::new(limits.work),
            held: HeldBytes::default(),
            reported_at: Cell::new(0),
            stopped: Cell::new(None),
            quiet: false,
            recorder: None,
            joint_given: JOINT_STEPS,
            joint_left: Cell::new(JOINT_STEPS),
            most_clauses: u64::MAX,
            most_derived: u64::MAX,
            most_held: u64::MAX,
        }
    }

    /// A budget for one part of the work: with limits of its own, which are never
    /// more than what is left here. The host hears nothing of it, since bounds
    /// and plans of a part are not those of the whole.
    pub(crate) fn part(&self, limits: Limits) -> Self {
        let seconds = self.seconds_left();
        let spent = self.conflicts.get();
        let conflicts = self.limits.conflicts.map(|most| most.saturating_sub(spent));
        let work = self.work_left();
        let mut part = Self::new(
            self.host,
            Limits {
                seconds: seconds.into_iter().chain(limits.seconds).reduce(f64::min),
                conflicts: conflicts.into_iter().chain(limits.conflicts).min(),
                work: work.into_iter().chain(limits.work).min(),
                memory_bytes: limits.memory_bytes.or(self.limits.memory_bytes),
            },
        );
        part.quiet = true;
        part.held = Rc::clone(&self.held);
        part.most_clauses = self.clauses_left();
        part.recorder.clone_from(&self.recorder);
        part.most_held = self.most_held;
        part.most_derived = self.most_derived.saturating_sub(self.derived.get());
        part.joint_given = self.joint_left.get().min(PART_JOINT_STEPS);
        part.joint_left.set(part.joint_given);
        part
    }

    /// The same budget with a limit of clauses that the SAT solver may derive.
    pub(crate) fn with_derived(mut self, clauses: u64) -> Self {
        self.most_derived = self.most_derived.min(clauses);
        self
    }

    /// The same budget with a limit of clauses that may be written.
    pub(crate) fn with_clauses(mut self, clauses: u64) -> Self {
        self.most_clauses = self.most_clauses.min(clauses);
        self
    }

    /// The same budget with a limit of bytes that may be held beside those that are held already.
    pub(crate) fn with_held(mut self, bytes: u64) -> Self {
        self.most_held = self.most_held.min(self.held.get().saturating_add(bytes));
        self
    }

    /// The same budget with a limit of clauses, and one of joint steps.
    pub(crate) fn with_work(mut self, clauses: u64, joint_steps: u64) -> Self {
        self.most_clauses = self.most_clauses.min(clauses);
        self.joint_given = self.joint_given.min(joint_steps);
        self.joint_left.set(self.joint_given);
        self
    }

    /// Wall seconds that are left, where they are limited.
    pub(crate) fn seconds_left(&self) -> Option<f64> {
        let used = self.host.wall_seconds() - self.wall_start;
        self.limits.seconds.map(|limit| (limit - used).max(0.0))
    }

    /// Units of work that are left, where they are limited.
    pub(crate) fn work_left(&self) -> Option<u64> {
        self.work.left()
    }

    /// Clauses that the SAT solver may still derive.
    pub(crate) fn derived_left(&self) -> u64 {
        self.most_derived.saturating_sub(self.derived.get())
    }

    /// Clauses that are left, where they are limited.
    pub(crate) fn clauses_left(&self) -> u64 {
        self.most_clauses.saturating_sub(self.clauses.get())
    }

    /// Whether it holds too much, by its own estimate or by the host's word.
    /// What was there before the request may be used again.
    fn is_too_large(&self) -> bool {
        let most = self.limits.memory_bytes.unwrap_or(DEFAULT_MEMORY);
        let size = self.host.memory_bytes();
        self.held.get() > most.min(self.most_held) || size > most.max(self.memory_start)
    }

    /// Whether the search runs on the second SAT solver.
    #[cfg(test)]
    pub(crate) fn uses_second_solver(&self) -> bool {
        self.host.uses_second_solver()
    }

    /// The pace of the search.
    pub(crate) const fn thresholds(&self) -> &Thresholds {
        &self.thresholds
    }

    /// Whether to go on; once it says no, it says no for good.
    pub(crate) fn check(&self) -> Result<(), Stop> {
        if let Some(stop) = self.stopped.get() {
            return Err(stop);
        }
        let spent = |limit: Option<u64>, used: u64| limit.is_some_and(|limit| used > limit);
        let stop = if self.host.cancelled() {
            Stop::Cancelled
        } else if self.is_too_large() {
            Stop::Memory
        } else if spent(self.limits.conflicts, self.conflicts.get())
            || self.derived.get() > self.most_derived
            || self.clauses.get() > self.most_clauses
        {
            Stop::Conflicts
        } else if self.work.is_over() {
            Stop::Work
        } else if self
            .limits
            .seconds
            .is_some_and(|limit| self.host.wall_seconds() - self.wall_start >= limit)
        {
            Stop::Time
        } else {
            return Ok(());
        };
        self.stopped.set(Some(stop));
        Err(stop)
    }

    /// Counts a state, and looks at the limits now and then: for the inner loops.
    pub(crate) fn tick(&self) -> Result<(), Stop> {
        self.spend(1)
    }

    /// Counts so many states, and looks at the limits now and then.
    pub(crate) fn spend(&self, states: u64) -> Result<(), Stop> {
        if self.work.spend(states) {
            return self.check();
        }
        self.stopped.get().map_or(Ok(()), Err)
    }

    /// Counts further memory of something, in bytes.
    pub(crate) fn hold_more(&self, held: &mut MemoryUse, bytes: usize) {
        held.more(&self.held, bytes);
    }
}

impl planners::Budget for Budget<'_> {
    fn check(&self) -> Result<(), Stop> {
        Self::check(self)
    }

    fn tick(&self) -> Result<(), Stop> {
        Self::tick(self)
    }

    fn spend(&self, states: u64) -> Result<(), Stop> {
        Self::spend(self, states)
    }

    fn held_bytes(&self) -> &HeldBytes {
        &self.held
    }
}
