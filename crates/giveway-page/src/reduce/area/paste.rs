//! What was copied stands as a ghost, which moves and turns until it is made.

use std::rc::Rc;

use giveway_model::tr_data;

use super::super::{ask, stroke};
use super::{keep, select};
use crate::State;
use crate::area::{Area, Doing, Way, frame};

pub(super) fn paste(state: &mut State) {
    let Some(clip) = state.view.clip.clone() else {
        return;
    };
    stroke::release(state);
    keep(state);
    let grid = state.document.draft.grid();
    let [x0, y0, x1, y1] = frame(&clip.cells);
    if x1 - x0 >= grid.width() || y1 - y0 >= grid.height() {
        let why = tr_data!(
            "What was copied, {width} \u{d7} {height} cells, is larger than the floor.",
            width = x1 - x0 + 1,
            height = y1 - y0 + 1
        );
        return ask::refuse(state, why);
    }
    let pasted = Area::pasted(&clip, state.view.cursor, grid);
    select(state, Some(pasted));
}

/// The ghost of what is pasted, mirrored or turned; `None` where nothing is.
pub(super) fn turned(state: &State, way: impl Fn(&Area) -> Way) -> Option<Area> {
    let area = state.view.area.as_ref()?;
    let Doing::Pastes(clip) = &area.doing else {
        return None;
    };
    let clip = Rc::new(clip.turned(way(area)));
    let turned = Area {
        cells: Rc::clone(&clip.cells),
        by: (0, 0),
        doing: Doing::Pastes(clip),
    };
    Some(turned.moved(area.by, state.document.draft.grid()))
}

/// What stands as a ghost is made; what cannot be pasted here stays in the hand.
pub(super) fn make(state: &mut State) {
    let ghost = state.view.area.clone();
    let ghost = ghost.filter(|area| matches!(area.doing, Doing::Pastes(_)));
    keep(state);
    state.view.area = state.view.area.take().or(ghost);
}
