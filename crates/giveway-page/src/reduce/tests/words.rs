//! What the page says in each state.

use giveway_model::{Cell, Cost, Costs, Plan, Scene};
use giveway_solve::{Progress, Reason, Response, SolveAnswer, Status, Stop};

use super::solve::respond;
use super::{after, edit, fresh};
use crate::sample::{reach, solved};
use crate::words::{Badge, standing};
use crate::{Action, Draft, SolveAction, State, WorkerAction};

#[track_caller]
fn check(state: &State, badge: Badge, sentence: &str) {
    let standing = standing(state);
    assert_eq!(
        (standing.badge, standing.sentence.as_str()),
        (badge, sentence)
    );
}

/// The answer to the warehouse, changed.
fn answered(change: impl FnOnce(&mut SolveAnswer)) -> State {
    let Action::Worker(WorkerAction::Respond { mut response, .. }) = respond(1, Status::Unknown)
    else {
        panic!("no response");
    };
    if let Response::Solved(solved) = &mut *response {
        change(solved);
    }
    after(
        &fresh(),
        [
            Action::Solve(SolveAction::Solve),
            Action::Worker(WorkerAction::Respond { job: 1, response }),
        ],
    )
}

const COSTS: Costs = Costs {
    makespan: 20,
    sum_of_costs: 40,
    charges: 1,
    moves: 30,
    waits: 4,
    penalty: 0,
};

#[test]
fn without_an_answer() {
    check(&fresh(), Badge::Draft, "No plan yet.");
}

#[test]
fn with_a_plan() {
    let planned = solved();
    let sentence = "Optimal: makespan 18, sum of costs 35, 3 charges.";
    check(&planned, Badge::Proved, sentence);
    let stale = "The scene has changed since this plan. Solve again.";
    check(&after(&planned, edit()), Badge::Stale, stale);
    let bounded = answered(|answer| {
        answer.status = Status::Optimal;
        answer.costs = Some(COSTS);
        answer.reach = reach(Some(40));
    });
    let sentence = "Optimal within makespan 40: makespan 20, sum of costs 40, 1 charge.";
    check(&bounded, Badge::Proved, sentence);
}

/// A plan found on the way.
fn plan() -> Progress {
    Progress::Plan {
        costs: COSTS,
        plan: Plan::default(),
    }
}

#[test]
fn while_it_solves() {
    let tell = |event| Action::Worker(WorkerAction::Progress { job: 1, event });
    let bound = |cost, at_least| tell(Progress::Bound { cost, at_least });
    let mut state = after(&fresh(), [Action::Solve(SolveAction::Solve)]);
    check(&state, Badge::Solving, "Solving: no bound yet.");
    let steps = [
        (
            bound(Cost::Makespan, 17),
            "Solving: makespan is at least 17.",
        ),
        (
            tell(plan()),
            "Solving: makespan is at least 17, the best plan so far has 20.",
        ),
        (bound(Cost::Makespan, 20), "Solving: makespan is 20."),
        (
            bound(Cost::SumOfCosts, 33),
            "Solving: makespan is 20; sum of costs is at least 33, the best plan so far has 40.",
        ),
    ];
    for (action, sentence) in steps {
        state = after(&state, [action]);
        check(&state, Badge::Solving, sentence);
        // The badge says the first word.
        let beside = sentence.replacen("Solving: m", "M", 1);
        let beside = beside.replacen("Solving: no", "No", 1);
        assert_eq!(standing(&state).beside_badge(), beside);
    }
}

#[test]
fn a_plan_before_any_bound() {
    let event = plan();
    let state = after(
        &fresh(),
        [
            Action::Solve(SolveAction::Solve),
            Action::Worker(WorkerAction::Progress { job: 1, event }),
        ],
    );
    let sentence = "Solving: a plan with makespan 20, sum of costs 40, 1 charge.";
    check(&state, Badge::Solving, sentence);
}

#[test]
fn without_a_plan() {
    let none = |within, reason: Option<Reason>| {
        answered(|answer| {
            answer.status = Status::Impossible;
            answer.reach = reach(within);
            answer.reason.clone_from(&reason);
        })
    };
    let check = |state: &State, sentence| check(state, Badge::Impossible, sentence);
    check(&none(Some(40), None), "No plan within makespan 40.");
    check(
        &none(None, None),
        "No plan exists, no matter how many steps you allow.",
    );
    let agents = vec!["A1".to_owned(), "A2".to_owned()];
    let reason = Some(Reason::Clash { agents });
    let sentence =
        "No plan exists, no matter how many steps you allow: A1 and A2 cannot both arrive.";
    check(&none(None, reason.clone()), sentence);
    let sentence = "No plan within makespan 40: A1 and A2 cannot both arrive.";
    check(&none(Some(40), reason), sentence);
}

#[test]
fn a_stale_answer_without_a_plan() {
    let state = answered(|answer| answer.status = Status::Impossible);
    let sentence = "The scene has changed. Solve again.";
    check(&after(&state, edit()), Badge::Stale, sentence);
}

#[test]
fn out_of_budget() {
    let reason = Some(Reason::Stopped(Stop::Time));
    let unknown = answered(|answer| answer.reason = reason.clone());
    let sentence = "The time limit was reached. There may be a plan; none was found yet. \
                    Proved so far: makespan is at least 17.";
    check(&unknown, Badge::Stopped, sentence);
    let feasible = answered(|answer| {
        answer.status = Status::Feasible;
        answer.costs = Some(COSTS);
        answer.bounds = [(Cost::Makespan, 20), (Cost::SumOfCosts, 38)].into();
        answer.reason = reason;
    });
    let sentence = "Best so far: makespan 20, proved; sum of costs 40, proved at least 38; \
                    1 charge. The time limit was reached.";
    check(&feasible, Badge::Stopped, sentence);
}

#[test]
fn a_scene_that_cannot_be_solved() {
    let mut scene: Scene = fresh().document.draft.scene().clone();
    scene.agents[0].goal = Some(Cell::new(1, 1));
    let state = State::new(Draft::new(scene).unwrap());
    let standing = standing(&state);
    assert_eq!(standing.badge, Badge::Faulty);
    assert_eq!(
        standing.sentence,
        "This cannot be solved: The goal of A1 is on an obstacle, at (1, 1)."
    );
    let state = after(&state, [Action::Solve(SolveAction::Solve)]);
    let notice = state.view.notice.unwrap();
    assert_eq!(
        notice.details(),
        ["The goal of A1 is on an obstacle, at (1, 1)."],
        "told when it is tried"
    );
}
