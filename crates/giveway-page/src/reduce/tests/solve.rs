//! Runs of the solver, and what comes late.

use giveway_model::{Cost, Costs, Fault, Plan, Version};
use giveway_solve::{Progress, Refusal, Response, SolveAnswer, Stats, Status};

use super::{after, edit, fresh};
use crate::sample::solved;
use crate::{Action, Phase, Run, Size, State, Work};

fn run(state: &State) -> &Run {
    match &state.work {
        Work::Solving(run) => run,
        other => panic!("not solving: {other:?}"),
    }
}

fn solving() -> State {
    after(&fresh(), [Action::Solve])
}

fn bound(run: u64, at_least: u32) -> Action {
    Action::Progress {
        run,
        event: Progress::Bound {
            cost: Cost::Makespan,
            at_least,
        },
    }
}

pub(super) fn respond(run: u64, status: Status) -> Action {
    let solved = SolveAnswer {
        giveway: Version,
        status,
        costs: None,
        bounds: [(Cost::Makespan, 17)].into(),
        within: None,
        complete: false,
        reason: None,
        plan: None,
        stats: Stats::default(),
    };
    Action::Respond {
        run,
        response: Box::new(Response::Solved(solved)),
    }
}

fn crash(run: u64, had_started: bool) -> Action {
    Action::Crash {
        run,
        sentence: "It broke.".to_owned(),
        had_started,
    }
}

#[test]
fn a_run_is_of_the_scene_with_the_limits_set() {
    let actions = [
        Action::SetWithin(Some(40)),
        Action::SetSeconds(7),
        Action::Solve,
    ];
    let state = after(&fresh(), actions);
    let run = run(&state);
    assert_eq!(run.id, 1);
    assert_eq!(run.request.scene, *state.draft.scene());
    assert_eq!(run.request.within, Some(40));
    assert_eq!(run.request.limits.seconds, Some(7.0));
    assert_eq!(run.request.limits.memory_bytes, None, "the worker's own");
    assert_eq!(state.phase(), Phase::Solving);
}

#[test]
fn each_run_has_its_own_number() {
    let state = after(&solving(), [Action::Solve]);
    assert_eq!(run(&state).id, 2);
    let state = after(&state, [Action::Cancel, Action::Solve]);
    assert_eq!(run(&state).id, 3);
}

#[test]
fn progress_only_improves() {
    let costs = Costs {
        makespan: 20,
        ..Costs::default()
    };
    let size = Size {
        variables: 900,
        clauses: 3000,
        conflicts: 5,
    };
    let tell = |event| Action::Progress { run: 1, event };
    let actions = [
        bound(1, 17),
        bound(1, 15),
        tell(Progress::Plan {
            costs,
            plan: Plan::default(),
        }),
        tell(Progress::Size {
            variables: 900,
            clauses: 3000,
            conflicts: 5,
        }),
    ];
    let state = after(&solving(), actions);
    let run = run(&state);
    assert_eq!(run.bounds, [(Cost::Makespan, 17)].into());
    assert_eq!((run.best, run.size), (Some(costs), size));
}

#[test]
fn each_answer_has_its_phase() {
    let cases = [
        (Status::Impossible, Phase::None),
        (Status::Unknown, Phase::Stopped),
        (Status::Feasible, Phase::Stopped),
        (Status::Optimal, Phase::Planned),
    ];
    for (status, phase) in cases {
        let state = after(&solving(), [respond(1, status)]);
        assert_eq!((state.phase(), &state.work), (phase, &Work::Idle));
        assert!(!state.playback.playing, "nothing to play");
    }
}

#[test]
fn a_plan_plays_from_the_start() {
    let state = solved();
    assert_eq!((state.playback.time, state.playback.playing), (0, true));
    assert_eq!(state.last_time(), 18);
}

#[test]
fn cancel_keeps_what_was_there() {
    let before = solved();
    let state = after(&before, [Action::Solve, Action::Cancel]);
    assert_eq!(state.work, Work::Idle);
    assert_eq!(state.answer, before.answer);
    assert_eq!(state.phase(), Phase::Planned);
}

#[test]
fn what_an_old_run_still_says_is_ignored() {
    let solving_anew = after(&solving(), [Action::Cancel, Action::Solve]);
    let idle = after(&solving(), [Action::Cancel]);
    let edited = after(&solving(), edit());
    for state in [solving_anew, idle, edited] {
        for late in [
            bound(1, 99),
            respond(1, Status::Impossible),
            crash(1, true),
            crash(1, false),
        ] {
            assert_eq!(after(&state, [late]), state);
        }
    }
}

#[test]
fn a_crash_is_told_and_the_scene_stays() {
    let before = solving();
    let broke = after(&before, [crash(1, true)]);
    let absent = after(&before, [crash(1, false)]);
    for state in [&broke, &absent] {
        assert_eq!(state.work, Work::Idle);
        assert_eq!(state.draft, before.draft);
        let notice = state.notice.as_ref().unwrap();
        assert_eq!(notice.details, ["It broke."]);
    }
    assert_ne!(broke.notice, absent.notice);
    let again = after(&broke, [Action::Solve]);
    assert_eq!((again.phase(), &again.notice), (Phase::Solving, &None));
}

#[test]
fn a_refusal_is_told() {
    let fault = Fault::at("agents[0].goal", "the obstacle (1, 1)", "a free cell");
    let refusals = [
        Refusal::Scene {
            faults: vec![fault.clone()],
        },
        Refusal::Request { fault },
    ];
    for refusal in refusals {
        let response = Box::new(Response::Refused(refusal));
        let state = after(&solving(), [Action::Respond { run: 1, response }]);
        let notice = state.notice.unwrap();
        let detail = "agents[0].goal: found the obstacle (1, 1), expected a free cell";
        assert_eq!(notice.details, [detail]);
        assert_eq!(state.work, Work::Idle);
    }
}
