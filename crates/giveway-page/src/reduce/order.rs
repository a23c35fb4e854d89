//! The order of the plan on the board: opened, looked at cell by cell, asked about lateness, saved.

use std::rc::Rc;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint, tr};
use giveway_order::Lateness;
use giveway_solve::order::{OrderAnswer, OrderFormat, OrderRequest};

use super::document::{amend, edit, keep_to_plan, settle as settle_document};
use super::{ask, change, inside};
use crate::inside::InsideAction;
use crate::order::{
    MOST_LATE, OrderAction, OrderExport, OrderKnown, first_late, gap, late_begins, visits_at,
    written,
};
use crate::{Action, BoardAction, Document, Edit, RuleEdit, Selection, State, Tab, Task, Tool};

/// An action while the order is shown: a press on the board or a step of the keyboard there
/// chooses the cell, and nothing of the scene is drawn.
pub(super) fn admit(state: &mut State, action: Action) -> Option<Action> {
    let Action::Board(action) = action else {
        return Some(action);
    };
    if !state.shows_order() {
        return Some(Action::Board(action));
    }
    let cell = match action {
        BoardAction::Press(cell) | BoardAction::Mark { cell, .. } => cell,
        BoardAction::UseTool => state.view.cursor,
        BoardAction::StepCursor { by, carries: false } => {
            let Cell { x, y } = state.view.cursor;
            let to = Cell::new(x.saturating_add_signed(by.0), y.saturating_add_signed(by.1));
            state.view.cursor = state.document.draft.clamp(to);
            state.view.cursor
        }
        BoardAction::PickTool(_) | BoardAction::PickShape(_) | BoardAction::SetMeasure(..) => {
            hide(state);
            return Some(Action::Board(action));
        }
        BoardAction::MoveCursor(_) | BoardAction::Select(_) => {
            return Some(Action::Board(action));
        }
        BoardAction::StepCursor { carries: true, .. }
        | BoardAction::Drag(_)
        | BoardAction::Release
        | BoardAction::Delete
        | BoardAction::Abandon => return None,
    };
    Some(Action::Order(OrderAction::At(cell)))
}

#[inline(never)]
pub(super) fn order(state: &mut State, action: OrderAction) {
    match action {
        OrderAction::Show(true) => show(state),
        OrderAction::Show(false) => hide(state),
        OrderAction::At(cell) => {
            state.view.order.cell = Some(state.document.draft.clamp(cell));
            state.view.cursor = state.document.draft.clamp(cell);
            state.view.selection = Selection::Nothing;
        }
        OrderAction::Late(true) => {
            state.view.order.late = first_late(state);
            ask_late(state);
        }
        OrderAction::Late(false) => {
            state.view.order.late = None;
            keep_to_plan(state);
        }
        OrderAction::Robot(place) => {
            if let Some((name, visit)) = first_visit(state, place) {
                say(state, |late| {
                    late.agent = name;
                    late.visit = visit;
                });
            }
        }
        OrderAction::Steps(steps) => say(state, |late| late.steps = steps.clamp(1, MOST_LATE)),
        OrderAction::To(visit) => say(state, |late| late.visit = visit),
        OrderAction::Replan => replan(state),
        OrderAction::Links(on) => state.view.order.is_whole = on,
        OrderAction::AddGap => add_gap(state),
        OrderAction::Save(export) => save(state, export),
    }
}

/// Opens it, and asks for what is not known.
fn show(state: &mut State) {
    let answer = state.document.fresh_answer().filter(|_| state.can_order());
    let Some(answer) = answer.cloned() else {
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
    view.ledger.is_open = false;
    view.robots.is_open = false;
    view.sizing.is_open = false;
    view.versus = None;
    view.selection = Selection::Nothing;
    view.tool = Tool::Select;
    view.tab = Tab::Inspector;
    view.order.is_open = true;
    view.order.is_whole = false;
    view.order.late = None;
    settle_document(state);
    let known = state.document.order();
    if known.is_some_and(|known| known.told.is_some()) || state.is_ordering() {
        return;
    }
    // Another plan has another busiest cell.
    state.view.order.cell = None;
    if let Some(begun) = OrderKnown::about(&answer) {
        start(state, begun);
    }
}

/// Leaves it.
fn hide(state: &mut State) {
    if state.is_ordering() {
        state.work.end();
    }
    state.view.order.is_open = false;
    state.view.order.late = None;
    settle_document(state);
}

/// The lateness becomes a breakdown, at the time at which it begins.
fn replan(state: &mut State) {
    let late = state.view.order.late.clone();
    if let (Some(late), Some(at)) = (late, late_begins(state)) {
        hide(state);
        state.view.playback.stop_at(at);
        change::break_down(state, &late.agent, late.steps);
    }
}

/// A robot's first visit of the cell that is shown; its first move where it does not pass there.
fn first_visit(state: &State, place: usize) -> Option<(String, usize)> {
    let agent = state.order()?.agents.get(place)?;
    let here = visits_at(agent, state.order_cell()?).next();
    let visit = here.unwrap_or(usize::from(agent.visits.len() > 1));
    Some((agent.agent.clone(), visit))
}

/// The sentence of lateness is said in another way.
fn say(state: &mut State, change: impl FnOnce(&mut crate::order::LateView)) {
    if let Some(late) = &mut state.view.order.late {
        change(late);
        ask_late(state);
    }
}

/// Asks what follows from the lateness, where that is not known yet.
fn ask_late(state: &mut State) {
    if state.late_plan().is_some() {
        return keep_to_plan(state);
    }
    if let Some(known) = state.order_known() {
        let asked = known.asked(lateness(state), Vec::new());
        start(state, asked);
    }
}

/// The lateness that is asked about; none where it is not.
fn lateness(state: &State) -> Vec<Lateness> {
    let said = state.view.order.late.as_ref().zip(state.order());
    let said = said.and_then(|(late, order)| late.lateness(order));
    said.into_iter().collect()
}

fn start(state: &mut State, known: OrderKnown) {
    let task = Task::Order(Rc::clone(&known.request));
    put(state, known);
    state.work.start(task);
}

/// It is no step of its own.
fn put(state: &mut State, known: OrderKnown) {
    let document = Document {
        found_order: Some(Rc::new(known)),
        ..state.document.clone()
    };
    amend(state, document);
}

fn add_gap(state: &mut State) {
    let steps = state.order().and_then(|order| gap(state, order));
    if let Some(steps) = steps {
        let rule = Constraint {
            kind: ConstraintKind::Gap { steps },
            agents: None,
            name: None,
            off: false,
        };
        hide(state);
        edit(state, Edit::Rules(RuleEdit::Put(None, rule)));
    }
}

/// Saves the order; what the solver writes is asked for.
fn save(state: &mut State, export: OrderExport) {
    let Some(known) = state.order_known() else {
        return;
    };
    let Some(told) = known.told.clone().filter(|told| told.order.is_some()) else {
        return;
    };
    match export.format() {
        None => state.intake.packed = written(state, &told, None),
        Some(format) => {
            let asked = known.asked(lateness(state), vec![format]);
            start(state, asked);
        }
    }
    state.view.order.export = export;
}

/// The solver answered.
pub(super) fn answered(state: &mut State, request: &OrderRequest, answer: OrderAnswer) {
    let Some(known) = state.document.order() else {
        return;
    };
    let mut known = (**known).clone();
    let format: Option<OrderFormat> = request.to.first().copied();
    if let Some(format) = format {
        state.intake.packed = written(state, &answer, Some(format));
    }
    known.learn(answer);
    put(state, known);
    keep_to_plan(state);
}

/// It cannot be told.
pub(super) fn refused(state: &mut State) {
    state.view.order.is_open = false;
    state.view.order.late = None;
}

/// It is shown while it is of the plan on the board and nothing else is looked at.
pub(super) fn settle(state: &mut State) {
    if !state.view.order.is_open {
        return;
    }
    let view = &state.view;
    let is_elsewhere = view.ledger.is_open
        || view.overlay.is_on
        || view.robots.is_open
        || view.sizing.is_open
        || state.is_inside();
    let known = state.document.order();
    let is_known = known.is_some_and(|known| known.told.is_some());
    if is_elsewhere || !state.can_order() || !(is_known || state.is_ordering()) {
        hide(state);
    } else if state.view.order.late.is_some() && state.late_outcome_is_lost() {
        state.view.order.late = None;
        keep_to_plan(state);
    }
}
