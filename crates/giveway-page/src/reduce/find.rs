//! A robot is found by its name; cells are brought into view.

use giveway_model::Cell;

use super::board;
use crate::find::{Find, FindAction, broken_down, chosen, count};
use crate::view::Sought;
use crate::{Selection, State};

#[inline(never)]
pub(super) fn find(state: &mut State, action: FindAction) {
    match action {
        FindAction::Open => {
            if !state.world().agents().is_empty() {
                state.view.find = Some(Find::default());
            }
        }
        FindAction::Type(typed) => {
            if let Some(find) = &mut state.view.find {
                *find = Find { typed, chosen: 0 };
                select(state);
            }
        }
        FindAction::Step { on } => {
            let count = count(state);
            if let Some(find) = &mut state.view.find {
                find.step(count, on);
                select(state);
            }
        }
        FindAction::Close => state.view.find = None,
    }
}

/// Selects the robot that was found, or its cell, and brings it into view.
fn select(state: &mut State) {
    let Some(agent) = chosen(state) else { return };
    // One that has broken down for good is an obstacle by now.
    if let Some(cell) = broken_down(state, Some(agent)) {
        board::select(state, Selection::Cell(cell));
        return show(state, cell);
    }
    board::select(state, Selection::Agent(agent));
    if let Some(cell) = crate::board::place_of(state, agent) {
        show(state, cell);
    }
}

/// Brings a cell into view; the keyboard goes there, too.
pub(super) fn show(state: &mut State, cell: Cell) {
    let view = &mut state.view;
    view.cursor = state.document.draft.clamp(cell);
    let number = view.sought.map_or(0, |sought| sought.number);
    view.sought = Some(Sought {
        cell: view.cursor,
        number: number.wrapping_add(1),
    });
}
