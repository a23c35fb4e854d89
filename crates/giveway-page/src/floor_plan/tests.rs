//! A floor plan: laid, placed, given a scale, turned into cells.

use std::rc::Rc;

use giveway_model::{Agent, Cell, Ground, Scene};

use super::{Card, End, FloorPlanAction, Picture, card, laid, row};
use crate::edit::Paint;
use crate::keys::{Command, Key, command};
use crate::reduce::tests::after;
use crate::{Action, BoardAction, Draft, FileAction, Selection, SolveAction, State, Tool};

/// A map of 8 × 6 free cells, with a robot from the left to the right.
pub(super) fn board() -> State {
    let agent = Agent::new("A1", Cell::new(0, 0), Some(Cell::new(7, 5)));
    let scene = Scene {
        map: vec![".".repeat(8); 6],
        agents: vec![agent],
        ..Scene::default()
    };
    State::new(Draft::new(scene).unwrap())
}

/// 80 × 40 pixels: the left half is dark; and of the right half the lower right quarter.
fn picture() -> Rc<Picture> {
    let dark = |pixel: usize| {
        let (x, y) = (pixel % 80, pixel / 80);
        x < 40 || (x >= 60 && y >= 20)
    };
    let grey: Vec<u8> = (0..3200)
        .map(|pixel| if dark(pixel) { 0 } else { 255 })
        .collect();
    let name = ("hall.png".to_owned(), "blob:1".to_owned());
    Rc::new(Picture::new(name, (80, 40), &grey, 128))
}

pub(super) fn say(state: &State, actions: &[FloorPlanAction]) -> State {
    after(state, actions.iter().cloned().map(Action::FloorPlan))
}

pub(super) fn under() -> State {
    say(&board(), &[FloorPlanAction::Lay(picture(), None)])
}

fn shown(state: &State) -> Card {
    card(state).unwrap()
}

fn escaped(state: &State) -> State {
    let key = Key {
        name: "Escape",
        ..Key::default()
    };
    let Some(Command::Act(action)) = command(key, state) else {
        panic!("there is something to close");
    };
    after(state, [action])
}

fn obstacles(state: &State) -> Vec<Cell> {
    let grid = state.document.draft.grid();
    let cells = (0..grid.height()).flat_map(|y| (0..grid.width()).map(move |x| Cell::new(x, y)));
    cells
        .filter(|&cell| grid.ground(cell) == Some(Ground::Obstacle))
        .collect()
}

#[test]
fn dark_cells_become_obstacles_in_one_step_of_undo() {
    let state = under();
    // 8 cells of ten pixels: 4 × 4 dark at the left, less the start, and 2 × 2 at the right.
    let card = shown(&state);
    assert_eq!(card.told, "19 cells become obstacles");
    assert_eq!(card.draw.as_deref(), Some("Draw 19 obstacles"));
    assert!(
        card.close[0].starts_with("1 dark cell stays free"),
        "{:?}",
        card.close
    );
    let drawn = say(&state, &[FloorPlanAction::Draw]);
    assert_eq!(obstacles(&drawn).len(), 19);
    assert!(
        super::card(&drawn).is_none() && laid(&drawn).is_some(),
        "it stays under the grid"
    );
    assert_eq!(obstacles(&after(&drawn, [Action::Undo])), []);
    // Nothing is drawn twice.
    assert_eq!(shown(&say(&drawn, &[FloorPlanAction::Open])).draw, None);
}

#[test]
fn what_is_drawn_is_what_each_turn_shows() {
    let mut state = say(&under(), &[FloorPlanAction::Wide(4.0)]);
    let at = |cells: &[(u32, u32)]| -> Vec<Cell> {
        cells.iter().map(|&(x, y)| Cell::new(x, y)).collect()
    };
    // As 4 × 2 cells: the left half, and the lower right cell; turned clockwise 2 × 4.
    let turns = [
        at(&[(1, 0), (0, 1), (1, 1), (3, 1)]),
        at(&[(1, 0), (0, 1), (1, 1), (0, 3)]),
        at(&[(0, 0), (2, 0), (3, 0), (2, 1), (3, 1)]),
        at(&[(1, 0), (0, 2), (1, 2), (0, 3), (1, 3)]),
    ];
    for (turn, expected) in turns.iter().enumerate() {
        let mut found = laid(&state).unwrap().cells[0].clone();
        // The robot's start is dark there, and stays free.
        found.extend((turn == 2).then_some(Cell::new(0, 0)));
        found.sort_by_key(|cell| (cell.y, cell.x));
        assert_eq!(&found, expected, "turn {turn}");
        state = say(&state, &[FloorPlanAction::Turn]);
    }
    // Four turns are none.
    let (once, whole) = (
        say(&under(), &[FloorPlanAction::Wide(4.0)]),
        laid(&state).unwrap(),
    );
    let once = laid(&once).unwrap();
    assert_eq!((once.transform, once.cells), (whole.transform, whole.cells));
    let far = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).hypot(a.1 - b.1);
    assert!(
        far(once.points[1], whole.points[1]) < 1e-9,
        "the points went along"
    );
}

#[test]
fn a_cell_that_is_pressed_is_turned_over_until_the_picture_moves() {
    let press = Action::Board(BoardAction::Select(Selection::Cell(Cell::new(5, 0))));
    let state = after(&under(), [press.clone()]);
    assert_eq!(shown(&state).told, "20 cells become obstacles");
    assert_eq!(state.view.selection, Selection::Nothing);
    let back = after(&state, [press]);
    assert_eq!(shown(&back).told, "19 cells become obstacles");
    let darker = say(&state, &[FloorPlanAction::Threshold(90)]);
    assert_eq!(shown(&darker).told, "20 cells become obstacles");
    let moved = say(
        &state,
        &[FloorPlanAction::Move(-1.0, 0.0), FloorPlanAction::Left(0.0)],
    );
    assert_eq!(shown(&moved).told, "19 cells become obstacles");
}

#[test]
fn half_a_cell_is_close_to_the_line() {
    let state = say(&under(), &[FloorPlanAction::Left(0.5)]);
    // Cells of the edges of both dark parts are half dark.
    assert!(shown(&state).close[0].contains("close to the line"));
    let many = laid(&say(&state, &[FloorPlanAction::Threshold(50)]))
        .unwrap()
        .cells[0]
        .len();
    let few = laid(&say(&state, &[FloorPlanAction::Threshold(51)]))
        .unwrap()
        .cells[0]
        .len();
    assert!(few < many, "{few} {many}");
}

#[test]
fn two_points_and_their_distance_give_the_scale() {
    // From a tenth to nine tenths of 80 pixels: 64 pixels, 32 m, half a metre a pixel.
    let state = say(
        &under(),
        &[
            FloorPlanAction::Apart(Some(32.0)),
            FloorPlanAction::CellSize(2.0),
        ],
    );
    let card = shown(&state);
    assert!((card.place.2 - 20.0).abs() < 1e-9, "{:?}", card.place);
    assert_eq!(card.grow.as_deref(), Some("Make the map 20 × 10"));
    let state = say(&state, &[FloorPlanAction::Grow]);
    assert_eq!(shown(&state).grow, None);
    assert_eq!(
        shown(&state).size.as_deref(),
        Some("20 × 10 cells are 40 × 20 m.")
    );
    // The second point goes half as far: the same metres are more cells.
    let nearer = say(&state, &[FloorPlanAction::Point(End::Second, -8.0, 0.0)]);
    assert!((shown(&nearer).place.2 - 40.0).abs() < 1e-6);
    // Who stretches it by hand says nothing of metres any longer.
    assert_eq!(
        shown(&say(&state, &[FloorPlanAction::Wide(8.0)])).apart,
        None
    );
}

#[test]
fn a_map_of_a_robot_brings_its_scale() {
    let state = say(
        &board(),
        &[
            FloorPlanAction::Lay(picture(), Some(0.05)),
            FloorPlanAction::CellSize(0.5),
        ],
    );
    assert!((shown(&state).place.2 - 8.0).abs() < 1e-9);
    assert_eq!(
        shown(&state).size.as_deref(),
        Some("8 × 6 cells are 4 × 3 m.")
    );
}

#[test]
fn slow_cells_can_be_drawn_where_robots_stand() {
    let state = say(&under(), &[FloorPlanAction::Becomes(Paint::Slow)]);
    assert_eq!(shown(&state).draw.as_deref(), Some("Draw 20 slow cells"));
    let drawn = say(&state, &[FloorPlanAction::Draw]);
    assert_eq!(
        drawn.document.draft.grid().ground(Cell::new(0, 0)),
        Some(Ground::Slow)
    );
}

#[test]
fn escape_drops_it_and_going_on_keeps_it() {
    let state = under();
    let dropped = escaped(&state);
    assert_eq!((row(&dropped), card(&dropped)), (None, None));
    let picked = after(
        &state,
        [Action::Board(BoardAction::PickTool(Tool::Obstacle))],
    );
    assert!(card(&picked).is_none() && row(&picked).is_some());
    let solved = after(&state, [Action::Solve(SolveAction::Solve)]);
    assert!(card(&solved).is_none() && row(&solved).is_some());
    // Once its cells are drawn, it stays.
    let drawn = say(&state, &[FloorPlanAction::Draw, FloorPlanAction::Open]);
    let left = escaped(&drawn);
    assert!(row(&left).is_some() && card(&left).is_none());
    let hidden = say(&left, &[FloorPlanAction::Show(false)]);
    assert!(laid(&hidden).is_none() && row(&hidden).is_some());
    assert_eq!(row(&say(&hidden, &[FloorPlanAction::Remove])), None);
}

#[test]
fn another_scene_has_none() {
    let scene = Scene {
        map: vec!["..".into()],
        ..Scene::default()
    };
    let other = after(&under(), [Action::File(FileAction::Open(Box::new(scene)))]);
    assert_eq!(row(&other), None);
}

#[test]
fn a_known_scale_gives_the_scene_its_units_with_the_cells() {
    // Half a metre a pixel would be 40 m; a cell is 5 m wide.
    let lay = FloorPlanAction::Lay(picture(), Some(0.5));
    let known = say(&board(), &[lay.clone(), FloorPlanAction::CellSize(5.0)]);
    let told = shown(&known).units.unwrap();
    assert!(
        told.contains("a cell is 5 m wide, a step takes 1 s"),
        "{told}"
    );
    let drawn = say(&known, &[FloorPlanAction::Draw]);
    let units = |state: &State| {
        let units = state.document.draft.scene().units;
        units.map(|units| (units.cell.thousandths(), units.step.thousandths()))
    };
    assert_eq!(units(&drawn), Some((5000, 1000)));
    let undone = after(&drawn, [Action::Undo]);
    assert_eq!((units(&undone), obstacles(&undone)), (None, vec![]));
    // Nothing is said of units where no scale is known, and none are made.
    assert_eq!(shown(&under()).units, None);
    assert_eq!(units(&say(&under(), &[FloorPlanAction::Draw])), None);
    // Units that are there stay, and the picture is laid by them.
    let own = say(&drawn, &[FloorPlanAction::Remove, lay]);
    assert_eq!((shown(&own).cell, shown(&own).units), (5.0, None));
    let again = say(
        &own,
        &[FloorPlanAction::CellSize(2.0), FloorPlanAction::Draw],
    );
    assert_eq!(units(&again), Some((5000, 1000)));
}
