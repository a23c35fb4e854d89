//! Edits of the scene: each is one step of undo, makes an answer stale, and
//! ends a solve that was under way.

use std::rc::Rc;

use giveway_model::{Cell, Scene};

use super::{ask, solve};
use crate::ground::Brush;
use crate::state::Stroke;
use crate::{Draft, Notice, Selection, State};

/// A scene of more agents opens without the plan table.
const MANY: usize = 6;

/// Replaces the scene, if it can be drawn and solved.
pub(super) fn open(state: &mut State, scene: Scene) {
    let refused = |faults: &[giveway_model::Fault]| Notice {
        sentence: "The scene cannot be opened.".to_owned(),
        details: faults.iter().map(ToString::to_string).collect(),
    };
    let draft = match Draft::new(scene) {
        Ok(draft) => draft,
        Err(faults) => {
            state.notice = Some(refused(&faults));
            return;
        }
    };
    if let Err(faults) = draft.instance() {
        state.notice = Some(refused(faults));
        return;
    }
    release(state);
    state.notice = None;
    state.answer = None;
    state.asking = None;
    state.selection = Selection::Nothing;
    // A horizon is for one scene; the other limits are for all.
    state.settings.within = None;
    // Of many agents a table is long: the board keeps its room.
    state.view.table &= draft.agents().len() <= MANY;
    state.playback.time = 0;
    state.playback.playing = false;
    replace(state, draft);
    state.cursor = state.draft.clamp(state.cursor);
}

/// Changes the scene by a function; nothing happens where it changes nothing.
pub(super) fn change(state: &mut State, edit: impl FnOnce(&mut Scene)) {
    release(state);
    let mut scene = state.draft.scene().clone();
    edit(&mut scene);
    if scene == *state.draft.scene() {
        return;
    }
    if let Ok(draft) = Draft::new(scene) {
        replace(state, draft);
        settled(state);
    }
}

/// Begins a stroke of the brush.
pub(super) fn press(state: &mut State, cell: Cell) {
    release(state);
    let Some(brush) = Brush::begin(state.draft.scene(), state.tool, cell) else {
        return;
    };
    state.stroke = Some(Stroke {
        brush,
        at: cell,
        before: Rc::clone(&state.draft),
    });
    drag(state, cell);
}

/// Takes the brush on to a cell.
pub(super) fn drag(state: &mut State, cell: Cell) {
    let cell = state.draft.clamp(cell);
    let Some(stroke) = &mut state.stroke else {
        return;
    };
    let from = std::mem::replace(&mut stroke.at, cell);
    state.cursor = cell;
    let Some(scene) = stroke.brush.stroke(state.draft.scene(), from, cell) else {
        return;
    };
    if let Ok(draft) = Draft::new(scene) {
        ask::close(state);
        solve::cancel(state);
        state.playback.playing = false;
        state.draft = Rc::new(draft);
    }
}

/// Ends a stroke.
pub(super) fn release(state: &mut State) {
    let Some(stroke) = state.stroke.take() else {
        return;
    };
    if *stroke.before != *state.draft {
        state.history.record(stroke.before);
        settled(state);
    }
}

pub(super) fn undo(state: &mut State) {
    release(state);
    let present = Rc::clone(&state.draft);
    if let Some(draft) = state.history.undo(present) {
        travel(state, draft);
    }
}

pub(super) fn redo(state: &mut State) {
    release(state);
    let present = Rc::clone(&state.draft);
    if let Some(draft) = state.history.redo(present) {
        travel(state, draft);
    }
}

fn travel(state: &mut State, draft: Rc<Draft>) {
    ask::close(state);
    solve::cancel(state);
    state.playback.playing = false;
    state.draft = draft;
    state.cursor = state.draft.clamp(state.cursor);
    forget_missing(state);
    settled(state);
}

fn replace(state: &mut State, draft: Draft) {
    ask::close(state);
    solve::cancel(state);
    state.playback.playing = false;
    let before = std::mem::replace(&mut state.draft, Rc::new(draft));
    state.history.record(before);
    forget_missing(state);
}

/// An agent that is no longer there is not selected.
fn forget_missing(state: &mut State) {
    if let Selection::Agent(agent) = state.selection
        && agent >= state.draft.agents().len()
    {
        state.selection = Selection::Nothing;
    }
}

/// After an edit as a whole.
fn settled(state: &mut State) {
    if state.settings.solve_on_change && state.is_stale() {
        solve::start(state);
    }
}
