//! How many robots the floor bears: said, solved, looked at, taken.

use std::rc::Rc;

use giveway_model::{Cell, tr_data};
use giveway_solve::sizing::{SizingAnswer, SizingFloor, SizingPoint};

use super::document::{put, settle as settle_document};
use super::{ask, fleet, inside, only_looks};
use crate::inside::InsideAction;
use crate::sizing::{Looked, Said, SizingAction, SizingRun};
use crate::{Action, Answer, BoardAction, Document, Selection, SolveAction, State, Tab, Task};

/// An action while a plan of more robots is on the board: what only looks is let through; all
/// else happens to the own document, which comes back before. A press on the board may be a cell
/// of the sentence.
pub(super) fn admit(state: &mut State, action: Action) -> Option<Action> {
    if state.view.sizing.is_picking
        && state.shows_sizing()
        && let Action::Board(action) = &action
    {
        return picked(state, action);
    }
    if state.view.sizing.looked.is_none() {
        return Some(action);
    }
    if matches!(
        action,
        Action::Board(BoardAction::Select(_) | BoardAction::MoveCursor(_))
    ) {
        return None;
    }
    let looks = only_looks(&action)
        || matches!(
            action,
            Action::Sizing(_) | Action::Find(_) | Action::Slot(_)
        )
        || matches!(action, Action::Solve(SolveAction::Cancel));
    if !looks {
        back(state);
    }
    Some(action)
}

/// A press on the board is the cell of the sentence; what else the hand does there is nothing.
fn picked(state: &mut State, action: &BoardAction) -> Option<Action> {
    let cell = match action {
        BoardAction::Press(cell)
        | BoardAction::Mark { cell, .. }
        | BoardAction::Select(Selection::Cell(cell)) => *cell,
        BoardAction::UseTool => state.view.cursor,
        BoardAction::Select(Selection::Agent(agent)) => {
            state.document.draft.agents().get(*agent)?.start
        }
        BoardAction::StepCursor { .. } | BoardAction::MoveCursor(_) => {
            return Some(Action::Board(action.clone()));
        }
        BoardAction::PickTool(_) | BoardAction::PickShape(_) | BoardAction::SetMeasure(..) => {
            state.view.sizing.is_picking = false;
            return Some(Action::Board(action.clone()));
        }
        BoardAction::Drag(_)
        | BoardAction::Release
        | BoardAction::Delete
        | BoardAction::Abandon
        | BoardAction::Select(Selection::Nothing) => return None,
    };
    Some(Action::Sizing(SizingAction::Picked(cell)))
}

#[inline(never)]
pub(super) fn sizing(state: &mut State, action: SizingAction) {
    match action {
        SizingAction::Show(true) => show(state),
        SizingAction::Show(false) => hide(state),
        SizingAction::Pick(on) => state.view.sizing.is_picking = on,
        SizingAction::Picked(cell) => pick(state, cell),
        SizingAction::Solve => solve(state),
        SizingAction::Cancel => {
            if state.is_sizing() {
                state.work.end();
            }
        }
        SizingAction::Look(Some(place)) => look(state, place),
        SizingAction::Look(None) => back(state),
        SizingAction::Take => take(state),
        SizingAction::From(_)
        | SizingAction::To(_)
        | SizingAction::By(_)
        | SizingAction::Back(_)
        | SizingAction::Waypoints(_)
        | SizingAction::Battery(_)
        | SizingAction::Level(_)
        | SizingAction::Seconds(_)
        | SizingAction::DrawAgain
        | SizingAction::Beside(_) => say(state, action),
    }
}

/// Opens it; what is asked first follows from the floor, or from robots drawn in rows.
fn show(state: &mut State) {
    if !state.can_size() {
        return ask::refuse(state, tr_data!("This is asked about a scene of your own."));
    }
    let is_drawn = state
        .view
        .fleet
        .as_ref()
        .is_some_and(crate::fleet::Fleet::has_goals);
    if is_drawn || state.view.sizing.said.is_none() {
        state.view.sizing.said = Some(Said::begin(state));
    }
    if is_drawn {
        // Robots that were drawn to be asked about need not come onto the board.
        state.view.fleet = None;
    }
    fleet::settle(state);
    ask::close(state);
    if state.inside.is_open {
        inside::inside(state, InsideAction::Show(false));
    }
    state.view.notice = None;
    state.view.robots.is_open = false;
    state.view.ledger.is_open = false;
    state.view.overlay.is_on = false;
    state.view.selection = Selection::Nothing;
    state.view.tab = Tab::Inspector;
    state.view.sizing.is_open = true;
}

/// Leaves it; what is being solved is stopped, what is known stays.
fn hide(state: &mut State) {
    back(state);
    if state.is_sizing() {
        state.work.end();
    }
    state.view.sizing.is_open = false;
    state.view.sizing.is_picking = false;
}

/// Another sentence: what was found of the one before goes.
fn say(state: &mut State, action: SizingAction) {
    back(state);
    if state.is_sizing() {
        state.work.end();
    }
    let view = &mut state.view.sizing;
    view.is_picking = false;
    view.run = None;
    if let Some(said) = &mut view.said {
        said.say(action);
    }
}

fn pick(state: &mut State, cell: Cell) {
    let grid = state.own_document().draft.grid();
    if grid.is_vertex(cell) {
        say(state, SizingAction::Picked(cell));
    } else {
        ask::refuse(state, tr_data!("No charger can stand on an obstacle."));
    }
}

fn solve(state: &mut State) {
    back(state);
    let said = state.view.sizing.said.clone();
    let Some(run) = said.and_then(|said| SizingRun::begin(state, &said)) else {
        let why = tr_data!("There is no room for these robots, or the floor has a fault.");
        return ask::refuse(state, why);
    };
    state.view.notice = None;
    let task = Task::Sizing(Rc::clone(&run.request));
    state.view.sizing.run = Some(Rc::new(run));
    state.work.start(task);
}

/// The plan of so many robots comes onto the board; the own document is put aside.
fn look(state: &mut State, place: usize) {
    let Some(answer) = state.sizing().and_then(|run| run.answered(place)) else {
        return;
    };
    let own = state.own_document().clone();
    let shown = Document::answered(Rc::clone(&answer.draft), Some(answer));
    state.document = Document {
        within: own.within,
        ..shown
    };
    state.view.sizing.looked = Some(Looked { place, own });
    state.view.selection = Selection::Nothing;
    state.view.playback.playing = false;
    settle_document(state);
}

/// The own document comes back.
pub(super) fn back(state: &mut State) {
    if let Some(looked) = state.view.sizing.looked.take() {
        state.document = looked.own;
        state.view.playback.playing = false;
        settle_document(state);
    }
}

/// The robots that are looked at become those of the scene, with their plan, as one step of undo.
fn take(state: &mut State) {
    let Some(place) = state.view.sizing.looked.as_ref().map(|looked| looked.place) else {
        return;
    };
    let run = state.view.sizing.run.clone();
    back(state);
    let Some(run) = run else { return };
    let Some(answer) = run.answered(place) else {
        return;
    };
    let mut after = state.document.clone();
    after.set_draft((*answer.draft).clone());
    let answer = Answer {
        draft: Rc::clone(&after.draft),
        ..(*answer).clone()
    };
    after.answer = Some(Rc::new(answer));
    let lost = crate::rules::lost(&state.document.draft, &after.draft);
    state.view.notice = lost;
    put(state, after);
    state.view.sizing.is_open = false;
    state.view.sizing.run = None;
}

/// One more plan is there.
pub(super) fn learn(state: &mut State, floor: SizingFloor, point: SizingPoint, pending: u32) {
    if let Some(run) = &mut state.view.sizing.run {
        Rc::make_mut(run).learn(floor, point, pending);
    }
}

/// All of them are there.
pub(super) fn answered(state: &mut State, answer: SizingAnswer) {
    if let Some(run) = &mut state.view.sizing.run {
        Rc::make_mut(run).answer = answer;
    }
}

/// What runs is about the floor that there is; else it ends, and what is known goes.
pub(super) fn settle(state: &mut State) {
    let is_of = state.sizing().is_some();
    if !is_of && state.view.sizing.run.is_some() {
        state.view.sizing.run = None;
        back(state);
    }
    if state.is_sizing() && (!is_of || !state.view.sizing.is_open) {
        state.work.end();
    }
    let is_hidden = state.view.sizing.is_open && !state.can_size();
    if is_hidden || state.is_inside() || state.view.robots.is_open {
        hide(state);
    }
}
