//! What all best plans share: asked of the plan on the board, laid over it, and what closing a
//! cell comes to.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_solve::Limits;
use giveway_solve::freedom::FreedomAnswer;

use super::document::{amend, edit_scene, settle, undo};
use super::{ask, inside, solve};
use crate::edit::{Edit, Paint};
use crate::freedom::{ClosedCell, Freedom, FreedomAction, closing, is_done, refusal};
use crate::inside::InsideAction;
use crate::{Document, Selection, State, Tab, Task};

#[inline(never)]
pub(super) fn freedom(state: &mut State, action: FreedomAction) {
    match action {
        FreedomAction::Show(true) => {
            if show(state) {
                state.view.selection = Selection::Nothing;
                state.view.tab = Tab::Inspector;
            }
        }
        FreedomAction::Show(false) => hide(state),
        FreedomAction::Ask => drop(show(state)),
        FreedomAction::GoOn => go_on(state),
        FreedomAction::ShowOther(on) => {
            state.view.overlay.shows_other = on;
            settle(state);
        }
        FreedomAction::Close(cell) => close(state, cell),
        FreedomAction::Open => open(state),
    }
}

fn limits(state: &State) -> Limits {
    Limits {
        seconds: Some(f64::from(state.settings.seconds)),
        ..Limits::default()
    }
}

/// Lays it over the plan, and asks for what is not known. Whether it can.
fn show(state: &mut State) -> bool {
    if let Some(why) = refusal(state) {
        ask::refuse(state, why);
        return false;
    }
    ask::close(state);
    if state.inside.is_open {
        inside::inside(state, InsideAction::Show(false));
    }
    state.view.notice = None;
    state.view.playback.playing = false;
    state.view.overlay.is_on = true;
    state.view.ledger.is_open = false;
    state.view.overlay.shows_other = false;
    let known = state.document.freedom();
    if known.is_some_and(|known| known.told.is_some() || state.is_counting()) {
        return true;
    }
    let answer = state.document.fresh_answer();
    if let Some(begun) = answer.and_then(|answer| Freedom::about(answer, limits(state))) {
        begin(state, begun);
    }
    true
}

/// Takes it away; what is not known then need not be looked for.
fn hide(state: &mut State) {
    if state.is_counting() {
        state.work.end();
    }
    state.view.overlay.is_on = false;
    settle(state);
}

/// Looks for what is open.
fn go_on(state: &mut State) {
    let Some(known) = state.freedom().filter(|_| !state.is_counting()) else {
        return;
    };
    if known.told.as_deref().is_some_and(is_done) {
        return;
    }
    let begun = known.going_on(limits(state));
    begin(state, begun);
}

fn begin(state: &mut State, begun: Freedom) {
    let task = Task::Freedom(Rc::clone(&begun.request));
    put(state, begun);
    state.work.start(task);
}

/// It is no step of its own.
fn put(state: &mut State, freedom: Freedom) {
    let document = Document {
        found_freedom: Some(Rc::new(freedom)),
        ..state.document.clone()
    };
    amend(state, document);
}

/// More became known.
pub(super) fn learn(state: &mut State, told: FreedomAnswer) {
    if let Some(known) = state.document.freedom() {
        let mut known = (**known).clone();
        known.learn(told);
        put(state, known);
    }
}

/// It cannot be told: then nothing is laid over the plan.
pub(super) fn refused(state: &mut State) {
    state.view.overlay.is_on = false;
}

/// Closes a cell, as a step that [`open`] takes back, and shows the best plan then.
fn close(state: &mut State, cell: Cell) {
    let Some(sentence) = closing(state, cell) else {
        return;
    };
    let Some(before) = state.document.fresh_answer().cloned() else {
        return;
    };
    let goes_on = state.is_counting();
    let edit = Edit::Paint(Paint::Obstacle, cell, true);
    if let Err(notice) = edit_scene(state, &[edit]) {
        state.view.notice = Some(notice);
        return;
    }
    solve::start(state, solve::Start::quiet());
    state.view.selection = Selection::Nothing;
    state.view.overlay.closed = Some(Rc::new(ClosedCell {
        cell,
        sentence,
        draft: Rc::clone(&state.document.draft),
        before,
        goes_on,
    }));
}

/// Opens the cell again that was closed for a look.
fn open(state: &mut State) {
    let Some(goes_on) = state.closed_cell().map(|closed| closed.goes_on) else {
        return;
    };
    // What was done since goes, too.
    while state.closed_cell().is_some() && !state.history.past().is_empty() {
        undo(state);
    }
    state.view.overlay.closed = None;
    if goes_on {
        go_on(state);
    }
}
