//! What does nothing says why.

use giveway_model::Cell;

use super::{after, stroke};
use crate::{Action, BoardAction, ChangeAction, Notice, Selection, State, Tool, sample};

/// A cell of the warehouse on which there is nothing.
const FREE: Cell = Cell::new(1, 0);
const DELETE: Action = Action::Board(BoardAction::Delete);

fn select(selection: Selection) -> Action {
    Action::Board(BoardAction::Select(selection))
}

fn notice(state: &State) -> Option<String> {
    state.view.notice.as_ref().map(Notice::sentence)
}

#[test]
fn delete_removes_what_is_selected_or_says_why_not() {
    let state = sample::solved();
    let nothing = after(&state, [select(Selection::Nothing), DELETE]);
    assert_eq!(nothing.document, state.document);
    let says = "Select a robot or a cell first. Then Delete removes it.";
    assert_eq!(notice(&nothing).as_deref(), Some(says));
    let empty = after(&state, [select(Selection::Cell(FREE)), DELETE]);
    assert_eq!(empty.document, state.document);
    assert_eq!(
        notice(&empty).as_deref(),
        Some("There is nothing to erase here.")
    );
    let painted = after(&state, stroke(Tool::Obstacle, &[(FREE.x, FREE.y)]));
    let erased = after(&painted, [select(Selection::Cell(FREE)), DELETE]);
    assert_eq!(erased.document.draft.scene(), state.document.draft.scene());
    assert_eq!(notice(&erased).as_deref(), None);
    let agents = state.document.agents().len();
    let removed = after(&state, [select(Selection::Agent(0)), DELETE]);
    assert_eq!(removed.document.agents().len(), agents - 1);
    let back = after(&removed, [Action::Undo]);
    assert_eq!(back.document.agents().len(), agents);
}

#[test]
fn in_a_world_that_changes_it_lists_the_removal() {
    let state = after(
        &sample::solved(),
        [
            Action::Change(ChangeAction::Begin),
            select(Selection::Agent(0)),
            DELETE,
        ],
    );
    assert_eq!(state.document.mode.changing().unwrap().list.len(), 1);
}

#[test]
fn an_eraser_and_a_key_that_find_nothing_say_so() {
    let state = sample::solved();
    let Cell { x, y } = FREE;
    let erased = after(&state, stroke(Tool::Erase, &[(x, y)]));
    assert_eq!(
        notice(&erased).as_deref(),
        Some("There is nothing to erase here.")
    );
    let carries = BoardAction::StepCursor {
        by: (1, 0),
        carries: true,
    };
    let cursor = || Action::Board(BoardAction::MoveCursor(Cell { x, y }));
    let framed = after(&state, [cursor(), Action::Board(carries.clone())]);
    assert!(framed.has_area(), "a part of the floor is framed");
    // While the world changes no part of the floor is selected.
    let changing = after(&state, [Action::Change(ChangeAction::Begin)]);
    let moved = after(&changing, [cursor(), Action::Board(carries)]);
    let says = format!("There is nothing to move at ({x}, {y}).");
    assert_eq!(notice(&moved).as_deref(), Some(says.as_str()));
    assert_eq!(moved.view.cursor, Cell::new(x + 1, y));
}
