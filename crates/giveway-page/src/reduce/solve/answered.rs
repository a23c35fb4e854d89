//! A search is over: its answer, or its front, takes its place in the document.

use std::rc::Rc;

use giveway_solve::{FrontAnswer, SolveAnswer};

use crate::front::Front;
use crate::known::{judged, merged};
use crate::planners::Runs;
use crate::reduce::document::{amend, put};
use crate::reduce::{ask, audit, steer};
use crate::{Answer, Arrival, Document, Solving, State};

/// The scene was solved, or the search cut off.
pub(in crate::reduce) fn answered(state: &mut State, run: Solving, solved: SolveAnswer) {
    if let Some(about) = state.audit().cloned() {
        return audit::answered(state, &about, run, solved);
    }
    let objective = &run.draft.scene().objective;
    if let Some(shared) = run.from.as_ref().filter(|from| from.is_shared)
        && run.arrival == Arrival::Quiet
    {
        // It stays the plan that was shared; what is known of it is told.
        let solved = judged(&shared.solved, &solved, objective);
        let document = Document {
            answer: Some(Rc::new(Answer::new(run.draft, run.request, solved))),
            ..state.document.clone()
        };
        amend(state, document);
        return;
    }
    let solved = match &run.from {
        Some(from) => merged(&from.solved, solved, objective),
        None => solved,
    };
    let (draft, request) = (Rc::clone(&run.draft), Rc::clone(&run.request));
    let answer = Rc::new(Answer::new(draft, request, solved));
    let before = state.view.playback;
    arrive(state, &answer, None, run.arrival);
    if run.previews(&answer) {
        // It is shown already, and goes on.
        state.view.playback = before;
    }
    if let Some(question) = run.then {
        ask::ask(state, &question);
    }
}

/// The front was found.
pub(in crate::reduce) fn front(state: &mut State, run: &Solving, front: FrontAnswer) {
    let front = Front::new(Rc::clone(&run.draft), &run.request, front);
    let first = front.first(&run.request);
    arrive(state, &first, Some(Rc::new(front)), run.arrival);
}

fn arrive(state: &mut State, answer: &Rc<Answer>, front: Option<Rc<Front>>, arrival: Arrival) {
    let shown = state.document.fresh_answer();
    // A link's plan is proved: it goes on being shown where it is looked at.
    let is_proved = arrival == Arrival::Quiet && shown.is_some_and(|shown| shown.plan().is_some());
    let found_plans = match &front {
        None => Some(Runs::with_search(&state.document, answer)),
        Some(_) => state.document.found_plans.clone(),
    };
    let document = Document {
        answer: Some(Rc::clone(answer)),
        found_front: front,
        found_plans,
        ..state.document.clone()
    };
    match arrival {
        Arrival::Step => put(state, document),
        Arrival::Quiet => amend(state, document),
    }
    if is_proved {
        return;
    }
    let playback = &mut state.view.playback;
    playback.stop_at(0);
    playback.playing = answer.makespan() > 0;
    playback.sought = false;
}

/// Shows a plan of the front, at the same time as far as it goes.
pub(super) fn show_point(state: &mut State, point: usize) {
    let points = state.document.front().map(|front| &front.points);
    let Some(answer) = points.and_then(|points| points.get(point)).cloned() else {
        return;
    };
    if steer::is_in_the_way(state) {
        return;
    }
    ask::close(state);
    let document = Document {
        answer: Some(answer),
        ..state.document.clone()
    };
    amend(state, document);
}
