//! The key Delete: it removes what is selected, or a sentence says why it cannot.

use giveway_model::tr_data;

use super::{ask, document, press, steer, stroke};
use crate::{Edit, Selection, State, Tool};

/// Removes the robot that is selected, or what is on the cell that is.
pub(super) fn delete(state: &mut State) {
    if steer::is_in_the_way(state) {
        return;
    }
    match state.view.selection {
        Selection::Nothing => ask::refuse(
            state,
            tr_data!("Select a robot or a cell first. Then Delete removes it."),
        ),
        Selection::Agent(agent) if state.is_there(agent) => {
            document::edit(state, Edit::RemoveAgent(agent));
        }
        Selection::Agent(_) => {
            ask::refuse(
                state,
                tr_data!("This robot is not there at the time shown."),
            );
        }
        Selection::Cell(cell) => {
            let tool = std::mem::replace(&mut state.view.tool, Tool::Erase);
            press::press(state, cell);
            stroke::release(state);
            state.view.tool = tool;
        }
    }
}
