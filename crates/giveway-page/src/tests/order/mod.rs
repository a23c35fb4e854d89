//! The order of a plan with the solver's own answers: opened, cell by cell, saved, left.

mod late;
mod links;

use giveway_model::{Agent, Cell, Scene};
use giveway_solve::{Response, SilentHost, serve};

use crate::keys::{Command, Key, command};
use crate::order::{OrderAction, OrderExport, column, lane_order, lanes, legend, notes, strip};
use crate::reduce::tests::after;
use crate::{
    Action, BoardAction, Draft, PlayAction, Selection, SolveAction, State, Tool, WorkerAction,
};

const OPEN: OrderAction = OrderAction::Show(true);

/// Two aisles that six robots pass.
fn aisles() -> State {
    let agent = |name: &str, start: (u32, u32), goal: (u32, u32)| Agent {
        name: name.to_owned(),
        start: Cell::new(start.0, start.1),
        goal: Some(Cell::new(goal.0, goal.1)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    let scene = Scene {
        name: "two aisles".to_owned(),
        map: [
            "..........",
            ".###.###..",
            "..........",
            ".###.###..",
            "..........",
        ]
        .map(str::to_owned)
        .to_vec(),
        agents: vec![
            agent("A1", (0, 4), (7, 0)),
            agent("A2", (9, 4), (4, 0)),
            agent("A3", (6, 4), (3, 0)),
            agent("A4", (3, 0), (4, 4)),
            agent("A5", (5, 0), (3, 4)),
            agent("A6", (4, 0), (9, 4)),
        ],
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    answered(&after(&state, [Action::Solve(SolveAction::Solve)]))
}

fn answered(state: &State) -> State {
    let (job, request) = state.work.request().expect("it works");
    let response = Box::new(serve(&request, &SilentHost));
    assert!(!matches!(*response, Response::Refused(_)), "{response:?}");
    after(
        state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    )
}

fn act(state: &State, actions: &[OrderAction]) -> State {
    after(state, actions.iter().map(|&action| Action::Order(action)))
}

fn opened() -> State {
    answered(&act(&aisles(), &[OPEN]))
}

/// A robot is late at the cell that is shown.
fn asked_late() -> State {
    answered(&act(&opened(), &[OrderAction::Late(true)]))
}

/// Who is at a cell of a plan, in order, read from its paths alone.
fn who_is_at(state: &State, cell: Cell) -> Vec<(String, u32, u32)> {
    let mut all: Vec<(String, u32, u32)> = Vec::new();
    let plan = state.plan().unwrap();
    for (name, path) in &plan.paths {
        let from = plan.from.get(name).copied().unwrap_or(0);
        for (time, place) in (from..).zip(path) {
            if *place != Some(cell) {
                continue;
            }
            match all.last_mut() {
                Some(it) if it.0 == *name && it.2 + 1 == time => it.2 = time,
                _ => all.push((name.clone(), time, time)),
            }
        }
    }
    all.sort_by_key(|it| it.1);
    all
}

#[test]
fn the_cell_with_the_most_links_comes_first() {
    let state = opened();
    assert!(state.shows_order() && state.work.is_idle());
    let order = state.order().unwrap();
    let cell = state.order_cell().unwrap();
    let most = order.at(cell).count();
    assert!(most > 2, "the aisles are shared");
    for link in &order.links {
        assert!(order.at(link.cell).count() <= most);
    }
    let told = column(&state).unwrap();
    assert_eq!(told.title, format!("Order at {cell}"));
    assert!(told.lead.starts_with("The busiest cell"), "{}", told.lead);
    // Who passes is what the paths say.
    let rows: Vec<(String, String)> = told
        .rows
        .iter()
        .map(|row| (row.name.clone(), row.comes.clone()))
        .collect();
    let seen: Vec<(String, String)> = who_is_at(&state, cell)
        .into_iter()
        .map(|(name, from, _)| (name, from.to_string()))
        .collect();
    assert_eq!(rows, seen);
}

#[test]
fn slack_is_the_time_between_leaving_and_coming() {
    let state = opened();
    let cells: Vec<Cell> = state
        .order()
        .unwrap()
        .links
        .iter()
        .map(|it| it.cell)
        .collect();
    for cell in cells {
        let state = act(&state, &[OrderAction::At(cell)]);
        let rows = column(&state).unwrap().rows;
        for pair in rows.windows(2) {
            // All moves of this floor take one step.
            let out: u32 = pair[0].leaves.parse().unwrap();
            let comes: u32 = pair[1].comes.parse().unwrap();
            assert_eq!(pair[0].slack, (comes - out).to_string(), "{cell}");
            assert_eq!(pair[0].is_tight, comes == out);
        }
        assert_eq!(rows.last().unwrap().slack, "");
    }
}

#[test]
fn lanes_run_down_like_a_stair() {
    let state = opened();
    let told = column(&state).unwrap();
    let names = lanes(&state).unwrap();
    let passers: Vec<&str> = told.rows.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(names.len(), 6);
    assert_eq!(names[..passers.len()], passers);
    let drawn = lane_order(&state).unwrap();
    assert_eq!(drawn.links.len(), passers.len() - 1);
    for link in &drawn.links {
        assert_eq!(link.to.0, link.from.0 + 1);
        assert!(link.from.1 <= link.to.1);
    }
    let first = format!("{} before {} at ", passers[0], passers[1]);
    assert!(drawn.aloud.starts_with(&first), "{}", drawn.aloud);
    assert!(drawn.planned.is_empty());
}

#[test]
fn robots_are_through_in_it_or_to_come() {
    let state = opened();
    let cell = state.order_cell().unwrap();
    let last = state.last_time();
    let passes = who_is_at(&state, cell);
    for time in 0..=last {
        let state = after(&state, [Action::Play(PlayAction::Seek(time))]);
        let shown = strip(&state).unwrap();
        assert_eq!(shown.robots.len(), passes.len());
        for (robot, (name, from, to)) in shown.robots.iter().zip(&passes) {
            assert_eq!(state.document.agents()[robot.agent].name, *name);
            assert_eq!(
                robot.is_in,
                (*from..=*to).contains(&time),
                "{name} at {time}"
            );
            assert_eq!(robot.is_through, *to < time, "{name} at {time}");
        }
    }
}

#[test]
fn another_cell_is_chosen_by_press_and_arrows() {
    let state = opened();
    let press = |cell| Action::Board(BoardAction::Press(cell));
    let free = after(
        &state,
        [press(Cell::new(8, 1)), Action::Board(BoardAction::Release)],
    );
    assert_eq!(free.order_cell(), Some(Cell::new(8, 1)));
    assert_eq!(free.document, state.document, "nothing is drawn");
    assert!(
        column(&free)
            .unwrap()
            .lead
            .starts_with("No robot passes here")
    );
    let by = BoardAction::StepCursor {
        by: (-4, 1),
        carries: false,
    };
    let stepped = after(&free, [Action::Board(by)]);
    assert_eq!(stepped.order_cell(), Some(Cell::new(4, 2)));
    let told = notes(&stepped).unwrap();
    let (_, note) = told
        .iter()
        .find(|(cell, _)| *cell == Cell::new(4, 2))
        .unwrap();
    assert!(note.contains("robots pass: "), "{note}");
    assert_eq!(legend(&stepped).unwrap().len(), 4);
    // A tool of the board leaves it.
    let drawn = after(
        &stepped,
        [Action::Board(BoardAction::PickTool(Tool::Obstacle))],
    );
    assert!(!drawn.shows_order());
}

#[test]
fn files_are_written_as_the_command_writes_them() {
    let state = opened();
    let json = act(&state, &[OrderAction::Save(OrderExport::Json)]);
    let packed = json.intake.packed.clone().unwrap();
    assert_eq!(packed.name, "two-aisles-order.json");
    let read: serde_json::Value = serde_json::from_slice(&packed.bytes).unwrap();
    let links = state.order().unwrap().links.len();
    assert_eq!(read["order"]["links"].as_array().unwrap().len(), links);
    let dot = answered(&act(&json, &[OrderAction::Save(OrderExport::Dot)]));
    let packed = dot.intake.packed.clone().unwrap();
    assert_eq!(packed.name, "two-aisles-order.dot");
    let text = String::from_utf8(packed.bytes.clone()).unwrap();
    assert_eq!(text, giveway_order::dot(state.order().unwrap()));
    assert_eq!(column(&dot).unwrap().export, OrderExport::Dot);
    for export in [OrderExport::Waypoints, OrderExport::Vda5050] {
        let saved = answered(&act(&state, &[OrderAction::Save(export)]));
        assert!(!saved.intake.packed.unwrap().bytes.is_empty());
    }
    // The lateness that is looked at stays.
    let saved = answered(&act(&asked_late(), &[OrderAction::Save(OrderExport::Dot)]));
    assert!(saved.late_plan().is_some());
}

#[test]
fn the_rule_gap_takes_all_links_without_slack() {
    let state = opened();
    assert!(state.order().unwrap().without_slack() > 0);
    assert_eq!(
        column(&state).unwrap().gap.unwrap(),
        "Add the rule \"gap\" 1"
    );
    let added = act(&state, &[OrderAction::AddGap]);
    assert_eq!(added.document.draft.scene().constraints.len(), 1);
    assert!(!added.shows_order(), "the plan is of the scene before");
    let solved = answered(&after(&added, [Action::Solve(SolveAction::Solve)]));
    let opened = answered(&act(&solved, &[OPEN]));
    assert_eq!(opened.order().unwrap().without_slack(), 0);
    assert_eq!(column(&opened).unwrap().gap, None);
    let undone = after(&opened, [Action::Undo]);
    assert!(!undone.shows_order());
}

#[test]
fn it_is_left_by_escape_and_by_what_else_is_opened() {
    let state = asked_late();
    let escape = Key {
        name: "Escape",
        ..Key::default()
    };
    let press = |state: &State| match command(escape, state) {
        Some(Command::Act(action)) => after(state, [action]),
        other => panic!("{other:?}"),
    };
    let once = press(&state);
    assert!(once.shows_order() && once.late_plan().is_none());
    assert!(!press(&once).shows_order());
    let robots = crate::robots::RobotsAction::Show(true);
    assert!(!after(&state, [Action::Robots(robots)]).shows_order());
    let ledger = crate::ledger::LedgerAction::Show(true);
    assert!(!after(&state, [Action::Ledger(ledger)]).shows_order());
    // A robot is looked at in between.
    let select = Action::Board(BoardAction::Select(Selection::Agent(0)));
    assert!(after(&state, [select]).shows_order());
    // What runs ends with it.
    let asked = act(&aisles(), &[OPEN, OrderAction::Show(false)]);
    assert!(asked.work.is_idle());
    // Without a plan there is nothing to ask.
    let empty = act(&State::new(Draft::default()), &[OPEN]);
    assert!(!empty.shows_order() && empty.view.notice.is_some());
}
