//! What stands as a ghost of an area is made, as one step of undo.

use std::rc::Rc;

use giveway_model::constraint::ConstraintKind;
use giveway_model::tr_data;
use giveway_model::words::Sentence;

use super::super::document::{edit_scene, solve_on_change};
use super::without_ghost;
use crate::area::{Area, Clip, Doing, Repeat, Way};
use crate::edit::{AreaEdit, Sketch};
use crate::{Edit, Notice, State};

/// What stands as a ghost is made, as one step of undo.
pub(in crate::reduce) fn keep(state: &mut State) {
    let Some(area) = state.view.area.clone().filter(Area::has_ghost) else {
        return;
    };
    let way = Way::by(area.by);
    let edits = match &area.doing {
        Doing::Moves => vec![Edit::Area(AreaEdit::Move(Rc::clone(&area.cells), way))],
        Doing::Pastes(clip) => vec![Edit::Area(AreaEdit::Put(Rc::clone(clip), area.by))],
        Doing::Repeats(repeat) => copies(state, &area, *repeat)
            .into_iter()
            .filter_map(Result::ok)
            .collect(),
    };
    let is_made = make(state, &edits);
    let stays = matches!(area.doing, Doing::Repeats(_)) || !is_made;
    state.view.area = match &area.doing {
        Doing::Pastes(_) if !is_made => None,
        _ if stays => Some(without_ghost(area)),
        _ => Area::of(area.cells.iter().filter_map(|&cell| way.of(cell)).collect()),
    };
}

/// The copies of an area in a row, each as an edit; or why it is left out.
pub(crate) fn copies(state: &State, area: &Area, repeat: Repeat) -> Vec<Result<Edit, Sentence>> {
    let draft = &state.document.draft;
    let clip = Rc::new(Clip::of(&area.cells, draft));
    let mut sketch = Sketch::of(draft);
    let copy = |by| {
        let edit = Edit::Area(AreaEdit::Put(Rc::clone(&clip), by));
        sketch.make(&edit).map(|()| edit)
    };
    repeat.places().map(copy).collect()
}

/// Makes edits of the scene; whether they could be.
pub(super) fn make(state: &mut State, edits: &[Edit]) -> bool {
    let torn: usize = edits.iter().map(|edit| torn(state, edit)).sum();
    let is_first = state.document.draft.clone();
    match edit_scene(state, edits) {
        Ok(()) => {
            if !Rc::ptr_eq(&is_first, &state.document.draft)
                && torn > 0
                && state.view.notice.is_none()
            {
                state.view.notice = Some(Notice::information(tr_data!(
                    "{n} one-way lane lies only partly there and stays."
                        | "{n} one-way lanes lie only partly there and stay." % torn
                )));
            }
            solve_on_change(state);
            true
        }
        Err(notice) => {
            state.view.notice = Some(notice);
            false
        }
    }
}

/// How many lanes lie only partly where an edit moves something.
fn torn(state: &State, edit: &Edit) -> usize {
    let Edit::Area(AreaEdit::Move(cells, _)) = edit else {
        return 0;
    };
    let rules = state.document.draft.scene().constraints.iter();
    let is_torn = rules.filter(|rule| match &rule.kind {
        ConstraintKind::OneWay { lane } => {
            let inside = lane.iter().filter(|cell| cells.contains(cell)).count();
            inside > 0 && inside < lane.len()
        }
        _ => false,
    });
    is_torn.count()
}
