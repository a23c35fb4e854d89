//! Where an agent is at the time shown.

use std::rc::Rc;

use giveway_model::{Cell, Plan};

use crate::{Answer, State};

/// The cell of an agent at the time shown: where the plan has it then (in transit
/// the cell that it leaves), or its start without a plan. `None` for one that is
/// not there.
pub(crate) fn place_of(state: &State, agent: usize) -> Option<Cell> {
    place_in(state, state.shown(), agent)
}

/// The same in the plan of an answer.
pub(super) fn place_in(state: &State, answer: Option<&Rc<Answer>>, agent: usize) -> Option<Cell> {
    let draft = state.world();
    let own = draft
        .agents()
        .get(agent)
        .filter(|_| state.is_there(agent))?;
    let shown = answer.filter(|answer| answer.agent(draft, agent).is_some());
    let Some(plan) = shown.and_then(|answer| answer.plan()) else {
        return Some(own.start);
    };
    let last = last_cell(plan, &own.name, state.view.playback.time);
    Some(last.unwrap_or(own.start))
}

/// The cell of an agent in a plan at a time; in transit the cell that it leaves.
pub(super) fn last_cell(plan: &Plan, agent: &str, time: u32) -> Option<Cell> {
    let path = plan.path(agent);
    let from = plan.from.get(agent).copied().unwrap_or(0);
    let time = time.saturating_sub(from) as usize;
    let until = path.get(..=time).unwrap_or(path);
    until.iter().rev().find_map(|cell| *cell)
}
