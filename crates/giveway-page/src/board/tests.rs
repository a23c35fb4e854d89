//! The board of a scene with a plan.

use std::rc::Rc;

use giveway_model::{Cell, Costs, Plan, Scene};
use giveway_solve::SolveRequest;

use super::*;
use crate::sample::proved;
use crate::{Action, Answer, BoardAction, Draft, Point, State, Tool, reduce};

const SCENE: &str = r#"{
    "giveway": 1,
    "map": ["..~~", ".#+."],
    "agents": [
        { "name": "A", "start": [0, 0], "goal": [3, 0], "waypoints": [[1, 0]],
          "battery": { "capacity": 10, "initial": 9 } },
        { "name": "B", "start": [3, 1], "goal": [2, 1] }
    ]
}"#;

const PLAN: &str = r#"{
    "giveway": 1,
    "paths": {
        "A": [[0, 0], [1, 0], [2, 0], null, [3, 0]],
        "B": [[3, 1], [3, 1], [2, 1]]
    }
}"#;

fn scene() -> State {
    let scene: Scene = serde_json::from_str(SCENE).unwrap();
    State::new(Draft::new(scene).unwrap())
}

pub(super) fn planned() -> State {
    let mut state = scene();
    let plan: Plan = serde_json::from_str(PLAN).unwrap();
    let costs = Costs {
        makespan: 4,
        sum_of_costs: 6,
        moves: 4,
        waits: 1,
        ..Costs::default()
    };
    let solved = proved(&state.document.draft.scene().objective, costs, plan);
    let request = Rc::new(SolveRequest::default());
    let draft = Rc::clone(&state.document.draft);
    state.document.answer = Some(Rc::new(Answer::new(draft, request, solved)));
    state
}

fn names(state: &State) -> CellNames {
    CellNames::new(
        &Cast::of(state),
        state.view.playback.time,
        state.document.draft.problems(),
    )
}

#[track_caller]
fn check_name(state: &State, (x, y): (u32, u32), expect: &str) {
    let name = names(state).name(state.document.draft.grid(), Cell::new(x, y));
    assert_eq!(name, expect);
}

#[test]
fn a_cell_tells_what_is_on_it() {
    let state = scene();
    check_name(&state, (0, 0), "0, 0: start of A");
    check_name(&state, (1, 0), "1, 0: waypoint of A");
    check_name(&state, (3, 0), "3, 0: slow zone, goal of A");
    check_name(&state, (1, 1), "1, 1: obstacle");
    check_name(&state, (0, 1), "0, 1: free");
    check_name(&state, (2, 1), "2, 1: charger, goal of B");
}

#[test]
fn a_cell_tells_who_is_there_now() {
    let mut state = planned();
    check_name(&state, (1, 0), "1, 0: waypoint of A");
    state.view.playback.time = 1;
    check_name(&state, (1, 0), "1, 0: waypoint of A, visited, A is here");
    check_name(&state, (3, 1), "3, 1: start of B, B is here");
    state.view.playback.time = 3;
    check_name(&state, (2, 0), "2, 0: slow zone, A leaves");
    check_name(&state, (3, 0), "3, 0: slow zone, goal of A, A comes");
}

#[test]
fn a_pointer_meets_an_agent_between_two_cells() {
    let cast = Cast::of(&planned());
    let at = |x, time| cast.agent_at(Point { x, y: 0.0 }, time);
    assert_eq!(
        (at(0.5, 0.5), at(0.0, 0.5), at(0.5, 0.0)),
        (Some(0), None, None)
    );
    assert_eq!(at(2.5, 3.0), Some(0));
}

#[test]
fn without_a_plan_agents_stand_at_their_starts() {
    let cast = Cast::of(&scene());
    let pose = cast.tracks[0].pose(7.0).unwrap();
    assert_eq!(pose.at, Point { x: 0.0, y: 0.0 });
    assert_eq!(pose.charge, Some(Charge { share: 0.9 }));
    assert!(!cast.has_plan());
}

#[test]
fn an_edit_of_the_ground_keeps_the_cast() {
    let state = planned();
    let cast = Cast::of(&state);
    let state = reduce(&state, Action::Board(BoardAction::PickTool(Tool::Obstacle)));
    let edited = reduce(
        &reduce(&state, Action::Board(BoardAction::Press(Cell::new(0, 1)))),
        Action::Board(BoardAction::Release),
    );
    assert!(edited.document.is_stale() && cast.is_by(&edited, edited.shown()));
    assert!(legend(&edited, &cast).contains(&Kind::Stale));
}

#[test]
fn a_plan_of_another_map_is_not_drawn() {
    let mut state = planned();
    let mut other: Scene = serde_json::from_str(SCENE).unwrap();
    other.map = vec!["....".to_owned(); 9];
    state.document.draft = Rc::new(Draft::new(other).unwrap());
    assert!(!Cast::of(&state).has_plan());
}

#[test]
fn the_legend_tells_only_what_is_there() {
    let state = planned();
    let expect = [
        Kind::Charger,
        Kind::Slow,
        Kind::Goal,
        Kind::Waypoint,
        Kind::Ahead,
        Kind::Wait,
    ];
    assert_eq!(legend(&state, &Cast::of(&state)), expect);
    let empty = State::new(Draft::default());
    assert_eq!(legend(&empty, &Cast::of(&empty)), []);
}

#[test]
fn of_a_small_map_all_cells_have_names_of_a_large_one_those_in_sight() {
    let frame = Camera::default().frame((10, 3), (900.0, 400.0));
    let window = Window::around(Cell::new(9, 2), &frame, (10, 3));
    assert_eq!((window.columns(), window.rows()), (0..10, 0..3));

    let board = (256, 40);
    let frame = Camera::default().frame(board, (900.0, 400.0));
    let has = |x, y| {
        let window = Window::around(Cell::new(x, y), &frame, board);
        assert_eq!(window.size, (32, 32));
        window.columns().contains(&x) && window.rows().contains(&y)
    };
    for x in [0, 7, 8, 31, 100, 128, 247, 255] {
        assert!(has(x, 0) && has(x, 20) && has(x, 39), "{x}");
    }
}

#[test]
fn a_hand_over_a_large_map_keeps_the_names_as_long_as_it_is_among_them() {
    let board = (256, 40);
    let frame = Camera::default().frame(board, (900.0, 400.0));
    let mut window = Window::around(Cell::new(0, 0), &frame, board);
    let mut changes = 0;
    for x in 0..256 {
        let next = window.reaching(Cell::new(x, 20), board);
        // The cell has names around it, as far as there are cells.
        for near in [x.saturating_sub(1), x, (x + 1).min(255)] {
            assert!(next.columns().contains(&near), "{near} beside {x}");
        }
        assert!(next.rows().contains(&20));
        assert_eq!(next.size, (32, 32));
        changes += u32::from(next != window);
        window = next;
    }
    assert!(changes <= 256 / 16, "{changes} windows");
    // Of a map that got smaller it reaches too far.
    let small = (200, 40);
    let next = window.reaching(Cell::new(199, 20), small);
    assert!(next.columns().end <= 200);
}
