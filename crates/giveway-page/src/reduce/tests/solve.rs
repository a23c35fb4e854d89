//! Runs of the solver, and what comes late.

use giveway_model::{Cost, Costs, Fault, Plan, Version};
use giveway_solve::{Ended, Progress, Reach, Refusal, Response, SolveAnswer, Stats, Status};

use super::{after, edit, fresh};
use crate::sample::solved;
use crate::{Action, Edit, Phase, Size, SolveAction, Solving, State, ViewAction, WorkerAction};

fn run(state: &State) -> &Solving {
    state.work.solving().unwrap()
}

fn solving() -> State {
    after(&fresh(), [Action::Solve(SolveAction::Solve)])
}

fn bound(run: u64, at_least: u32) -> Action {
    Action::Worker(WorkerAction::Progress {
        job: run,
        event: Progress::Bound {
            cost: Cost::Makespan,
            at_least,
        },
    })
}

pub(super) fn respond(run: u64, status: Status) -> Action {
    let solved = SolveAnswer {
        giveway: Version,
        status,
        costs: None,
        bounds: [(Cost::Makespan, 17)].into(),
        reach: Reach::default(),
        ended: match status {
            Status::Optimal | Status::Impossible => Some(Ended::Proof),
            Status::Feasible | Status::Unknown => Some(Ended::Time),
        },
        reason: None,
        plan: None,
        stats: Stats::default(),
        trace: None,
    };
    Action::Worker(WorkerAction::Respond {
        job: run,
        response: Box::new(Response::Solved(solved)),
    })
}

fn crash(run: u64, had_started: bool) -> Action {
    Action::Worker(WorkerAction::Crash {
        job: run,
        sentence: "It broke.".to_owned(),
        had_started,
    })
}

#[test]
fn a_run_is_of_the_scene_with_the_limits_set() {
    let actions = [
        Action::Edit(Edit::Within(Some(40))),
        Action::View(ViewAction::SetSeconds(7)),
        Action::Solve(SolveAction::Solve),
    ];
    let state = after(&fresh(), actions);
    let run = run(&state);
    assert_eq!(state.work.id(), Some(1));
    assert_eq!(run.request.scene, *state.document.draft.scene());
    assert_eq!(run.request.within, Some(40));
    assert_eq!(run.request.limits.seconds, Some(7.0));
    assert_eq!(run.request.limits.memory_bytes, None, "the worker's own");
    assert_eq!(state.phase(), Phase::Solving);
}

#[test]
fn each_run_has_its_own_number() {
    let state = after(&solving(), [Action::Solve(SolveAction::Solve)]);
    assert_eq!(state.work.id().unwrap(), 2);
    let state = after(
        &state,
        [
            Action::Solve(SolveAction::Cancel),
            Action::Solve(SolveAction::Solve),
        ],
    );
    assert_eq!(state.work.id().unwrap(), 3);
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
    let tell = |event| Action::Worker(WorkerAction::Progress { job: 1, event });
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
        assert_eq!((state.phase(), state.work.is_idle()), (phase, true));
        assert!(!state.view.playback.playing, "nothing to play");
    }
}

#[test]
fn a_plan_plays_from_the_start() {
    let state = solved();
    assert_eq!(
        (state.view.playback.time, state.view.playback.playing),
        (0, true)
    );
    assert_eq!(state.last_time(), 18);
}

#[test]
fn cancel_keeps_what_was_there() {
    let before = solved();
    let state = after(
        &before,
        [
            Action::Solve(SolveAction::Solve),
            Action::Solve(SolveAction::Cancel),
        ],
    );
    assert!(state.work.is_idle());
    assert_eq!(state.document.answer, before.document.answer);
    assert_eq!(state.phase(), Phase::Planned);
}

#[test]
fn what_an_old_run_still_says_is_ignored() {
    let solving_anew = after(
        &solving(),
        [
            Action::Solve(SolveAction::Cancel),
            Action::Solve(SolveAction::Solve),
        ],
    );
    let idle = after(&solving(), [Action::Solve(SolveAction::Cancel)]);
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
        assert!(state.work.is_idle());
        assert_eq!(state.document.draft, before.document.draft);
        let notice = state.view.notice.as_ref().unwrap();
        assert_eq!(notice.details(), ["It broke."]);
    }
    assert_ne!(broke.view.notice, absent.view.notice);
    let again = after(&broke, [Action::Solve(SolveAction::Solve)]);
    assert_eq!((again.phase(), &again.view.notice), (Phase::Solving, &None));
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
        let state = after(
            &solving(),
            [Action::Worker(WorkerAction::Respond { job: 1, response })],
        );
        let notice = state.view.notice.unwrap();
        let detail = "agents[0].goal: found the obstacle (1, 1), expected a free cell";
        assert_eq!(notice.details(), [detail]);
        assert!(state.work.is_idle());
    }
}
