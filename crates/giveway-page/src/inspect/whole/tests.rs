//! The warehouse as a whole: proved, on its way, stale.

use giveway_model::Cost;
use giveway_solve::Progress;

use super::*;
use crate::reduce::tests::{after, stroke};
use crate::{Action, BoardAction, SolveAction, WorkerAction, reduce, sample};

#[test]
fn a_proved_plan() {
    let whole = whole(&sample::solved());
    assert_eq!(whole.title, "warehouse");
    assert_eq!(
        whole.contents,
        "2 robots, 2 chargers, 6 slow cells, 6 obstacles"
    );
    assert_eq!(
        whole.claims,
        ["No plan is better, no matter how many steps you allow."]
    );
    let proved: Vec<_> = whole.costs.iter().map(CostFacts::is_proved).collect();
    assert_eq!(proved, [true, true, true, false, false]);
    assert_eq!(whole.costs[1].title, "Sum of costs");
    assert_eq!(
        whole.work.as_deref(),
        Some("Proved without SAT, less than 0.1 s")
    );
}

#[test]
fn a_solve_under_way() {
    let state = reduce(
        &State::new(sample::draft()),
        Action::Solve(SolveAction::Solve),
    );
    assert_eq!(whole(&state).costs, []);
    let event = Progress::Bound {
        cost: Cost::Makespan,
        at_least: 17,
    };
    let state = reduce(
        &state,
        Action::Worker(WorkerAction::Progress { job: 1, event }),
    );
    let costs = whole(&state).costs;
    assert_eq!(costs.len(), 1);
    assert_eq!((costs[0].value, costs[0].at_least), (None, Some(17)));
    assert!(!costs[0].is_proved());
}

#[test]
fn a_stale_plan_is_called_one() {
    let state = sample::solved();
    let state = reduce(
        &state,
        Action::Board(BoardAction::PickTool(crate::Tool::Obstacle)),
    );
    let state = reduce(
        &state,
        Action::Board(BoardAction::Press(giveway_model::Cell::new(8, 1))),
    );
    let state = reduce(
        &state,
        Action::Board(BoardAction::Press(giveway_model::Cell::new(4, 2))),
    );
    let state = reduce(&state, Action::Board(BoardAction::Release));
    assert!(state.document.is_stale());
    let claims = whole(&state).claims;
    assert!(claims[0].contains("before the last edit"));
    assert_eq!(claims.len(), 1, "all paths are free");
    let answer = state.document.answer.as_ref().unwrap();
    let goes = |name| answer.plan().unwrap().path(name).iter().flatten();
    let only = goes("A1").find(|cell| !goes("A2").any(|other| other == *cell));
    let on_its_path = stroke(
        crate::Tool::Obstacle,
        &[only.map(|at| (at.x, at.y)).unwrap()],
    );
    let claims = whole(&after(&state, on_its_path)).claims;
    assert_eq!(claims[1], "Without a path that fits: A1.");
}
