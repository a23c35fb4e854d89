//! Planners of the textbook, chosen in the menu: their plans, their table, and what
//! they cannot do.

mod bound;
mod table;

use giveway_model::Cost;
use giveway_solve::plan::Planner;
use giveway_solve::{Progress, Request, Status};

use super::{answered, page, saying};
use crate::planners::{By, Place, Proved, Row, table};
use crate::reduce::tests::after;
use crate::{
    Action, ChangeAction, Draft, Edit, Phase, SolveAction, State, ViewAction, WorkerAction,
    inspect, link, sample, words,
};

/// Two robots that want the middle cell at the same time.
fn crossing(costs: &[Cost]) -> State {
    page(&[".b.", "a.A", ".B."], costs)
}

fn plan(planner: Planner) -> Action {
    Action::Solve(SolveAction::Plan(planner))
}

fn planned(state: &State, planner: Planner) -> State {
    answered(&after(state, [plan(planner)]))
}

fn solved(state: &State) -> State {
    answered(&after(state, [Action::Solve(SolveAction::Solve)]))
}

fn rows(state: &State) -> Vec<Row> {
    table(state).map(|table| table.rows).unwrap_or_default()
}

const BOTH: [Cost; 2] = [Cost::SumOfCosts, Cost::Makespan];

#[test]
fn a_planner_is_asked_with_the_limits_of_the_scene() {
    let actions = [
        Action::Edit(Edit::Within(Some(9))),
        Action::View(ViewAction::SetSeconds(7)),
        Action::View(ViewAction::SetFront(true)),
        plan(Planner::Lns),
    ];
    let state = after(&crossing(&BOTH), actions);
    let Some((1, Request::Plan(request))) = state.work.request() else {
        panic!("{:?}", state.work);
    };
    assert_eq!((request.planner, request.within), (Planner::Lns, Some(9)));
    assert_eq!(request.limits.seconds, Some(7.0));
    assert_eq!(state.phase(), Phase::Solving);
    assert_eq!(saying(&state), "LNS is planning: no plan yet.");
}

#[test]
fn cbs_proves_the_first_cost_and_no_more() {
    let state = planned(&crossing(&BOTH), Planner::Cbs);
    let said = "CBS found a plan: sum of costs 5, makespan 3. No plan has a smaller sum of costs.";
    assert_eq!(saying(&state), said);
    assert_eq!(words::standing(&state).badge, words::Badge::Found);
    assert_eq!(state.phase(), Phase::Found);
    let answer = state.document.answer.clone().unwrap();
    assert_eq!(answer.solved.status, Status::Feasible);
    assert_eq!(answer.solved.bounds, [(Cost::SumOfCosts, 5)].into());
    let facts = inspect::whole(&state);
    let claim = "No plan has a smaller sum of costs, no matter how many steps you allow.";
    assert_eq!(facts.claims, [claim]);
    let proved = facts.costs.iter().filter(|cost| cost.is_proved());
    assert_eq!(
        proved.map(|cost| cost.cost).collect::<Vec<_>>(),
        [Cost::SumOfCosts]
    );
    let [row] = &rows(&state)[..] else { panic!() };
    let told = row.plan.as_ref().unwrap();
    assert_eq!(
        (told.costs.as_str(), told.proved),
        ("5, 3", Proved::Least(5))
    );
    assert_eq!(told.place, Place::Board);
}

#[test]
fn where_that_is_all_of_the_objective_its_plan_is_the_best() {
    let state = planned(&crossing(&[Cost::SumOfCosts]), Planner::Cbs);
    assert_eq!(saying(&state), "CBS found the best plan: sum of costs 5.");
    assert_eq!(words::standing(&state).badge, words::Badge::Proved);
    assert_eq!(rows(&state)[0].plan.as_ref().unwrap().proved, Proved::Best);
    assert_eq!(rows(&state).len(), 1, "it is not of the search");
}

#[test]
fn no_other_planner_proves_anything() {
    for planner in Planner::ALL.into_iter().filter(|&p| p != Planner::Cbs) {
        let state = planned(&crossing(&[Cost::SumOfCosts]), planner);
        let solved = state.document.answer.clone().unwrap().solved.clone();
        assert_eq!(solved.status, Status::Feasible, "{planner}");
        assert!(
            solved.bounds.is_empty() && !solved.reach.is_complete(),
            "{planner}"
        );
        let said = saying(&state);
        let found = format!("{} found a plan: sum of costs ", planner.title());
        assert!(said.starts_with(&found), "{said}");
        let row = &rows(&state)[0];
        let told = row.plan.as_ref().unwrap();
        assert_eq!(told.proved, Proved::Nothing, "{planner}");
    }
}

#[test]
fn what_a_planner_cannot_do_it_says_and_the_plan_stays() {
    let before = sample::solved();
    let state = planned(&before, Planner::Pibt);
    let said = "Not for this planner: PIBT cannot plan for waypoints, and A1 has some.";
    assert_eq!(state.view.notice.as_ref().unwrap().sentence(), said);
    assert_eq!(state.document.answer, before.document.answer);
    assert!(!state.history.can_undo(), "nothing has changed");
    let [search, pibt] = &rows(&state)[..] else {
        panic!()
    };
    assert_eq!(
        (search.by, pibt.by),
        (By::Search, By::Planner(Planner::Pibt))
    );
    assert_eq!(search.plan.as_ref().unwrap().proved, Proved::Best);
    assert_eq!(pibt.plan, Err(said.to_owned()));
    let shown = after(&state, [Action::Solve(SolveAction::ShowPlan(pibt.by))]);
    assert_eq!(shown, state, "there is nothing to show");
}

#[test]
fn that_no_order_works_is_not_that_there_is_no_plan() {
    // Each closes the corridor for the other, whoever is first.
    let scene = page(&["aB.bA"], &[Cost::Makespan]);
    let state = planned(&scene, Planner::Prioritised);
    let notice = state.view.notice.clone().unwrap();
    assert!(notice.sentence().contains("orders works"), "{notice:?}");
    assert!(!notice.sentence().contains("exists"), "{notice:?}");
    assert_eq!(
        notice.details(),
        ["Another order or another planner may find a plan."]
    );
    assert_eq!(state.phase(), Phase::Editing, "nothing is claimed");
}

#[test]
fn a_planner_that_is_stopped_keeps_its_best_plan() {
    let found = planned(&crossing(&BOTH), Planner::Lns);
    let solved = found.document.answer.unwrap().solved.clone();
    let state = after(&crossing(&BOTH), [plan(Planner::Lns)]);
    let nothing = after(&state, [Action::Solve(SolveAction::Cancel)]);
    assert_eq!(
        nothing.document,
        crossing(&BOTH).document,
        "nothing was found"
    );
    let event = Progress::Plan {
        costs: solved.costs.unwrap(),
        plan: solved.plan.unwrap(),
    };
    let state = after(
        &state,
        [Action::Worker(WorkerAction::Progress { job: 1, event })],
    );
    assert_eq!(
        saying(&state),
        "LNS is planning: a plan with sum of costs 5, makespan 3."
    );
    let state = after(&state, [Action::Solve(SolveAction::Cancel)]);
    let said = "LNS found a plan: sum of costs 5, makespan 3. You stopped the search.";
    assert_eq!(saying(&state), said);
    let row = rows(&state).remove(0);
    assert_eq!(
        (row.time.as_str(), row.steps.as_str()),
        ("\u{2013}", "\u{2013}")
    );
}

#[test]
fn the_search_goes_on_from_the_plan_of_a_planner() {
    let found = planned(&crossing(&BOTH), Planner::Pibt);
    let state = after(&found, [Action::Solve(SolveAction::Solve)]);
    let Some((_, Request::Solve(request))) = state.work.request() else {
        panic!("{:?}", state.work);
    };
    assert_eq!(request.start.as_ref(), found.plan());
    let state = answered(&state);
    assert!(
        saying(&state).starts_with("Optimal: "),
        "{}",
        saying(&state)
    );
    let by: Vec<By> = rows(&state).iter().map(|row| row.by).collect();
    assert_eq!(by, [By::Search, By::Planner(Planner::Pibt)]);
}

#[test]
fn what_is_kept_is_the_plan_and_whose_it_is() {
    let state = planned(&crossing(&BOTH), Planner::Cbs);
    let kept = link::kept(&link::keep(&state)).unwrap();
    assert_eq!(
        (saying(&kept), kept.phase()),
        (saying(&state), Phase::Found)
    );
    assert_eq!(table(&kept), None);
    let opened = after(
        &State::new(Draft::default()),
        [link::open(&link::write(&state))],
    );
    let answer = opened.document.answer.clone().unwrap();
    assert!(
        answer.is_shared && answer.by.is_none(),
        "nobody here saw it planned"
    );
    assert!(answer.solved.bounds.is_empty());
}

#[test]
fn while_the_world_changes_no_planner_is_asked() {
    let changing = after(&sample::solved(), [Action::Change(ChangeAction::Begin)]);
    let state = after(&changing, [plan(Planner::Cbs)]);
    assert!(state.work.is_idle() && !state.can_plan());
    assert_eq!(state.document, changing.document);
    assert!(state.view.notice.is_some(), "it says why");
}
