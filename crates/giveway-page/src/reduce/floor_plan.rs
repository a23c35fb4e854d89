//! A floor plan under the grid: laid, said in another way, turned into cells.

use std::rc::Rc;

use giveway_model::tr_data;

use super::ask;
use super::document::{edit, make};
use crate::floor_plan::{self, FloorPlan, FloorPlanAction, card};
use crate::{Edit, Selection, State, Tool};

#[inline(never)]
pub(super) fn floor_plan(state: &mut State, action: &FloorPlanAction) {
    match action {
        FloorPlanAction::Lay(picture, metres) => {
            if !state.can_place_fleet() {
                let why =
                    tr_data!("A floor plan can be laid where the scene itself is on the board.");
                return ask::refuse(state, why);
            }
            let plan = FloorPlan::laid(Rc::clone(picture), *metres, state);
            ask::close(state);
            super::fleet::settle(state);
            state.view.notice = None;
            state.view.selection = Selection::Nothing;
            state.view.tool = Tool::Select;
            state.view.floor_plan = Some(Rc::new(plan));
        }
        FloorPlanAction::Restore(picture, text) => {
            if state.view.floor_plan.is_none() && state.lesson().is_none() {
                let plan = floor_plan::read(text, Rc::clone(picture), state);
                state.view.floor_plan = plan.map(Rc::new);
            }
        }
        FloorPlanAction::Draw => {
            let draft = &state.document.draft;
            let drawn = state.open_plan().and_then(|plan| {
                let units = plan
                    .units(draft.scene())
                    .map(|units| Edit::Units(Some(units)));
                Some([Some(plan.edit(draft)?), units])
            });
            if let Some(edits) = drawn {
                let edits: Vec<Edit> = edits.into_iter().flatten().collect();
                make(state, &edits);
                change(state, |plan| Some(plan.drawn()));
            }
        }
        FloorPlanAction::Grow => grow(state),
        FloorPlanAction::Cancel => change(state, |plan| plan.left(false)),
        FloorPlanAction::Remove => state.view.floor_plan = None,
        FloorPlanAction::Open => {
            ask::close(state);
            state.view.selection = Selection::Nothing;
            state.view.tool = Tool::Select;
            change(state, |plan| Some(plan.with(action)));
        }
        FloorPlanAction::Move(..)
        | FloorPlanAction::Left(_)
        | FloorPlanAction::Top(_)
        | FloorPlanAction::Wide(_)
        | FloorPlanAction::Turn
        | FloorPlanAction::Point(..)
        | FloorPlanAction::Apart(_)
        | FloorPlanAction::CellSize(_)
        | FloorPlanAction::Threshold(_)
        | FloorPlanAction::Becomes(_)
        | FloorPlanAction::Show(_) => change(state, |plan| Some(plan.with(action))),
    }
}

/// The map grows until all of the picture is on it.
fn grow(state: &mut State) {
    let grid = state.document.draft.grid();
    if let Some((width, height)) = state.open_plan().and_then(|plan| plan.grown(grid)) {
        edit(state, Edit::Resize(width, height));
    }
}

/// The picture stays as it lies; the column is left.
pub(super) fn settle(state: &mut State) {
    change(state, |plan| plan.left(true));
}

/// A cell that is pressed is turned over, while the picture is turned into cells.
pub(super) fn takes_cell(state: &mut State, selection: Selection) -> bool {
    let (Selection::Cell(cell), true) = (selection, card(state).is_some()) else {
        return false;
    };
    let cell = state.document.draft.clamp(cell);
    change(state, |plan| Some(plan.turn_over(cell)));
    true
}

fn change(state: &mut State, change: impl FnOnce(FloorPlan) -> Option<FloorPlan>) {
    let plan = state.view.floor_plan.take().map(Rc::unwrap_or_clone);
    state.view.floor_plan = plan.and_then(change).map(Rc::new);
}
