//! Fronts of the warehouse.

use crate::words;
use crate::{BoardAction, SolveAction, State, ViewAction, WorkerAction};
use giveway_model::Costs;
use giveway_solve::{Reach, Response};

use super::*;
use crate::sample::{draft, proved, reach, warehouse};
use crate::{Action, Phase, reduce};

/// The warehouse's plan as if it cost so much, makespan and sum of costs.
fn point((makespan, sum_of_costs): (u32, u32)) -> SolveAnswer {
    let answer = warehouse();
    let costs = Costs {
        makespan,
        sum_of_costs,
        ..answer.solved.costs.unwrap()
    };
    let plan = answer.plan().cloned().unwrap();
    proved(&answer.draft.scene().objective, costs, plan)
}

fn solved(status: Status, costs: &[(u32, u32)]) -> State {
    let actions = [
        Action::View(ViewAction::SetFront(true)),
        Action::Solve(SolveAction::Solve),
    ];
    let state = actions
        .into_iter()
        .fold(State::new(draft()), |state, action| reduce(&state, action));
    let front = FrontAnswer {
        giveway: Version,
        status,
        ended: None,
        reach: if status == Status::Optimal || costs.is_empty() {
            reach(None)
        } else {
            Reach::default()
        },
        front: costs.iter().copied().map(point).collect(),
    };
    let response = Box::new(Response::Front(front));
    reduce(
        &state,
        Action::Worker(WorkerAction::Respond { job: 1, response }),
    )
}

#[test]
fn every_point_is_a_plan_to_show() {
    let state = solved(Status::Optimal, &[(18, 35), (20, 34), (22, 32)]);
    let front = state.document.front().unwrap();
    assert_eq!(front.name(1), "makespan 20, sum of costs 34, 3 charges");
    assert_eq!(
        front.place_of(state.document.answer.as_ref().unwrap()),
        Some(0)
    );
    assert_eq!(state.phase(), Phase::Planned);
    let standing = words::standing(&state);
    assert!(
        standing
            .sentence
            .starts_with("On the Pareto front of 3 plans: makespan 18"),
        "{standing:?}"
    );

    let state = reduce(&state, Action::Solve(SolveAction::ShowPoint(2)));
    assert_eq!(state.last_time(), 22);
    assert!(words::standing(&state).sentence.contains("makespan 22"));
    assert_eq!(
        reduce(&state, Action::Solve(SolveAction::ShowPoint(9))),
        state
    );
}

#[test]
fn a_point_claims_nothing_of_its_own() {
    let state = solved(Status::Optimal, &[(18, 35), (20, 34)]);
    let solved = &state.document.answer.as_ref().unwrap().solved;
    assert_eq!((solved.status, solved.bounds.len()), (Status::Feasible, 0));
    let part = self::solved(Status::Feasible, &[(18, 35)]);
    assert_eq!(part.phase(), Phase::Stopped);
    assert!(part.document.front().unwrap().claim().contains("so far"));
    let none = self::solved(Status::Impossible, &[]);
    assert_eq!(none.phase(), Phase::None);
}

#[test]
fn a_plot_goes_from_the_least_to_the_greatest() {
    let state = solved(Status::Optimal, &[(18, 35), (20, 34), (22, 32)]);
    let plot = state.document.front().unwrap().plot();
    assert_eq!(plot.points, [(0, 0), (130, 40), (260, 120)]);
    assert_eq!((plot.across, plot.up), ([18, 22], [32, 35]));
    let one = solved(Status::Optimal, &[(18, 35)]);
    assert_eq!(one.document.front().unwrap().plot().points, [(130, 60)]);
}

#[test]
fn a_front_is_of_its_scene() {
    let state = solved(Status::Optimal, &[(18, 35)]);
    let edited = [
        Action::Board(BoardAction::PickTool(crate::Tool::Charger)),
        Action::Board(BoardAction::Press(giveway_model::Cell::new(1, 0))),
        Action::Board(BoardAction::Release),
    ]
    .into_iter()
    .fold(state.clone(), |state, action| reduce(&state, action));
    assert!(edited.document.front().is_none());
    let back = reduce(&edited, Action::Undo);
    assert!(back.document.front().is_some());
    assert_eq!(
        reduce(&back, Action::View(ViewAction::SetFront(false)))
            .document
            .front(),
        back.document.front()
    );
}
