//! Strokes: what begins where the pointer goes down and ends where it is lifted
//! is one step of undo, whether it paints, moves a thing or places an agent.

use std::rc::Rc;

use giveway_model::{Agent, Cell, tr_data};

use super::board::select;
use super::document::{edit, enter, put, solve_on_change};
use super::{area, rules, solve};
use crate::edit::Sketch;
use crate::fleet::Fleet;
use crate::gesture::{Canvas, Gesture, Hold, Placing, Stroke};
use crate::{Activity, Document, Draft, Edit, Notice, Selection, State};

/// The pointer went on to a cell.
pub(super) fn drag(state: &mut State, cell: Cell) {
    let cell = state.document.draft.clamp(cell);
    match &mut state.view.gesture {
        Gesture::None => return,
        Gesture::Placing(placing) => placing.goal = cell,
        Gesture::Row => {
            if let Some(fleet) = &mut state.view.fleet {
                fleet.stretch(cell);
            }
        }
        Gesture::Area(_) => return area::drag(state, cell),
        Gesture::Stroke(stroke) => Rc::make_mut(stroke).go(cell),
    }
    state.view.cursor = cell;
    if let Selection::Cell(_) = state.view.selection
        && state.stroke().is_some()
    {
        state.view.selection = Selection::Cell(cell);
    }
}

/// Ends a stroke. An agent whose goal is not chosen yet waits for it.
pub(super) fn release(state: &mut State) {
    match std::mem::take(&mut state.view.gesture) {
        Gesture::None | Gesture::Row => {}
        Gesture::Placing(placing) if placing.is_held => lift(state, placing),
        waiting @ Gesture::Placing(_) => state.view.gesture = waiting,
        Gesture::Area(hand) => area::release(state, &hand),
        Gesture::Stroke(stroke) => finish(state, Rc::unwrap_or_clone(stroke)),
    }
}

fn lift(state: &mut State, placing: Placing) {
    if placing.is_second || placing.goal != placing.start {
        return place(state, placing);
    }
    state.view.gesture = Gesture::Placing(Placing {
        is_held: false,
        ..placing
    });
}

/// What a stroke came to, as one step of undo.
fn finish(state: &mut State, stroke: Stroke) {
    if let Some(dropped) = stroke.toggled() {
        return edit(state, dropped);
    }
    let is_idle = matches!(stroke.hold, Hold::Eraser) && stroke.changes_nothing();
    let hold = stroke.hold.clone();
    match stroke.canvas {
        Canvas::Scene { before, sketch, .. } => painted(state, &before, &sketch),
        Canvas::World { before, after } => {
            if before.list != after.list {
                enter(state, Activity::Changing(after));
            }
        }
    }
    rules::marked(state, &hold);
    if is_idle {
        state.view.notice = Some(Notice::information(tr_data!(
            "There is nothing to erase here."
        )));
    }
    if let Some(refused) = stroke.refused {
        state.view.notice = Some(Notice::refusal(refused));
    }
}

fn painted(state: &mut State, before: &Rc<Draft>, sketch: &Sketch) {
    let scene = sketch.clone().into_scene();
    if scene == *before.scene() {
        return;
    }
    match Draft::new(scene) {
        Ok(draft) => {
            solve::keep_so_far(state);
            let mut document = Document::clone(&state.document);
            document.set_draft(draft);
            if let Some(lost) = crate::rules::lost(&state.document.draft, &document.draft) {
                state.view.notice = Some(lost);
            }
            state.displaced = None;
            put(state, document);
            solve_on_change(state);
        }
        Err(faults) => {
            state.view.notice = Some(
                Notice::refusal(tr_data!("This edit cannot be made."))
                    .with(faults.iter().map(ToString::to_string)),
            );
        }
    }
}

/// Puts the agent that was placed onto the board, and selects it.
fn place(state: &mut State, Placing { start, goal, .. }: Placing) {
    let agent = Agent {
        name: state.next_name(),
        start,
        goal: Some(goal),
        waypoints: Vec::new(),
        battery: state
            .world()
            .agents()
            .last()
            .and_then(|agent| agent.battery),
        heading: None,
    };
    let count = state.world().agents().len();
    edit(state, Edit::AddAgent(agent));
    if state.is_there(count) {
        select(state, Selection::Agent(count));
    }
}

/// Leaves a stroke or a placing as if it had never begun.
pub(super) fn abandon(state: &mut State) {
    if state.view.gesture == Gesture::Row {
        state.view.fleet = state.view.fleet.take().and_then(Fleet::without_goals);
    }
    if let Gesture::Area(hand) = std::mem::take(&mut state.view.gesture) {
        area::abandon(state, &hand);
    }
}
