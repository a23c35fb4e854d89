//! A planner of the textbook plans the scene; the plans of planners are shown in turn,
//! or side by side.

use std::rc::Rc;

use giveway_solve::SolveAnswer;
use giveway_solve::plan::{PlanAnswer, PlanStats, Planner, words};

use super::document::{amend, put, settle};
use super::{ask, steer};
use crate::planners::{By, End, Run, Runs, solved};
use crate::{Answer, Document, Notice, Solving, State};

/// A planner answered. Without a plan the one that there was stays.
pub(super) fn planned(state: &mut State, run: &Solving, told: &PlanAnswer) {
    if let Some(solved) = solved(told) {
        return arrive(state, run, told.planner, solved, Some(told.stats));
    }
    let sentence = words::headline(told).to_string();
    let found_plans = Runs::with(
        &state.document,
        Run {
            planner: told.planner,
            end: End::Nothing(sentence.clone()),
            stats: Some(told.stats),
        },
    );
    let document = Document {
        found_plans: Some(found_plans),
        ..state.document.clone()
    };
    amend(state, document);
    state.view.notice = Some(Notice::information(sentence).with(words::notes(told)));
}

/// The plan of a planner becomes the plan of the scene.
pub(super) fn arrive(
    state: &mut State,
    run: &Solving,
    planner: Planner,
    solved: SolveAnswer,
    stats: Option<PlanStats>,
) {
    let answer = Answer::new(Rc::clone(&run.draft), Rc::clone(&run.request), solved);
    let answer = Rc::new(Answer {
        by: Some(planner),
        ..answer
    });
    let runs = Run {
        planner,
        end: End::Plan(Rc::clone(&answer)),
        stats,
    };
    let document = Document {
        found_plans: Some(Runs::with(&state.document, runs)),
        found_front: None,
        answer: Some(Rc::clone(&answer)),
        ..state.document.clone()
    };
    put(state, document);
    let playback = &mut state.view.playback;
    playback.stop_at(0);
    playback.playing = answer.makespan() > 0;
    playback.sought = false;
}

/// Shows the plan of one of them, at the same time as far as it goes.
pub(super) fn show(state: &mut State, by: By) {
    let runs = Runs::of(&state.document);
    let Some(answer) = runs.plan(by).cloned() else {
        return;
    };
    if steer::is_in_the_way(state) {
        return;
    }
    ask::close(state);
    let document = Document {
        answer: Some(answer),
        found_plans: Some(Rc::new(runs)),
        ..state.document.clone()
    };
    amend(state, document);
}

/// Shows the plan of one of them beside the one on the board, or no longer.
pub(super) fn beside(state: &mut State, by: By) {
    let is_beside = state.view.versus == Some(by);
    state.view.versus = (!is_beside).then_some(by);
    settle(state);
}
