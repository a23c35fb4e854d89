//! Writes down what a search does, and keeps the first events and the last.

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::mem;

use giveway_model::{Cost, Objective};

use super::{AgentLeast, AgentLimit, SearchEvent, SearchTrace, TraceEvent, words};
use crate::encode::collisions::AgentId;

/// The host is told of so many events at once, or of fewer after so many seconds: a
/// search may have thousands in a second.
const MOST_UNTOLD: usize = 100;
const SECONDS: f64 = 0.05;

/// The names of agents.
#[derive(Clone, Debug)]
pub(crate) struct Names(Vec<String>);

impl Names {
    /// The name of an agent.
    pub(crate) fn name(&self, agent: AgentId) -> String {
        self.0.get(agent).cloned().unwrap_or_default()
    }

    /// The names of some agents.
    pub(crate) fn all(&self, agents: impl IntoIterator<Item = AgentId>) -> Vec<String> {
        agents.into_iter().map(|agent| self.name(agent)).collect()
    }

    /// An agent with the least that it needs alone.
    pub(crate) fn least(&self, agent: AgentId, least: u32) -> AgentLeast {
        AgentLeast {
            agent: self.name(agent),
            least,
        }
    }

    /// All agents with the least that each needs alone.
    pub(crate) fn with_least(&self, least: &[u32]) -> Vec<AgentLeast> {
        let agents = least.iter().enumerate();
        agents
            .map(|(agent, &least)| self.least(agent, least))
            .collect()
    }

    /// An agent with the least that it needs alone, and the most that it may have.
    pub(crate) fn limit(&self, agent: AgentId, least: u32, at_most: u32) -> AgentLimit {
        AgentLimit {
            agent: self.name(agent),
            least,
            at_most,
        }
    }
}

/// Writes events down.
pub(crate) struct Recorder {
    names: Names,
    objective: Objective,
    /// How many of the first events and of the last are kept.
    kept: (usize, usize),
    count: Cell<u64>,
    /// Conflicts of the SAT solver in the whole search, whichever part of its budget
    /// they are spent of, and whoever writes an event down.
    conflicts: Cell<u64>,
    /// The costs of which it is told what each agent needs alone.
    alone: RefCell<BTreeSet<Cost>>,
    first: RefCell<Vec<TraceEvent>>,
    /// The last events, and up to as many before them.
    last: RefCell<Vec<TraceEvent>>,
    unsent: RefCell<Vec<TraceEvent>>,
    told_at: Cell<f64>,
}

impl Recorder {
    pub(crate) const fn new(names: Vec<String>, objective: Objective) -> Self {
        Self {
            names: Names(names),
            objective,
            kept: (SearchTrace::FIRST, SearchTrace::LAST),
            count: Cell::new(0),
            conflicts: Cell::new(0),
            alone: RefCell::new(BTreeSet::new()),
            first: RefCell::new(Vec::new()),
            last: RefCell::new(Vec::new()),
            unsent: RefCell::new(Vec::new()),
            told_at: Cell::new(f64::NEG_INFINITY),
        }
    }

    /// The same, which keeps so many of the first events and of the last.
    #[cfg(test)]
    pub(super) const fn keeping(mut self, first: usize, last: usize) -> Self {
        self.kept = (first, last);
        self
    }

    pub(crate) const fn names(&self) -> &Names {
        &self.names
    }

    /// Whether it was not asked of this cost before.
    pub(crate) fn is_first_of(&self, cost: Cost) -> bool {
        self.alone.borrow_mut().insert(cost)
    }

    /// How many events there are.
    pub(crate) const fn count(&self) -> u64 {
        self.count.get()
    }

    /// Counts conflicts of the SAT solver.
    pub(crate) fn count_conflicts(&self, conflicts: u64) {
        self.conflicts.set(self.conflicts.get() + conflicts);
    }

    /// Writes an event down: its number.
    pub(crate) fn record(&self, event: SearchEvent) -> u64 {
        let number = self.count.get();
        self.count.set(number + 1);
        let event = TraceEvent {
            number,
            conflicts: self.conflicts.get(),
            text: words::sentence(&self.objective, &event),
            rules: Vec::new(),
            event,
        };
        self.unsent.borrow_mut().push(event.clone());
        let (most_first, most_last) = self.kept;
        let mut first = self.first.borrow_mut();
        if first.len() < most_first {
            first.push(event);
            return number;
        }
        let mut last = self.last.borrow_mut();
        last.push(event);
        // Seldom, so that what is left over is moved seldom.
        if last.len() >= 2 * most_last {
            last.drain(..most_last);
        }
        number
    }

    /// Whether the host is to be told of what it does not know yet.
    pub(crate) fn is_due(&self, now: impl FnOnce() -> f64) -> bool {
        let unsent = self.unsent.borrow().len();
        if unsent == 0 {
            return false;
        }
        let now = now();
        let due = unsent >= MOST_UNTOLD || now - self.told_at.get() >= SECONDS;
        if due {
            self.told_at.set(now);
        }
        due
    }

    /// The events that the host has not received yet.
    pub(crate) fn take_untold(&self) -> Vec<TraceEvent> {
        mem::take(&mut *self.unsent.borrow_mut())
    }

    /// The events so far.
    pub(crate) fn trace(&self) -> SearchTrace {
        let last = self.last.borrow();
        let from = last.len().saturating_sub(self.kept.1);
        let mut events = self.first.borrow().clone();
        events.extend(last.iter().skip(from).cloned());
        SearchTrace {
            left_out: self.count.get() - events.len() as u64,
            events,
            ..SearchTrace::new(self.objective.clone())
        }
    }
}
