//! Who costs whom: asked of the plan on the board, looked at, left.

use std::rc::Rc;

use giveway_model::tr;
use giveway_solve::Limits;
use giveway_solve::delays::DelaysAnswer;

use super::document::{amend, settle};
use super::{ask, inside};
use crate::inside::InsideAction;
use crate::ledger::{Ledger, LedgerAction, LedgerView};
use crate::{Activity, Document, Selection, State, Tab, Task};

#[inline(never)]
pub(super) fn ledger(state: &mut State, action: LedgerAction) {
    match action {
        LedgerAction::Show(true) => show(state),
        LedgerAction::Show(false) => hide(state),
        LedgerAction::Turn(on) => {
            state.view.ledger.is_turned = on;
            state.view.ledger.lit = None;
        }
        LedgerAction::Light(lit) => state.view.ledger.lit = lit,
        LedgerAction::AddUp => add_up(state),
    }
}

/// Opens it, and asks for what is not known.
fn show(state: &mut State) {
    let is_editing = state.document.mode.activity == Activity::Editing;
    let answer = state.document.fresh_answer().filter(|_| is_editing);
    let Some(answer) = answer.filter(|answer| answer.plan().is_some()).cloned() else {
        return ask::refuse(state, tr!("Solve first: questions are about a plan."));
    };
    ask::close(state);
    if state.inside.is_open {
        inside::inside(state, InsideAction::Show(false));
    }
    let view = &mut state.view;
    view.notice = None;
    view.playback.playing = false;
    view.overlay.is_on = false;
    view.selection = Selection::Nothing;
    view.tab = Tab::Inspector;
    view.ledger = LedgerView {
        is_open: true,
        ..LedgerView::default()
    };
    settle(state);
    let known = state.document.ledger();
    let is_coming = |known: &Rc<Ledger>| state.is_adding_up() && !known.is_of_report;
    if known.is_some_and(|known| known.is_whole() || is_coming(known)) {
        return;
    }
    let limits = Limits {
        seconds: Some(f64::from(state.settings.seconds)),
        ..Limits::default()
    };
    start(state, Ledger::about(&answer, limits));
}

/// Adds up for a report, where nothing else is being done.
fn add_up(state: &mut State) {
    let known = state.document.ledger();
    let is_known = known.is_some_and(|known| known.told.is_some());
    let is_free = state.work.task().is_none() && state.document.mode.activity == Activity::Editing;
    if let (true, false, Some(answer)) = (is_free, is_known, state.document.fresh_answer()) {
        let begun = Ledger::of_report(answer);
        start(state, begun);
    }
}

fn start(state: &mut State, begun: Option<Ledger>) {
    if let Some(begun) = begun {
        let task = Task::Delays(Rc::clone(&begun.request));
        put(state, begun);
        state.work.start(task);
    }
}

/// Leaves it; what is not known then need not be looked for.
fn hide(state: &mut State) {
    if state.is_adding_up() {
        state.work.end();
    }
    state.view.ledger.is_open = false;
    settle(state);
}

/// It is no step of its own.
fn put(state: &mut State, ledger: Ledger) {
    let document = Document {
        found_ledger: Some(Rc::new(ledger)),
        ..state.document.clone()
    };
    amend(state, document);
}

/// More became known of the ledger, and perhaps of the plan.
pub(super) fn learn(state: &mut State, told: DelaysAnswer) {
    if let Some(known) = state.document.ledger() {
        let raised = known.raised(&told);
        let mut known = (**known).clone();
        known.learn(told);
        put(state, known);
        if let Some(solved) = raised {
            amend(state, state.document.clone().with_more_proved(solved));
        }
    }
}

/// It cannot be told.
pub(super) fn refused(state: &mut State) {
    state.view.ledger.is_open = false;
}
