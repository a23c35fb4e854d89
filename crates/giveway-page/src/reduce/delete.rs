//! The key Delete: it removes what is selected, or a sentence says why it cannot.

use giveway_model::tr_data;

use super::{area, ask, document, press, steer, stroke};
use crate::area::AreaAction;
use crate::rules::Lit;
use crate::{Edit, RuleEdit, Selection, State, Tool};

/// Removes the robot that is selected, or what is on the cell that is; where nothing is, the
/// rule or the zone that is lit.
pub(super) fn delete(state: &mut State) {
    if steer::is_in_the_way(state) {
        return;
    }
    if state.has_area() {
        return area::area(state, AreaAction::Erase);
    }
    match state.view.selection {
        Selection::Nothing => match state.lit_rule().cloned() {
            Some(Lit::Rule(index)) => {
                document::edit(state, Edit::Rules(RuleEdit::Remove(index)));
            }
            Some(Lit::Zone(name)) => {
                document::edit(state, Edit::Rules(RuleEdit::RemoveZone(name)));
            }
            None => ask::refuse(
                state,
                tr_data!("Select a robot or a cell first. Then Delete removes it."),
            ),
        },
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
