//! Parts of the floor: framed, moved, copied, mirrored, turned, repeated, erased.

mod copies;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint, Scene, Zone};

use super::{AreaAction, Direction, Frame, card, shown};
use crate::grow::{GrowAction, offers_of_lines};
use crate::keys::{Command, Key, command};
use crate::reduce::tests::after;
use crate::{Action, Axis, BoardAction, Draft, Selection, SolveAction, State, Tool};

fn agent(name: &str, start: (u32, u32), goal: (u32, u32)) -> Agent {
    Agent {
        name: name.to_owned(),
        start: Cell::new(start.0, start.1),
        goal: Some(Cell::new(goal.0, goal.1)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    }
}

/// A floor with a shelf, a charger, a slow cell, two robots, a zone and a lane.
fn floor() -> State {
    let one = Agent {
        waypoints: vec![Cell::new(1, 2), Cell::new(6, 5)],
        ..agent("A1", (0, 1), (2, 2))
    };
    let scene = Scene {
        map: [
            "........", ".##+....", "........", "........", "...~....", "........",
        ]
        .map(str::to_owned)
        .to_vec(),
        agents: vec![one, agent("A2", (7, 0), (3, 2))],
        zones: vec![Zone::of("dock", vec![Cell::new(0, 2), Cell::new(7, 5)])],
        constraints: vec![Constraint {
            kind: ConstraintKind::OneWay {
                lane: vec![Cell::new(0, 2), Cell::new(1, 2)],
            },
            agents: None,
            name: None,
            off: false,
        }],
        ..Scene::default()
    };
    State::new(Draft::new(scene).unwrap())
}

fn act(state: &State, actions: &[AreaAction]) -> State {
    after(state, actions.iter().map(|&action| Action::Area(action)))
}

fn drag(state: &State, to: (u32, u32)) -> State {
    let cells = vec![Cell::new(to.0, to.1)];
    after(
        state,
        [
            Action::Board(BoardAction::Drag(cells)),
            Action::Board(BoardAction::Release),
        ],
    )
}

fn framed(state: &State, from: (u32, u32), to: (u32, u32), frame: Frame) -> State {
    let begin = AreaAction::Begin(Cell::new(from.0, from.1), frame);
    drag(&act(state, &[begin]), to)
}

/// The upper left part: shelf, charger, A1 and its goal and one waypoint, the goal of A2.
fn selected() -> State {
    framed(&floor(), (0, 1), (3, 2), Frame::Replace)
}

fn map(state: &State) -> Vec<String> {
    state.document.draft.grid().rows()
}

fn undone(state: &State) -> State {
    after(state, [Action::Undo])
}

#[test]
fn shift_adds_and_alt_takes_away() {
    let state = selected();
    assert_eq!(card(&state).unwrap().size, "4 \u{d7} 2 cells");
    assert!(shown(&state).unwrap().has_handles);
    let more = framed(&state, (5, 5), (6, 5), Frame::Add);
    assert_eq!(card(&more).unwrap().size, "10 cells");
    assert!(!shown(&more).unwrap().has_handles);
    let less = framed(&more, (0, 0), (7, 2), Frame::Take);
    assert_eq!(card(&less).unwrap().size, "2 \u{d7} 1 cells");
    let none = framed(&less, (0, 0), (7, 5), Frame::Take);
    assert!(card(&none).is_none());
}

#[test]
fn all_that_is_there_moves_and_comes_back_in_one_step() {
    let before = selected();
    let state = act(&before, &[AreaAction::Grab(Cell::new(1, 1))]);
    let held = after(
        &state,
        [Action::Board(BoardAction::Drag(vec![Cell::new(3, 3)]))],
    );
    assert_eq!(map(&held), map(&before), "a ghost before it is so");
    assert_eq!(shown(&held).unwrap().ghosts.len(), 2);
    let state = after(&held, [Action::Board(BoardAction::Release)]);
    let rows = [
        "........", "........", "........", "...##+..", "........", "........",
    ];
    assert_eq!(map(&state), rows, "its free cells, too");
    let scene = state.document.draft.scene();
    assert_eq!(scene.agents[0].start, Cell::new(2, 3));
    assert_eq!(scene.agents[0].goal, Some(Cell::new(4, 4)));
    assert_eq!(
        scene.agents[0].waypoints,
        [Cell::new(3, 4), Cell::new(6, 5)]
    );
    assert_eq!(scene.agents[1].goal, Some(Cell::new(5, 4)));
    assert!(scene.zones[0].has(Cell::new(2, 4)) && scene.zones[0].has(Cell::new(7, 5)));
    let lane = ConstraintKind::OneWay {
        lane: vec![Cell::new(2, 4), Cell::new(3, 4)],
    };
    assert_eq!(scene.constraints[0].kind, lane);
    assert_eq!(card(&state).unwrap().place, "(2, 3) to (5, 4)");
    assert_eq!(undone(&state).document.draft, before.document.draft);
}

#[test]
fn a_lane_that_lies_partly_there_stays_and_it_is_said() {
    let state = framed(&floor(), (0, 1), (0, 2), Frame::Replace);
    let state = act(&state, &[AreaAction::Nudge(0, 2), AreaAction::Make]);
    let rules = &state.document.draft.scene().constraints;
    assert_eq!(
        rules[0].kind,
        ConstraintKind::OneWay {
            lane: vec![Cell::new(0, 2), Cell::new(1, 2)]
        }
    );
    let notice = state.view.notice.unwrap();
    assert!(
        notice
            .sentence()
            .starts_with("1 one-way lane lies only partly there")
    );
}

#[test]
fn an_obstacle_on_a_robot_of_elsewhere_is_refused() {
    let state = framed(&floor(), (1, 1), (2, 1), Frame::Replace);
    let state = act(&state, &[AreaAction::Nudge(5, -1)]);
    assert_eq!(shown(&state).unwrap().ghosts[1].class, "refused");
    let kept = act(&state, &[AreaAction::Make]);
    assert_eq!(map(&kept), map(&floor()));
    assert!(
        kept.view
            .notice
            .unwrap()
            .sentence()
            .contains("A2 starts at (7, 0)")
    );
}

#[test]
fn keys_move_a_ghost_that_enter_makes_and_escape_drops() {
    let state = selected();
    let step = |by, carries| Action::Board(BoardAction::StepCursor { by, carries });
    let ghost = after(&state, [step((1, 0), false), step((0, 1), true)]);
    assert_eq!(
        shown(&ghost).unwrap().frame,
        [1, 4, 4, 5],
        "not over the side"
    );
    assert_eq!(map(&ghost), map(&state));
    let escape = Key {
        name: "Escape",
        ..Key::default()
    };
    let Some(Command::Act(drop)) = command(escape, &ghost) else {
        panic!("Escape drops it")
    };
    let dropped = after(&ghost, [drop]);
    assert_eq!(shown(&dropped).unwrap().frame, [0, 1, 3, 2]);
    let made = after(&ghost, [Action::Board(BoardAction::UseTool)]);
    assert_eq!(map(&made)[4], "..##+...");
    // Solving keeps it, too.
    let solved = after(&ghost, [Action::Solve(SolveAction::Solve)]);
    assert_eq!(map(&solved), map(&made));
    let picked = after(
        &ghost,
        [Action::Board(BoardAction::PickTool(Tool::Obstacle))],
    );
    assert_eq!(map(&picked), map(&made));
    assert!(!picked.has_area());
}

#[test]
fn keys_frame_an_area() {
    let state = after(
        &floor(),
        [Action::Board(BoardAction::MoveCursor(Cell::new(4, 3)))],
    );
    let step = |by| Action::Board(BoardAction::StepCursor { by, carries: true });
    let state = after(
        &state,
        [
            step((1, 0)),
            step((1, 0)),
            step((0, 1)),
            Action::Board(BoardAction::UseTool),
        ],
    );
    assert_eq!(shown(&state).unwrap().frame, [4, 3, 6, 4]);
    assert_eq!(map(&state), map(&floor()));
}

#[test]
fn a_column_and_a_row_are_selected_by_their_numbers() {
    let line = |axis, at, frame| AreaAction::Line(axis, at, frame);
    let column = act(&floor(), &[line(Axis::Columns, 3, Frame::Replace)]);
    assert_eq!(column.area().unwrap().frame(), [3, 0, 3, 5]);
    assert_eq!(column.area().unwrap().cells.len(), 6);
    let names = |state: &State| -> Vec<String> {
        let offers = offers_of_lines(state).into_iter();
        offers.map(|offer| offer.name).collect()
    };
    let expected = [
        "Insert 1 column left",
        "Insert 1 column right",
        "Remove column 3",
    ];
    assert_eq!(names(&column), expected);
    let two = act(&column, &[line(Axis::Columns, 4, Frame::Add)]);
    assert_eq!(two.area().unwrap().frame(), [3, 0, 4, 5]);
    assert_eq!(names(&two)[2], "Remove columns 3 to 4");
    let one = act(&two, &[line(Axis::Columns, 3, Frame::Take)]);
    assert_eq!(one.area().unwrap().frame(), [4, 0, 4, 5]);
    let row = act(&one, &[line(Axis::Rows, 5, Frame::Replace)]);
    assert_eq!(row.area().unwrap().frame(), [0, 5, 7, 5]);
    assert_eq!(names(&row)[0], "Insert 1 row above");
    // What lies across it is a part of the floor like any other.
    let cross = act(&row, &[line(Axis::Columns, 0, Frame::Add)]);
    assert_eq!(names(&cross), [""; 0]);
    // A number beyond the floor selects nothing.
    let beyond = act(&row, &[line(Axis::Rows, 6, Frame::Replace)]);
    assert!(!beyond.has_area());
    let lines = offers_of_lines(&row)[0].lines;
    let grown = after(&row, [Action::Grow(GrowAction::Lines(lines))]);
    assert_eq!(grown.document.draft.grid().height(), 7);
}
