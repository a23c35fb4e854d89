//! Whatever a person does, in whatever order: nothing is lost, nothing panics, and
//! what cannot be together never is.

mod by_hand;
mod elsewhere;
mod floor;
mod passing;
mod random;

use giveway_model::Question;

use super::answered;
use crate::reduce::tests::after;
use crate::{
    Action, Activity, AskAction, Draft, Edit, SolveAction, State, ask, board, changing, freedom,
    inside, inspect, ledger, link, order, planners, reduce, rules, steering, table, words,
};

/// How many actions in all.
const ACTIONS: u64 = 100_000;
/// A session begins anew after so many.
const SESSION: u64 = 1_000;

#[test]
fn nothing_is_ever_lost() {
    for seed in 0..ACTIONS / SESSION {
        Session::new(seed).run(SESSION);
    }
}

struct Session {
    rng: fastrand::Rng,
    state: State,
    /// The numbers of jobs that are over, with their answers.
    late: Vec<Action>,
    done: Vec<String>,
}

impl Session {
    fn new(seed: u64) -> Self {
        let scene = giveway_model::Scene {
            map: vec!["....".into(), ".#+.".into(), "~~..".into()],
            ..giveway_model::Scene::default()
        };
        Self {
            rng: fastrand::Rng::with_seed(seed),
            state: State::new(Draft::new(scene).unwrap()),
            late: Vec::new(),
            done: vec![format!("seed {seed}")],
        }
    }

    fn run(&mut self, actions: u64) {
        for step in 0..actions {
            for action in self.next() {
                self.done.push(format!("{action:.60?}"));
                self.state = reduce(&self.state, action);
                self.check(step);
            }
        }
    }
}

impl Session {
    /// All that holds after whatever was done.
    fn check(&self, step: u64) {
        let state = &self.state;
        let told = || {
            let from = self.done.len().saturating_sub(12);
            format!("step {step}: {:#?}", &self.done[from..])
        };
        assert!(
            state.view.playback.time <= state.last_time(),
            "time: {}",
            told()
        );
        if let crate::Selection::Agent(agent) = state.view.selection {
            let is_drawn = state.has_gesture() || agent < state.world().agents().len();
            assert!(is_drawn, "selection: {}", told());
        }
        let mut kept = state.work.clone();
        kept.keep_to(&state.document);
        assert_eq!(kept.id(), state.work.id(), "work: {}", told());
        if !state.has_gesture() && state.history.can_undo() {
            let redone = reduce(&reduce(state, Action::Undo), Action::Redo);
            assert!(redone.document == state.document, "undo, redo: {}", told());
        }
        show(state);
        if step.is_multiple_of(64) {
            let again = link::kept(&link::keep(state)).unwrap_or_else(|notice| {
                panic!("kept: {notice:?} {}", told());
            });
            assert_eq!(link::keep(&again), link::keep(state), "kept: {}", told());
        }
    }
}

/// All that places of the page make of a state.
fn show(state: &State) {
    let _ = words::standing(state);
    let _ = (ask::offers(state), ask::card(state), inspect::whole(state));
    let _ = (changing::facts(state), changing::columns(state));
    let _ = (steering::facts(state), state.can_change());
    let _ = planners::table(state);
    let _ = (freedom::column(state), freedom::part(state));
    let _ = (
        ledger::column(state),
        ledger::heat(state),
        ledger::legend(state),
        ledger::notes(state),
    );
    let _ = (
        order::column(state),
        order::strip(state),
        order::notes(state),
    );
    let _ = (order::lane_order(state), order::lanes(state));
    let _ = (freedom::lines(state), freedom::numbers(state));
    let _ = (rules::card(state), rules::list(state));
    let _ = board::Cast::of(state);
    let overlay = inside::overlay(state);
    let _ = (
        inside::legend(state, &overlay),
        inside::column(state),
        inside::said(state),
    );
    let _ = (
        inside::rows(state, &(0..50)),
        inside::chart(state, (300.0, 200.0)),
    );
    let _ = (
        inside::tree_view(state),
        inside::notes(state),
        inside::steps(state),
    );
    for agent in 0..=state.world().agents().len() {
        let _ = inspect::agent(state, agent);
        let _ = changing::offers(state, agent);
    }
    for answer in state.shown().into_iter().chain(state.beside()) {
        let lanes = table::lanes(answer, &state.document.draft);
        for lane in &lanes {
            let _ = (lane.sentence(), lane.level_at(state.view.playback.time));
            let marks = freedom::lane(state, &lane.name);
            let _ = marks.map(|marks| marks.sentence(lane));
        }
    }
    let is_asked = state.document.mode.asking().is_some();
    match &state.document.mode.activity {
        Activity::Editing => assert!(!is_asked || state.document.answer.is_some()),
        Activity::Changing(_) => assert!(!is_asked),
        Activity::Steering(own) => assert!(own.about.course.is_none()),
        Activity::Comparing(comparing) => assert!(!is_asked || comparing.preview().is_none()),
        Activity::Auditing(audit) => {
            assert!(
                state.document.plan().is_none() != audit.plan.is_legal(),
                "an illegal plan is none of the scene"
            );
        }
    }
}

/// Found by chance.
#[test]
fn clearing_a_clear_scene_leaves_the_question_with_its_plan() {
    let scene = giveway_model::Scene {
        map: vec!["..".into()],
        ..giveway_model::Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    let solved = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    let asked = after(&solved, [Action::Ask(AskAction::Ask(Question::Plan))]);
    assert!(asked.document.mode.asking().is_some());
    let cleared = after(&asked, [Action::Edit(Edit::Clear)]);
    assert_eq!(cleared.document.answer, None);
    assert!(cleared.document.mode.is_editing());
}
