//! The proof of the search: its events as steps, as a chart, and on the board.

mod chart;
mod closer;
mod column;
mod means;
mod rows;
mod seen;
mod why;

use giveway_solve::trace::{SearchEvent, SearchTrace, TraceEvent};

pub use chart::{Chart, Dot, Tick, chart};
pub(crate) use closer::{unknown_core, view_alone};
pub(crate) use column::{column, step_text};
pub use rows::{Kind, ProofRow, rows};
pub(crate) use seen::overlay;

use crate::State;

/// The trace that is looked at: of the search that runs, of the plan on the board, or of
/// some of its robots alone. `None` where there is none: that of another plan is none.
pub(crate) fn trace(state: &State) -> Option<&SearchTrace> {
    let run = state.work.solving().filter(|run| run.planner.is_none());
    let whole = match run {
        Some(run) => run.trace.as_deref(),
        None => state.document.fresh_answer()?.solved.trace.as_ref(),
    }?;
    Some(closer::alone_trace(state).unwrap_or(whole))
}

/// Whether the search still runs.
pub(crate) fn is_running(state: &State) -> bool {
    let run = state.work.solving();
    state.inside.alone.is_none() && run.is_some_and(|run| run.planner.is_none())
}

/// Whether an event is a step that is shown: a round by itself tells nothing.
const fn is_step(event: &SearchEvent) -> bool {
    !matches!(event, SearchEvent::Round { .. })
}

/// The steps of a trace.
pub(crate) fn steps(trace: &SearchTrace) -> impl DoubleEndedIterator<Item = &TraceEvent> {
    trace.events.iter().filter(|event| is_step(&event.event))
}

/// The row of the step that is chosen, and that of the last one.
pub(crate) fn chosen(state: &State) -> Option<(usize, usize)> {
    let last = steps(trace(state)?).count().checked_sub(1)?;
    Some((state.inside.step.unwrap_or(last).min(last), last))
}

/// The step that is chosen.
pub(crate) fn chosen_event(state: &State) -> Option<&TraceEvent> {
    let (at, _) = chosen(state)?;
    steps(trace(state)?).nth(at)
}
