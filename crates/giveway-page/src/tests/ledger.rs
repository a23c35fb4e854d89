//! Who costs whom, with the solver's own answers: opened, read, looked at, left.

use giveway_model::{Agent, Cell, Cost, Question, Scene};
use giveway_solve::{Ended, Response, Status};

use super::{answer, answered, saying, seek, select};
use crate::keys::{Command, Key, command};
use crate::ledger::{Column, LedgerAction, LedgerLit, column, heat, legend, notes};
use crate::reduce::tests::after;
use crate::{
    Action, AskAction, BoardAction, Draft, Phase, Selection, SolveAction, State, Tool, WorkerAction,
};

pub(super) const OPEN: Action = Action::Ledger(LedgerAction::Show(true));

/// A corridor with one cell to step aside into: one of the two robots waits there.
pub(super) fn corridor() -> State {
    solved(
        &["......", "##.###", "......"],
        &[
            ("A1", (0, 0), (5, 0)),
            ("A2", (5, 0), (0, 0)),
            ("A3", (0, 2), (5, 2)),
        ],
    )
}

/// A robot's name, start and goal.
pub(super) type Task = (&'static str, (u32, u32), (u32, u32));

pub(super) fn solved(map: &[&str], tasks: &[Task]) -> State {
    let agent = |&(name, start, goal): &Task| Agent {
        name: name.to_owned(),
        start: Cell::new(start.0, start.1),
        goal: Some(Cell::new(goal.0, goal.1)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    let scene = Scene {
        map: map.iter().map(|&row| row.to_owned()).collect(),
        agents: tasks.iter().map(agent).collect(),
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    answered(&after(&state, [Action::Solve(SolveAction::Solve)]))
}

pub(super) fn told() -> State {
    answered(&after(&corridor(), [OPEN]))
}

pub(super) fn column_of(state: &State) -> Column {
    column(state).unwrap()
}

#[test]
fn the_ledger_adds_up_to_the_sum_of_costs() {
    let state = told();
    assert_eq!(state.phase(), Phase::Planned);
    let column = column_of(&state);
    let plan = state.document.answer.as_ref().unwrap();
    // Alone each robot drives five cells.
    let lost = plan.solved.costs.unwrap().sum_of_costs - 3 * 5;
    assert!(lost > 0, "somebody must step aside");
    assert_eq!(column.all, lost);
    let rows: u32 = column.losses.iter().map(|row| row.steps).sum();
    assert_eq!(rows, lost);
    for row in &column.losses {
        assert_eq!(plan.arrivals[row.agent.unwrap()], Some(5 + row.steps));
        assert!(row.because.iter().all(|it| it.agent != row.agent));
    }
    let most = column.losses.iter().map(|row| row.steps);
    assert!(
        most.is_sorted_by(|a, b| a >= b),
        "who loses most is the first"
    );
    let verdict = column.verdict.unwrap();
    assert_eq!(
        verdict.title,
        format!("{lost} steps lost, none to be saved")
    );
    assert!(
        verdict.sentence.starts_with(&format!(
            "Alone the 3 robots need 15 steps in all, here {}.",
            15 + lost
        )),
        "{}",
        verdict.sentence
    );
    assert_eq!(column.nobody, "0");
    assert_eq!(column.unharmed.as_deref(), Some("2 robots lose nothing."));
    assert_eq!(column.losses.len(), 1);
}

#[test]
fn turned_round_it_tells_who_costs_others() {
    let state = after(&told(), [Action::Ledger(LedgerAction::Turn(true))]);
    let column = column_of(&state);
    assert!(column.is_turned);
    for cause in &column.causes {
        assert!(!cause.losers.is_empty(), "{cause:?}");
        assert!(cause.losers.iter().all(|it| *it != cause.cause));
    }
    let others = 3 - column
        .causes
        .iter()
        .filter(|row| row.cause.agent.is_some())
        .count();
    let said = column.harmless.unwrap();
    assert!(said.starts_with(&format!("{others} robot")), "{said}");
    assert!(said.ends_with(" nobody a step."), "{said}");
    // Each reason of a row is a row here, and the other way round.
    for row in &column.losses {
        for because in &row.because {
            let costs = column.causes.iter().find(|it| it.cause == *because);
            let losers = &costs.unwrap().losers;
            assert!(losers.iter().any(|it| it.agent == row.agent));
        }
    }
}

#[test]
fn the_heat_map_has_each_lost_step_once() {
    let state = told();
    let all = heat(&state).unwrap();
    let lost = &state.ledger().unwrap().told.as_ref().unwrap().lost;
    let squares = |heat: &crate::ledger::Heat| -> usize {
        heat.shades
            .iter()
            .map(|it| it.path.matches('M').count())
            .sum()
    };
    assert_eq!(squares(&all), lost.len());
    assert!(
        all.shades
            .iter()
            .all(|it| (0.0..=1.0).contains(&it.opacity))
    );
    assert!(!all.frames.is_empty() && all.frames.iter().all(|it| !it.is_lit));
    assert_eq!(notes(&state).unwrap().len(), lost.len());
    assert_eq!(legend(&state).unwrap().len(), 2);

    // Pressing a robot leaves its cells alone, pressing a place those of the place.
    let first = column_of(&state).losses[0].clone();
    let robot = LedgerLit::Robot(first.agent.unwrap());
    let lit = after(&state, [Action::Ledger(LedgerAction::Light(Some(robot)))]);
    assert!(column_of(&lit).losses[0].is_lit);
    let rows = &state.ledger().unwrap().told.as_ref().unwrap().agents;
    assert_eq!(squares(&heat(&lit).unwrap()), rows[0].lost.len());
    let place = Some(LedgerLit::Place(0));
    let lit = after(&state, [Action::Ledger(LedgerAction::Light(place))]);
    let places = &state.ledger().unwrap().told.as_ref().unwrap().places;
    assert_eq!(squares(&heat(&lit).unwrap()), places[0].cells.len());
    assert!(column_of(&lit).places[0].is_lit && heat(&lit).unwrap().frames[0].is_lit);
}

#[test]
fn while_it_is_added_up_it_says_so_and_can_be_stopped() {
    let state = after(&corridor(), [OPEN]);
    assert_eq!(state.phase(), Phase::Counting);
    assert_eq!(saying(&state), "Adding up who costs whom.");
    let begun = column_of(&state);
    assert_eq!(begun.pending, Some("Adding up who costs whom"));
    assert_eq!((begun.verdict, begun.losses), (None, Vec::new()));
    let escape = Key {
        name: "Escape",
        ..Key::default()
    };
    let Some(Command::Act(cancel)) = command(escape, &state) else {
        panic!("Escape stops it");
    };
    let stopped = after(&state, [cancel]);
    assert!(stopped.work.is_idle());
    assert_eq!(column(&stopped), None, "nothing is known");
    // Once it is told, Escape leaves it.
    let Some(Command::Act(leave)) = command(escape, &told()) else {
        panic!("Escape leaves it");
    };
    assert_eq!(leave, Action::Ledger(LedgerAction::Show(false)));
    let left = after(&told(), [leave]);
    assert_eq!((column(&left), heat(&left)), (None, None));
    // It need not be added up a second time.
    let again = after(&left, [OPEN]);
    assert!(again.work.is_idle() && column(&again).is_some());
}

#[test]
fn whoever_selects_a_robot_sees_the_board_and_comes_back_to_it() {
    let state = told();
    assert!(state.shows_losses());
    let selected = after(&state, [select(1), seek(1)]);
    assert!(!selected.shows_losses() && column(&selected).is_none());
    let nothing = Action::Board(BoardAction::Select(Selection::Nothing));
    let back = after(&selected, [nothing]);
    assert!(back.shows_losses() && column(&back).is_some());
}

#[test]
fn it_is_of_the_plan_on_the_board_alone() {
    let state = told();
    let edited = after(
        &state,
        crate::reduce::tests::stroke(Tool::Obstacle, &[(1, 1)]),
    );
    assert_eq!((column(&edited), heat(&edited)), (None, None));
    let refused = after(&edited, [OPEN]);
    assert!(refused.view.notice.is_some() && refused.work.is_idle());
    let back = after(&edited, [Action::Undo]);
    assert_eq!(column(&back), column(&state));
    // The time does not matter.
    let looked = after(&state, [seek(1)]);
    assert!(heat(&looked).is_some());
}

/// The plan of a search that was stopped one step below the sum of costs, and that sum.
fn one_below() -> (State, u32) {
    let state = corridor();
    let solving = after(&state, [Action::Solve(SolveAction::Solve)]);
    let solving = if solving.work.is_idle() {
        let anew = after(&state, [Action::Undo]);
        after(&anew, [Action::Solve(SolveAction::Solve)])
    } else {
        solving
    };
    let Action::Worker(WorkerAction::Respond { job, response }) = answer(&solving) else {
        panic!("it answers");
    };
    let Response::Solved(mut solved) = *response else {
        panic!("{response:?}");
    };
    solved.status = Status::Feasible;
    solved.ended = Some(Ended::Time);
    solved.reach = solved.reach.of_bounds();
    let sum = solved.costs.unwrap().sum_of_costs;
    solved.bounds.insert(Cost::SumOfCosts, sum - 1);
    let response = Box::new(Response::Solved(solved));
    let stopped = after(
        &solving,
        [Action::Worker(WorkerAction::Respond { job, response })],
    );
    (stopped, sum)
}

#[test]
fn what_is_not_proved_is_open() {
    let (stopped, sum) = one_below();
    let begun = after(&stopped, [OPEN]);
    let ledger = begun.ledger().unwrap();
    assert!(!ledger.request.ledger_only, "the search goes on");
    // It ends with what the plan's own bounds prove.
    let mut known = (**ledger).clone();
    let Action::Worker(WorkerAction::Respond { response, .. }) = answer(&begun) else {
        panic!("it answers");
    };
    let Response::Delays(mut told) = *response else {
        panic!("{response:?}");
    };
    told.proof = None;
    known.learn(*told);
    let proof = known.told.unwrap().proof.clone().unwrap();
    assert_eq!(proof.at_least, sum - 15 - 1);
}

#[test]
fn what_it_proves_is_known_of_the_plan_from_then_on() {
    let (stopped, sum) = one_below();
    let question = Action::Ask(AskAction::Ask(Question::Makespan));
    let asked = answered(&after(&stopped, [question]));
    let about = asked.document.asked.len();
    let told = answered(&after(&asked, [OPEN]));
    let answer = told.document.answer.as_ref().unwrap();
    assert_eq!(answer.solved.bounds[&Cost::SumOfCosts], sum);
    // The ledger and what was asked are still about the plan on the board.
    assert!(told.document.ledger().is_some_and(|it| it.is_whole()));
    let mut asked = told.document.asked.iter();
    assert!(about > 0 && asked.all(|it| std::rc::Rc::ptr_eq(&it.about, answer)));
}
