//! A robot is late: who is pushed, what that breaks, what cannot be begun meanwhile.

use giveway_model::change::What;
use giveway_model::{Agent, Battery, Cell, Scene};
use giveway_order::Outcome;

use super::{OPEN, act, answered, asked_late, who_is_at};
use crate::order::{OrderAction, column, lane_order, legend};
use crate::reduce::tests::after;
use crate::{Action, BoardAction, ChangeAction, Draft, Selection, SolveAction, State, words};

fn outcome(state: &State) -> &Outcome {
    &state.order_known().unwrap().late.as_ref().unwrap().outcome
}

#[test]
fn a_late_robot_pushes_those_behind_it_and_the_board_shows_it() {
    let state = asked_late();
    let card = column(&state).unwrap().late.unwrap();
    let outcome = outcome(&state);
    let said = &outcome.late[0];
    assert_eq!(said.steps, 3);
    assert!(
        card.robots
            .iter()
            .any(|(name, is_it)| *is_it && *name == said.agent)
    );
    let pushed = outcome.pushed().count();
    assert!(card.title.unwrap().starts_with(&pushed.to_string()) || pushed == 0);
    // The plan on the board is the late one, and the table is of its times.
    let plan = state.plan().unwrap();
    assert_eq!(plan, &outcome.plan);
    assert_ne!(
        plan,
        state.document.answer.as_ref().unwrap().plan().unwrap()
    );
    let told = column(&state).unwrap();
    let seen = who_is_at(&state, state.order_cell().unwrap());
    assert_eq!(told.rows.len(), seen.len());
    for (row, (name, from, _)) in told.rows.iter().zip(&seen) {
        assert_eq!((&row.name, &row.comes), (name, &from.to_string()));
    }
    assert!(
        words::standing(&state)
            .sentence
            .starts_with(&format!("{} comes 3 steps late", said.agent))
    );
    assert_eq!(legend(&state).unwrap().len(), 5);
    let late_ones = outcome
        .arrivals
        .iter()
        .filter(|it| it.now != Some(it.planned));
    assert_eq!(lane_order(&state).unwrap().planned.len(), late_ones.count());
    // What the browser keeps has the plan itself.
    assert_eq!(state.moment().document.answer, state.document.answer);
}

#[test]
fn lateness_is_asked_anew_for_another_sentence() {
    let state = asked_late();
    let more = act(&state, &[OrderAction::Steps(5)]);
    assert!(more.late_plan().is_none(), "it is not known yet");
    assert_eq!(
        column(&more).unwrap().pending,
        Some("Finding who is pushed")
    );
    let more = answered(&more);
    assert_eq!(outcome(&more).late[0].steps, 5);
    let card = column(&more).unwrap().late.unwrap();
    // Each cell of its way is offered, its first one too.
    let first = card.cells.iter().find(|(visit, ..)| *visit == 0).unwrap();
    let start = more.document.agents().iter();
    let name = &card.robots.iter().find(|(_, is_it)| *is_it).unwrap().0;
    let start = start.clone().find(|it| it.name == *name).unwrap().start;
    assert_eq!(first.1, start.to_string());
    let other = answered(&act(&more, &[OrderAction::Robot(0), OrderAction::To(1)]));
    assert_eq!(outcome(&other).late[0].agent, "A1");
    let done = act(&other, &[OrderAction::Late(false)]);
    assert!(done.late_plan().is_none() && done.shows_order());
    assert!(done.view.playback.time <= done.last_time());
}

/// One robot behind the other in a corridor.
fn corridor(row: &str, battery: Option<Battery>) -> State {
    let agent = |name: &str, start: u32, goal: u32, battery: Option<Battery>| Agent {
        name: name.to_owned(),
        start: Cell::new(start, 0),
        goal: Some(Cell::new(goal, 0)),
        waypoints: Vec::new(),
        battery,
        heading: None,
    };
    let scene = Scene {
        map: vec![row.to_owned()],
        agents: vec![agent("A1", 0, 3, battery), agent("A2", 1, 4, None)],
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    let state = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    answered(&act(&state, &[OPEN]))
}

#[test]
fn a_battery_that_does_not_bear_the_lateness_is_told() {
    let battery = Battery {
        capacity: 9,
        initial: 4,
    };
    let state = corridor(".....", Some(battery));
    let told = column(&state).unwrap().losses;
    let bears = "The battery of A1 bears 1 step of lateness.";
    assert!(told.iter().any(|it| it == bears), "{told:?}");
    let late = act(
        &state,
        &[
            OrderAction::Late(true),
            OrderAction::Robot(0),
            OrderAction::To(1),
        ],
    );
    let one = answered(&act(&late, &[OrderAction::Steps(1)]));
    assert_eq!(
        column(&one).unwrap().late.unwrap().broken,
        Vec::<String>::new()
    );
    let two = answered(&act(&one, &[OrderAction::Steps(2)]));
    let broken = column(&two).unwrap().late.unwrap().broken;
    assert_eq!(broken.len(), 1, "{broken:?}");
    assert!(broken[0].contains("A1"), "{broken:?}");
}

#[test]
fn new_plans_are_looked_for_from_the_lateness_on() {
    // It is late at its start, or to a later cell of its way.
    for visit in [0, 2] {
        let state = act(&asked_late(), &[OrderAction::To(visit)]);
        let known = !state.is_ordering();
        replans(&if known { state } else { answered(&state) });
    }
}

fn replans(state: &State) {
    let late = outcome(state).late[0].clone();
    let visits = &state.order().unwrap().agent(&late.agent).unwrap().visits;
    let mut visits = visits.iter().filter(|it| it.cell == late.cell);
    let visit = visits.nth(late.visit as usize - 1).unwrap();
    let at = visit.comes.unwrap_or(visit.arrives);
    let card = column(state).unwrap().late.unwrap();
    assert_eq!(card.replan, Some(format!("Find new plans from {at}")));
    let changed = act(state, &[OrderAction::Replan]);
    assert!(!changed.shows_order());
    assert_eq!(changed.view.playback.time, at);
    let changing = changed.document.mode.changing().unwrap();
    let delay = What::DelayAgent {
        agent: late.agent.clone(),
        steps: late.steps,
    };
    assert_eq!((changing.at, &changing.list), (at, &vec![delay]));
    // The robot comes as late as was said, in every plan that is found.
    let found = answered(&after(&changed, [Action::Change(ChangeAction::Adapt)]));
    let comparing = found.document.mode.comparing().unwrap();
    let plans = comparing.tried.iter().filter_map(|it| it.answer.as_ref());
    assert!(plans.clone().count() > 0);
    for answer in plans {
        let path = answer.plan().unwrap().path(&late.agent);
        let held = &path[at as usize..=(at + late.steps) as usize];
        assert!(held.iter().all(|cell| *cell == held[0]), "{held:?}");
    }
}

#[test]
fn what_is_settled_is_not_planned_anew() {
    let adopted = crate::tests::adopted();
    let last = adopted.document.changed_last().unwrap();
    let state = answered(&act(&adopted, &[OPEN]));
    let late = answered(&act(&state, &[OrderAction::Late(true)]));
    let count = late.order().unwrap().agents.len();
    for robot in 0..count {
        let late = answered(&act(
            &late,
            &[OrderAction::Robot(robot), OrderAction::Steps(2)],
        ));
        let cells = column(&late).unwrap().late.unwrap().cells.len();
        for visit in 0..cells {
            let late = act(&late, &[OrderAction::To(visit)]);
            let late = if late.is_ordering() {
                answered(&late)
            } else {
                late
            };
            let changed = act(&late, &[OrderAction::Replan]);
            let at = changed.document.mode.changing().map(|it| it.at);
            assert!(at.is_none_or(|at| at > last), "{at:?}");
            let replan = column(&late).unwrap().late.unwrap().replan;
            assert_eq!(replan.is_some(), at.is_some());
        }
    }
}

#[test]
fn where_moves_are_slow_the_gap_is_two() {
    let state = corridor(".~~..", None);
    assert!(state.order().unwrap().has_slow_moves());
    for cell in (0..5).map(|x| Cell::new(x, 0)) {
        let state = act(&state, &[OrderAction::At(cell)]);
        let rows = column(&state).unwrap().rows;
        let seen = who_is_at(&state, cell);
        assert_eq!(rows.len(), seen.len(), "{cell}");
        let links = state.order().unwrap().at(cell).count();
        assert_eq!(lane_order(&state).unwrap().links.len(), links, "{cell}");
    }
    if state.order().unwrap().without_slack() > 0 {
        assert_eq!(
            column(&state).unwrap().gap.unwrap(),
            "Add the rule \"gap\" 2"
        );
    }
}

#[test]
fn in_a_world_that_changed_the_order_is_of_the_whole_plan() {
    let adopted = crate::tests::adopted();
    let state = answered(&act(&adopted, &[OPEN]));
    let agents = state.document.answer.as_ref().unwrap().agents().len();
    assert_eq!(state.order().unwrap().agents.len(), agents, "one joined");
    let late = answered(&act(&state, &[OrderAction::Late(true)]));
    assert_eq!(late.plan().unwrap(), &outcome(&late).plan);
    let cell = late.order_cell().unwrap();
    let rows = column(&late).unwrap().rows;
    let seen = who_is_at(&late, cell);
    assert_eq!(rows.len(), seen.len());
    for (row, (name, from, _)) in rows.iter().zip(&seen) {
        assert_eq!((&row.name, &row.comes), (name, &from.to_string()));
    }
}

#[test]
fn nothing_is_begun_from_the_late_plan() {
    let state = asked_late();
    let selected = after(
        &state,
        [Action::Board(BoardAction::Select(Selection::Agent(0)))],
    );
    assert!(selected.late_plan().is_some());
    assert!(crate::ask::offers(&selected).is_empty());
    assert!(!selected.can_change());
    assert_eq!(selected.can_steer(), None);
    let planned = act(&selected, &[OrderAction::Late(false)]);
    assert!(!crate::ask::offers(&planned).is_empty());
    assert!(planned.can_change());
}
