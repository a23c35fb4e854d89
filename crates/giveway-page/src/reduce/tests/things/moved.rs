//! Goals, waypoints and what else is on a cell: set, moved and taken away.

use giveway_model::Cell;

use super::{agent, key};
use crate::reduce::tests::{after, fresh, stroke};
use crate::sample::solved;
use crate::{Action, BoardAction, Phase, Selection, State, Tool, ViewAction};

#[test]
fn the_selected_agent_gets_another_goal() {
    let select = [
        Action::Board(BoardAction::PickTool(Tool::Goal)),
        Action::Board(BoardAction::Select(Selection::Agent(1))),
    ];
    let state = after(&fresh(), select);
    let moved = after(&state, key(8, 2));
    assert_eq!(agent(&moved, 1).goal, Some(Cell::new(8, 2)));
    assert_eq!(
        after(&moved, [Action::Undo]).document.draft,
        fresh().document.draft
    );
    // The goal of another is taken hold of instead: no two may share one.
    let other = after(&state, key(9, 2));
    assert_eq!(other.document.draft, fresh().document.draft);
    assert_eq!(other.view.selection, Selection::Agent(0));
}

#[test]
fn without_a_selection_a_goal_is_drawn_from_the_agent() {
    let state = after(&fresh(), stroke(Tool::Goal, &[(9, 2), (8, 2)]));
    assert_eq!(
        agent(&state, 0).goal,
        Some(Cell::new(8, 2)),
        "the flag there is of A1"
    );
    let none = after(&fresh(), stroke(Tool::Goal, &[(4, 2), (3, 2)]));
    assert_eq!(none.document.draft, fresh().document.draft);
    assert!(
        none.view
            .notice
            .unwrap()
            .sentence()
            .starts_with("Press a robot first")
    );
}

#[test]
fn waypoints_are_added_moved_and_taken_away() {
    let select = [
        Action::Board(BoardAction::PickTool(Tool::Waypoint)),
        Action::Board(BoardAction::Select(Selection::Agent(1))),
    ];
    let state = after(&fresh(), select);
    let added = after(&state, key(8, 2));
    let waypoints = |state: &State| agent(state, 1).waypoints.clone();
    let cells =
        |cells: &[(u32, u32)]| -> Vec<Cell> { cells.iter().map(|&cell| cell.into()).collect() };
    assert_eq!(waypoints(&added), cells(&[(5, 0), (1, 2), (8, 2)]));
    let moved = after(&added, stroke(Tool::Waypoint, &[(1, 2), (2, 2), (2, 0)]));
    assert_eq!(waypoints(&moved), cells(&[(5, 0), (2, 0), (8, 2)]));
    let back = after(&moved, stroke(Tool::Waypoint, &[(2, 0), (2, 2), (2, 0)]));
    assert_eq!(
        back.document.draft, moved.document.draft,
        "moved there and back is no press"
    );
    let gone = after(&moved, key(5, 0));
    assert_eq!(waypoints(&gone), cells(&[(2, 0), (8, 2)]));
    let undone = after(&gone, [Action::Undo, Action::Undo, Action::Undo]);
    assert_eq!(
        undone.document.draft,
        fresh().document.draft,
        "each is one step"
    );
    assert!(!undone.history.can_undo());
}

#[test]
fn select_moves_what_is_on_a_cell() {
    let moved = |from, to| after(&fresh(), stroke(Tool::Select, &[from, (3, 0), to]));
    assert_eq!(agent(&moved((0, 0), (0, 1)), 0).start, Cell::new(0, 1));
    assert_eq!(
        agent(&moved((2, 0), (1, 0)), 0).waypoints[0],
        Cell::new(1, 0)
    );
    let rows = |state: &State| state.document.draft.scene().map.clone();
    assert_eq!(rows(&moved((3, 2), (2, 2)))[2], "..+...+...");
    let charger = moved((3, 2), (3, 0));
    assert_eq!(rows(&charger)[0], "..~*~~~~..", "it lies in the slow zone");
    assert_eq!(rows(&moved((1, 1), (0, 1)))[1], "#.#.##.##.");
    assert_eq!(
        moved((1, 1), (0, 0)).document.draft,
        fresh().document.draft,
        "not onto an agent"
    );
    assert_eq!(
        moved((1, 1), (2, 1)).document.draft,
        fresh().document.draft,
        "not onto another obstacle, where it would be lost"
    );
    let state = moved((1, 1), (0, 1));
    assert_eq!(state.view.selection, Selection::Cell(Cell::new(0, 1)));
    assert_eq!(
        after(&state, [Action::Undo]).document.draft,
        fresh().document.draft
    );
}

#[test]
fn a_press_alone_moves_nothing() {
    for cell in [(0, 0), (2, 0), (3, 2), (1, 1), (1, 0)] {
        let state = after(&solved(), stroke(Tool::Select, &[cell]));
        assert_eq!(state.phase(), Phase::Planned, "{cell:?}");
        assert!(!state.history.can_undo());
    }
}

#[test]
fn a_stroke_can_be_left() {
    let actions = [
        Action::Board(BoardAction::PickTool(Tool::Select)),
        Action::Board(BoardAction::Press(Cell::new(0, 0))),
        Action::Board(BoardAction::Drag(vec![Cell::new(0, 2)])),
    ];
    let state = after(&solved(), actions);
    assert_eq!(state.world().agents()[0].start, Cell::new(0, 2));
    let left = after(&state, [Action::Board(BoardAction::Abandon)]);
    assert_eq!(left.world().agents()[0].start, Cell::new(0, 0));
    assert_eq!(left.phase(), Phase::Planned);
    assert_eq!(left.document.draft, solved().document.draft);
}

#[test]
fn erasing_takes_waypoints_goals_and_agents() {
    let state = after(&fresh(), stroke(Tool::Erase, &[(5, 0)]));
    assert_eq!(agent(&state, 1).waypoints, [Cell::new(1, 2)]);
    assert_eq!(state.document.draft.scene().map[0], "..~~~.~~..");
    let state = after(&fresh(), stroke(Tool::Erase, &[(9, 2)]));
    let left = state.document.draft.agents();
    assert_eq!(left.len(), 1, "A2 started there");
    assert_eq!(left[0].goal, None, "A1 ended there");
    assert_eq!(
        after(&state, [Action::Undo]).document.draft,
        fresh().document.draft
    );
}

#[test]
fn the_selection_follows_its_agent() {
    let state = after(
        &fresh(),
        [Action::Board(BoardAction::Select(Selection::Agent(1)))],
    );
    let state = after(&state, stroke(Tool::Erase, &[(0, 0)]));
    assert_eq!(state.view.selection, Selection::Agent(0), "A2 came forward");
    let undone = after(&state, [Action::Undo]);
    assert_eq!(undone.view.selection, Selection::Agent(1));
    let gone = after(&undone, stroke(Tool::Erase, &[(9, 2)]));
    assert_eq!(gone.view.selection, Selection::Nothing);
}

#[test]
fn the_board_stands_still_while_something_is_dragged() {
    let state = after(
        &fresh(),
        [
            Action::View(ViewAction::Follow(true)),
            Action::Board(BoardAction::Press(Cell::new(0, 0))),
            Action::Board(BoardAction::Drag(vec![Cell::new(0, 1)])),
        ],
    );
    assert_eq!(state.selected_agent(), Some(0), "it was taken hold of");
    assert_eq!(state.followed(), None);
    let dropped = after(&state, [Action::Board(BoardAction::Release)]);
    assert_eq!(agent(&dropped, 0).start, Cell::new(0, 1));
    assert_eq!(dropped.followed(), Some(0));
    let nothing = Action::Board(BoardAction::Select(Selection::Nothing));
    let other = Action::Board(BoardAction::Select(Selection::Agent(1)));
    let other = after(&dropped, [nothing, other]);
    assert_eq!(other.followed(), None, "it is not followed unasked");
}
