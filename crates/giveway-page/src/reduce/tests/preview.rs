//! The best plan so far plays while the search goes on.

use std::rc::Rc;

use giveway_model::check::check;
use giveway_model::{Agent, Cell, Cost, Plan, Scene, Version};
use giveway_solve::{Progress, Response, SolveAnswer, Stats, Status};

use super::{after, fresh};
use crate::sample::{reach, solved};
use crate::{Action, Draft, Phase, PlayAction, SolveAction, State, WorkerAction};

/// One robot in a corridor, which is solved.
fn begun() -> State {
    let scene = Scene {
        map: vec!["......".into()],
        agents: vec![Agent {
            name: "A1".into(),
            start: Cell::new(0, 0),
            goal: Some(Cell::new(5, 0)),
            waypoints: Vec::new(),
            battery: None,
            heading: None,
        }],
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    after(&state, [Action::Solve(SolveAction::Solve)])
}

/// The best plan, but for so many steps of waiting.
fn later(steps: u32) -> Progress {
    let wait = (0..steps).map(|_| Some(Cell::new(0, 0)));
    let go = (0..6).map(|x| Some(Cell::new(x, 0)));
    let plan = Plan {
        paths: [("A1".to_owned(), wait.chain(go).collect())].into(),
        ..Plan::default()
    };
    let state = begun();
    let instance = state.document.draft.instance().unwrap();
    let report = check(instance, &plan);
    assert!(report.violations.is_empty(), "{:?}", report.violations);
    Progress::Plan {
        costs: report.costs.unwrap(),
        plan,
    }
}

fn best() -> SolveAnswer {
    let Progress::Plan { costs, plan } = later(0) else {
        unreachable!("it is a plan");
    };
    SolveAnswer {
        giveway: Version,
        status: Status::Optimal,
        costs: Some(costs),
        bounds: [(Cost::Makespan, 5), (Cost::SumOfCosts, 5)].into(),
        reach: reach(None),
        ended: Some(giveway_solve::Ended::Proof),
        reason: None,
        plan: Some(plan),
        stats: Stats::default(),
        trace: None,
    }
}

fn tell(state: &State, event: Progress) -> State {
    let job = state.work.id().unwrap();
    after(
        state,
        [Action::Worker(WorkerAction::Progress { job, event })],
    )
}

fn play(state: &State, action: PlayAction) -> State {
    after(state, [Action::Play(action)])
}

fn answered(state: &State, solved: SolveAnswer) -> State {
    let job = state.work.id().unwrap();
    let response = Box::new(Response::Solved(solved));
    after(
        state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    )
}

#[test]
fn the_first_plan_plays_at_once() {
    let begun = begun();
    assert!(begun.so_far().is_none() && begun.plan().is_none());
    let state = tell(&begun, later(2));
    assert_eq!(state.phase(), Phase::Solving);
    assert!(state.so_far().is_some() && state.view.playback.playing);
    assert_eq!(state.view.playback.time, 0);
    assert_eq!(state.last_time(), state.so_far().unwrap().makespan());
    assert_eq!(state.document, begun.document, "it is no answer yet");
}

#[test]
fn the_bounds_of_a_first_search_have_the_place_of_the_lanes() {
    let begun = begun();
    assert!(begun.awaited().is_some());
    let planned = tell(&begun, later(2));
    assert!(planned.awaited().is_some(), "its plan is not the answer");
    let stopped = after(&planned, [Action::Solve(SolveAction::Cancel)]);
    assert!(stopped.awaited().is_none());
    let again = after(&stopped, [Action::Solve(SolveAction::Solve)]);
    assert!(again.awaited().is_none(), "there are lanes already");
}

#[test]
fn a_better_plan_waits_until_no_robot_would_jump() {
    let first = tell(&begun(), later(3));
    let shown = Rc::clone(first.so_far().unwrap());
    let playing = tell(&play(&first, PlayAction::Reach(4)), later(1));
    assert!(Rc::ptr_eq(playing.so_far().unwrap(), &shown));
    let paused = tell(&play(&playing, PlayAction::Pause), later(0));
    assert!(
        Rc::ptr_eq(paused.so_far().unwrap(), &shown),
        "it is looked at"
    );
    let end = play(&playing, PlayAction::Reach(shown.makespan()));
    let better = end.so_far().unwrap();
    assert!(better.makespan() < shown.makespan());
    let playback = end.view.playback;
    assert_eq!(
        (playback.time, playback.playing),
        (better.makespan(), false)
    );
    let start = play(&paused, PlayAction::Seek(0));
    assert_eq!(start.so_far().unwrap().makespan(), shown.makespan() - 3);
    assert_eq!(start.view.playback.time, 0);
}

#[test]
fn the_costs_are_those_of_the_plan_that_plays() {
    let costs = |state: &State| {
        let whole = crate::inspect::whole(state);
        let makespan = whole.costs.iter().find(|it| it.cost == Cost::Makespan);
        (makespan.and_then(|it| it.value), whole.claims)
    };
    let first = tell(&begun(), later(3));
    assert_eq!(costs(&first), (Some(8), Vec::new()));
    let playing = tell(&play(&first, PlayAction::Reach(4)), later(1));
    assert_eq!(playing.so_far().unwrap().makespan(), 8);
    let (makespan, claims) = costs(&playing);
    assert_eq!(
        makespan,
        Some(8),
        "not those of a plan that nobody sees yet"
    );
    assert!(
        claims[0].starts_with("A better plan is found: makespan 6"),
        "{claims:?}"
    );
    let said = crate::words::standing(&playing).sentence;
    assert!(said.contains("makespan 6"), "{said}");
    let end = play(&playing, PlayAction::Reach(8));
    assert_eq!(costs(&end), (Some(6), Vec::new()));
}

#[test]
fn the_plan_that_is_proved_in_the_end_goes_on_where_it_is() {
    let state = play(&tell(&begun(), later(0)), PlayAction::Reach(3));
    let proved = answered(&state, best());
    assert_eq!(proved.phase(), Phase::Planned);
    let playback = proved.view.playback;
    assert_eq!((playback.time, playback.playing), (3, true));
}

#[test]
fn another_plan_than_that_shown_plays_from_its_start() {
    let state = play(&tell(&begun(), later(2)), PlayAction::Reach(3));
    let proved = answered(&state, best());
    let playback = proved.view.playback;
    assert_eq!((playback.time, playback.playing), (0, true));
}

#[test]
fn cancelling_keeps_the_plan_and_where_it_is() {
    let state = play(&tell(&begun(), later(1)), PlayAction::Reach(3));
    let state = after(&state, [Action::Solve(SolveAction::Cancel)]);
    assert_eq!(state.phase(), Phase::Stopped);
    assert!(state.so_far().is_none() && state.plan().is_some());
    assert_eq!(state.view.playback.time, 3);
}

#[test]
fn a_plan_that_breaks_a_rule_does_not_come_to_the_board() {
    let costs = best().costs.unwrap();
    let plan = Plan::default();
    let state = tell(&begun(), Progress::Plan { costs, plan });
    assert!(state.so_far().is_none());
}

#[test]
fn a_search_that_goes_on_from_a_plan_does_not_move_it() {
    let state = play(&tell(&begun(), later(2)), PlayAction::Pause);
    let stopped = after(&state, [Action::Solve(SolveAction::Cancel)]);
    let stopped = play(&stopped, PlayAction::Seek(4));
    let again = after(&stopped, [Action::Solve(SolveAction::Solve)]);
    let better = tell(&again, later(0));
    assert!(better.so_far().is_none(), "a time of the plan is looked at");
    let start = play(&better, PlayAction::Seek(0));
    assert!(start.so_far().is_some() && !start.view.playback.playing);
    assert_eq!(start.plan(), best().plan.as_ref());
}

#[test]
fn a_plan_that_is_only_proved_stays_as_it_is() {
    let text = crate::link::write(&solved());
    let shared = after(&fresh(), [crate::link::open(&text)]);
    assert_eq!(shared.phase(), Phase::Solving);
    let best = shared.document.answer.as_ref().unwrap().solved.clone();
    let (costs, plan) = (best.costs.unwrap(), best.plan.unwrap());
    let told = tell(&shared, Progress::Plan { costs, plan });
    assert!(told.so_far().is_none());
    assert_eq!(told.plan(), shared.plan());
}

#[test]
fn an_edit_ends_a_search_and_keeps_its_plan() {
    let state = play(&tell(&begun(), later(1)), PlayAction::Reach(3));
    let painted = after(&state, super::edit());
    assert!(painted.so_far().is_none() && painted.work.is_idle());
    assert!(!painted.view.playback.playing);
    let kept = painted.document.answer.as_ref().unwrap();
    assert_eq!(kept.plan(), state.plan());
}

#[test]
fn bounds_alone_show_nothing() {
    let bound = Progress::Bound {
        cost: Cost::Makespan,
        at_least: 17,
    };
    assert!(tell(&begun(), bound).so_far().is_none());
}
