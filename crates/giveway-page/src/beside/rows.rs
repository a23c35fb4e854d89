//! The differences of two plans as a list, in the inspector.

use giveway_model::words::and;

use super::Difference;
use crate::State;

/// The most differences with a row of their own.
pub(super) const ROWS: usize = 12;

/// A difference in the inspector.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DifferenceRow {
    /// Its time, in steps.
    pub time: u32,
    /// Who, in words.
    pub who: String,
    /// Whether it is the last one up to the time shown.
    pub is_now: bool,
}

/// The differences with a row each, in the inspector.
pub(crate) fn rows(state: &State) -> Vec<DifferenceRow> {
    let Some((this, _)) = state.compared() else {
        return Vec::new();
    };
    let time = state.view.playback.time;
    let differences = state.differences();
    let passed = differences.iter().filter(|it| it.time <= time).count();
    let row = |(place, it): (usize, &Difference)| {
        let names = it
            .agents
            .iter()
            .filter_map(|&agent| this.agents().get(agent));
        let names: Vec<&str> = names.map(|agent| agent.name.as_str()).collect();
        DifferenceRow {
            time: it.time,
            who: and(&names),
            is_now: place + 1 == passed,
        }
    };
    differences.iter().take(ROWS).enumerate().map(row).collect()
}
