//! A lesson on the board: opened, edited, led, pointed at, left; a person's own page is
//! put aside and back.

mod aside;
mod changes;
mod evidence;
mod hand;
mod taken;
mod tour;

use giveway_course::lesson::{Layer, Tool as LessonTool};
use giveway_course::port::{Board, BoardNumber, BoardPlan, FromPage, Hand, Happened, ToPage};
use giveway_model::format::native;
use giveway_model::{Cell, Plan, Scene};

use crate::lesson::{LessonAction, happened};
use crate::reduce::tests::after;
use crate::{Action, State};

/// Two robots that must pass each other; there is room beside the corridor.
const SIDING: &str = r##"{ "giveway": 1, "name": "siding", "map": ["....", "#.##"],
    "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] },
               { "name": "A2", "start": [3, 0], "goal": [0, 0] }] }"##;

/// Both go straight ahead, and swap.
const SWAPPING: &str = r#"{ "giveway": 1, "paths": {
    "A1": [[0, 0], [1, 0], [2, 0], [3, 0]], "A2": [[3, 0], [2, 0], [1, 0], [0, 0]] } }"#;

fn scene() -> Scene {
    native::read_scene(SIDING).unwrap()
}

fn swapping() -> Plan {
    native::read_plan(SWAPPING).unwrap()
}

/// A board on which obstacles may be painted.
fn board(number: u32) -> Board {
    Board {
        number: BoardNumber(number),
        scene: scene(),
        plan: BoardPlan::None,
        changes: None,
        time: 0,
        playing: false,
        tools: vec![LessonTool::Obstacle],
        edits: Some(1),
        cells: None,
        show: vec![Layer::Trails],
        hand: Hand::Looks,
    }
}

fn says(message: ToPage) -> LessonAction {
    LessonAction::Says(Box::new(message))
}

fn say(state: &State, message: ToPage) -> State {
    after(state, [Action::Lesson(says(message))])
}

fn opened(state: &State, board: Board) -> State {
    say(state, ToPage::Open(Box::new(board)))
}

/// What the lesson hears of some actions.
fn heard(state: &State, actions: impl IntoIterator<Item = Action>) -> (State, Vec<FromPage>) {
    let mut all = Vec::new();
    let mut state = state.clone();
    for action in actions {
        let next = after(&state, [action]);
        all.extend(happened(&state, &next));
        state = next;
    }
    (state, all)
}

fn told(number: u32, what: Happened) -> FromPage {
    FromPage {
        number: BoardNumber(number),
        what,
    }
}

const fn at(x: u32, y: u32) -> Cell {
    Cell::new(x, y)
}
