//! What is known when a search ends before its answer.

use giveway_model::{Cost, Plan};
use giveway_solve::{Ended, Progress, Response, SolveAnswer, Stats, Status};

use super::{after, fresh, stroke};
use crate::sample::solved;
use crate::{
    Action, BoardAction, Edit, Phase, SolveAction, State, Tool, ViewAction, WorkerAction, words,
};

/// The warehouse while it is solved: the plan is found, and half of its proof.
fn half_way() -> State {
    let whole = solved().document.answer.unwrap().solved.clone();
    let state = after(&fresh(), [Action::Solve(SolveAction::Solve)]);
    let bound = Progress::Bound {
        cost: Cost::Makespan,
        at_least: 17,
    };
    let plan = Progress::Plan {
        costs: whole.costs.unwrap(),
        plan: whole.plan.unwrap(),
    };
    let job = state.work.id().unwrap();
    let tell = |event| Action::Worker(WorkerAction::Progress { job, event });
    after(&state, [bound, plan].map(tell))
}

fn told(state: &State) -> SolveAnswer {
    state.document.answer.as_ref().unwrap().solved.clone()
}

#[test]
fn cancelling_keeps_the_best_plan_and_all_bounds() {
    let state = after(&half_way(), [Action::Solve(SolveAction::Cancel)]);
    assert_eq!(state.phase(), Phase::Stopped);
    assert!(state.work.is_idle() && state.plan().is_some());
    let standing = words::standing(&state).sentence;
    let expect = "Best so far: makespan 18, proved at least 17; sum of costs 35; 3 charges. \
                  You stopped the search.";
    assert_eq!(standing, expect);
    let undone = after(&state, [Action::Undo]);
    assert_eq!(undone.document.answer, None, "it was a step");
}

#[test]
fn an_edit_keeps_the_plan_that_was_found_so_far() {
    let painted = after(&half_way(), stroke(Tool::Obstacle, &[(8, 0)]));
    let named = after(&half_way(), [Action::Edit(Edit::RemoveAgent(1))]);
    for edited in [painted, named] {
        assert!(edited.work.is_idle() && !edited.view.playback.playing);
        assert!(edited.document.is_stale() && edited.document.answer.is_some());
        let back = after(&edited, [Action::Undo]);
        assert_eq!(back.phase(), Phase::Stopped);
        assert_eq!(told(&back).bounds[&Cost::Makespan], 17);
    }
}

#[test]
fn a_worker_that_breaks_down_takes_nothing_along() {
    let state = half_way();
    let crash = Action::Worker(WorkerAction::Crash {
        job: state.work.id().unwrap(),
        sentence: "Out of memory.".to_owned(),
        had_started: true,
    });
    let state = after(&state, [crash]);
    assert!(state.plan().is_some() && state.view.notice.is_some());
}

#[test]
fn a_plan_that_breaks_a_rule_is_never_shown() {
    let state = half_way();
    let job = state.work.id().unwrap();
    let costs = told(&solved()).costs.unwrap();
    let event = Progress::Plan {
        costs,
        plan: Plan::default(),
    };
    let actions = [
        Action::Worker(WorkerAction::Progress { job, event }),
        Action::Solve(SolveAction::Cancel),
    ];
    let state = after(&state, actions);
    assert_eq!(state.plan(), None);
    assert_eq!(
        told(&state).bounds[&Cost::Makespan],
        17,
        "a bound is a bound"
    );
}

#[test]
fn solving_again_goes_on_from_what_is_known() {
    let stopped = after(&half_way(), [Action::Solve(SolveAction::Cancel)]);
    let state = after(&stopped, [Action::Solve(SolveAction::Solve)]);
    let solving = state.work.solving().unwrap();
    assert_eq!(solving.request.start.as_ref(), stopped.plan());
    assert_eq!(solving.bounds[&Cost::Makespan], 17);
    // The second search knows less when its time runs out.
    let nothing = SolveAnswer {
        status: Status::Unknown,
        costs: None,
        plan: None,
        bounds: [(Cost::Makespan, 12)].into(),
        stats: Stats::default(),
        ..told(&stopped)
    };
    let response = Box::new(Response::Solved(nothing));
    let job = state.work.id().unwrap();
    let ended = after(
        &state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    );
    assert_eq!(told(&ended).bounds[&Cost::Makespan], 17);
    assert_eq!(ended.plan(), stopped.plan());
    assert_eq!(ended.phase(), Phase::Stopped);
}

/// A proof begins anew each time: with no more time than before it comes no further.
#[test]
fn what_its_time_limit_cut_off_goes_on_twice_as_long() {
    let asked = |state: &State| state.work.solving().unwrap().request.limits.seconds;
    let out_of_time = |state: &State| {
        let answer = SolveAnswer {
            status: Status::Feasible,
            ended: Some(Ended::Time),
            bounds: [(Cost::Makespan, 17)].into(),
            ..told(&solved())
        };
        let response = Box::new(Response::Solved(answer));
        let job = state.work.id().unwrap();
        after(
            state,
            [Action::Worker(WorkerAction::Respond { job, response })],
        )
    };
    let go_on = |state: &State| after(state, [Action::Solve(SolveAction::Solve)]);
    let first = go_on(&fresh());
    let cut = out_of_time(&first);
    assert_eq!(cut.phase(), Phase::Stopped);
    assert_eq!((asked(&first), cut.seconds_to_go_on()), (Some(30.0), 60.0));
    let second = go_on(&cut);
    assert_eq!(asked(&second), Some(60.0));
    let third = go_on(&out_of_time(&second));
    assert_eq!(asked(&third), Some(120.0));
    // A limit that a person has set longer holds; one that was cancelled has as long as before.
    let longer = after(&cut, [Action::View(ViewAction::SetSeconds(200))]);
    assert_eq!(asked(&go_on(&longer)), Some(200.0));
    let cancelled = after(&second, [Action::Solve(SolveAction::Cancel)]);
    assert_eq!(cancelled.seconds_to_go_on(), 30.0);
    // Another scene begins with what is set.
    let edited = after(&cut, [Action::Edit(Edit::RemoveAgent(1))]);
    assert_eq!(asked(&go_on(&edited)), Some(30.0));
}

#[test]
fn cancelling_knows_nothing_where_nothing_was_known() {
    let state = after(
        &fresh(),
        [
            Action::Solve(SolveAction::Solve),
            Action::Solve(SolveAction::Cancel),
        ],
    );
    assert_eq!(state.document, fresh().document);
    assert_eq!(state.phase(), Phase::Editing);
}

#[test]
fn an_edit_ends_a_search_and_nothing_else_does() {
    let state = half_way();
    let looked = [
        Action::View(ViewAction::ShowTrails(false)),
        Action::Board(BoardAction::Select(crate::Selection::Agent(1))),
    ];
    assert_eq!(after(&state, looked).phase(), Phase::Solving);
    let painted = after(&state, super::edit());
    assert!(painted.work.is_idle());
}

/// The warehouse's plan from a link, while it is proved.
fn shared() -> State {
    let text = crate::link::write(&solved());
    let state = after(&fresh(), [crate::link::open(&text)]);
    assert_eq!(state.phase(), Phase::Solving);
    state
}

#[test]
fn a_shared_plan_is_proved_where_it_stands() {
    let state = after(&shared(), [Action::Play(crate::PlayAction::Seek(4))]);
    let best = told(&solved());
    let job = state.work.id().unwrap();
    let answer = |solved| {
        let response = Box::new(Response::Solved(solved));
        after(
            &state,
            [Action::Worker(WorkerAction::Respond { job, response })],
        )
    };
    let proved = answer(best.clone());
    assert_eq!(proved.phase(), Phase::Planned);
    assert_eq!(proved.view.playback.time, 4, "nothing jumps");
    assert!(!proved.view.playback.playing);
    let mut better = best;
    better.costs.as_mut().unwrap().makespan -= 1;
    better.bounds.insert(Cost::Makespan, 17);
    let judged = answer(better);
    assert_eq!(
        judged.plan(),
        solved().plan(),
        "it stays the plan that was shared"
    );
    assert_eq!(judged.phase(), Phase::Found, "no search was stopped");
    let said = words::standing(&judged).sentence;
    assert!(said.starts_with("A plan: makespan 18"), "{said}");
    assert!(said.ends_with("There is a better plan."), "{said}");
}

#[test]
fn a_shared_plan_of_many_is_told_as_one() {
    let state = after(&shared(), [Action::Solve(SolveAction::Cancel)]);
    let standing = words::standing(&state);
    assert_eq!(standing.badge.word(), "Shared");
    assert!(standing.sentence.contains("makespan 18"), "{standing:?}");
}
