//! Reports to the host while a request is worked on: progress, and the trace.

use std::rc::Rc;

use giveway_model::Cost;

use super::Budget;
use crate::{
    Progress,
    trace::{Names, Recorder, SearchEvent, SearchTrace},
};

impl Budget<'_> {
    /// The same budget, whose request is told as a trace.
    pub(crate) fn traced(mut self, recorder: Recorder) -> Self {
        self.recorder = Some(Rc::new(recorder));
        self
    }

    /// The same budget, of which nothing is written down.
    pub(crate) fn unrecorded(mut self) -> Self {
        self.recorder = None;
        self
    }

    /// Tells the host that something became known.
    pub(crate) fn report(&self, event: &Progress) {
        if !self.quiet {
            self.host.progress(event);
        }
    }

    /// Writes an event down, where a trace is asked for: its number.
    pub(crate) fn record(&self, event: impl FnOnce(&Names) -> SearchEvent) -> Option<u64> {
        let recorder = self.recorder.as_ref()?;
        let number = recorder.record(event(recorder.names()));
        self.report_trace(recorder);
        Some(number)
    }

    /// Writes down what each agent needs alone of a cost, once for each cost.
    pub(crate) fn record_alone(&self, cost: Cost, least: &[u32]) {
        let Some(recorder) = &self.recorder else {
            return;
        };
        if recorder.is_first_of(cost) {
            self.record(|names| SearchEvent::Alone {
                cost,
                agents: names.with_least(least),
                at_least: match cost {
                    Cost::Makespan => least.iter().copied().max().unwrap_or(0),
                    _ => least.iter().sum(),
                },
            });
        }
    }

    /// The number that the next event gets, where a trace is asked for.
    pub(crate) fn next_event(&self) -> Option<u64> {
        self.recorder.as_ref().map(|recorder| recorder.count())
    }

    /// Whether a trace is asked for.
    pub(crate) const fn is_traced(&self) -> bool {
        self.recorder.is_some()
    }

    /// Tells the host what was written down, once in a while.
    fn report_trace(&self, recorder: &Recorder) {
        if recorder.is_due(|| self.host.wall_seconds()) {
            let events = recorder.take_untold();
            self.host.progress(&Progress::Traced { events });
        }
    }

    /// The trace so far, all of which the host has been told of now.
    pub(crate) fn trace(&self) -> Option<SearchTrace> {
        let recorder = self.recorder.as_ref()?;
        let events = recorder.take_untold();
        if !events.is_empty() {
            self.host.progress(&Progress::Traced { events });
        }
        Some(recorder.trace())
    }

    /// Tells the host the size of the work, when it has grown by a tenth.
    pub(crate) fn report_size(&self) {
        if let Some(recorder) = &self.recorder {
            self.report_trace(recorder);
        }
        let size = self.clauses.get() + 10 * self.conflicts.get();
        if size > self.reported_at.get() + self.reported_at.get() / 10 + 1000 {
            self.reported_at.set(size);
            self.report(&Progress::Size {
                variables: self.variables.get(),
                clauses: self.clauses.get(),
                conflicts: self.conflicts.get(),
            });
        }
    }
}
