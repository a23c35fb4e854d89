//! Several robots at once: drawn in rows, said in a sentence, added.

use giveway_model::Cell;

use super::document::edit;
use crate::fleet::{Fleet, FleetAction};
use crate::gesture::Gesture;
use crate::{Edit, Selection, State};

#[inline(never)]
pub(super) fn fleet(state: &mut State, action: FleetAction) {
    match action {
        FleetAction::Add => settle(state),
        FleetAction::Cancel => state.view.fleet = None,
        FleetAction::Count(_)
        | FleetAction::Back(_)
        | FleetAction::Waypoints(_)
        | FleetAction::DrawAgain
        | FleetAction::Battery(_)
        | FleetAction::Level(_) => {
            state.view.fleet = state.view.fleet.take().map(|fleet| fleet.with(action));
        }
    }
}

/// A row begins at a cell: of starts, then of goals. Robots that have both come onto the board.
pub(super) fn press(state: &mut State, cell: Cell) {
    if state.view.fleet.as_ref().is_some_and(Fleet::has_goals) {
        settle(state);
    }
    let every = state.robot_every();
    match &mut state.view.fleet {
        Some(fleet) => fleet.begin_goals(cell),
        None => state.view.fleet = Some(Fleet::begin(cell, every, &state.document.draft)),
    }
    state.view.notice = None;
    state.view.selection = Selection::Nothing;
    state.view.cursor = cell;
    state.view.gesture = Gesture::Row;
}

/// What is open is kept: robots whose goals are known come onto the board, others do not.
pub(super) fn settle(state: &mut State) {
    let agents = state.fleet_agents();
    let Some(fleet) = state.view.fleet.take() else {
        return;
    };
    if fleet.has_goals() && !agents.is_empty() {
        edit(state, Edit::AddAgents(agents));
    }
}
