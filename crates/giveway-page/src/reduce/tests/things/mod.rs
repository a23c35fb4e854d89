//! Agents, goals and waypoints by hand: one gesture is one step of undo.

mod moved;
mod placed;

use giveway_model::{Agent, Cell};

use crate::{Action, BoardAction, State};

fn agent(state: &State, index: usize) -> &Agent {
    &state.document.draft.agents()[index]
}

fn key(x: u32, y: u32) -> [Action; 2] {
    let cell = Cell::new(x, y);
    [
        Action::Board(BoardAction::MoveCursor(cell)),
        Action::Board(BoardAction::UseTool),
    ]
}
