//! Agents, goals and waypoints by hand: one gesture is one step of undo.

use giveway_model::{Agent, Cell};

use super::{after, fresh, stroke};
use crate::sample::solved;
use crate::{Action, BoardAction, Phase, PlayAction, Selection, State, Tool, words};

fn agent(state: &State, index: usize) -> &Agent {
    &state.document.draft.agents()[index]
}

fn key(x: u32, y: u32) -> [Action; 2] {
    let cell = Cell::new(x, y);
    [
        Action::Board(BoardAction::MoveCursor(cell)),
        Action::Board(BoardAction::UseTool),
    ]
}

#[test]
fn an_agent_is_placed_with_its_goal_in_one_gesture() {
    let state = after(&solved(), stroke(Tool::Agent, &[(0, 2), (4, 2), (9, 1)]));
    let placed = agent(&state, 2);
    assert_eq!(
        (placed.name.as_str(), placed.start, placed.goal),
        ("A3", Cell::new(0, 2), Cell::new(9, 1))
    );
    assert_eq!(state.view.selection, Selection::Agent(2));
    assert_eq!(state.phase(), Phase::Editing);
    let undone = after(&state, [Action::Undo]);
    assert_eq!(undone.document.draft, solved().document.draft);
    assert!(!undone.history.can_undo());
    assert_eq!(undone.view.selection, Selection::Nothing);
}

#[test]
fn an_agent_is_placed_by_two_presses() {
    let state = after(
        &fresh(),
        [Action::Board(BoardAction::PickTool(Tool::Agent))],
    );
    let half = after(&state, key(0, 2));
    assert_eq!(
        half.document.draft, state.document.draft,
        "nothing is placed yet"
    );
    assert_eq!(
        words::standing(&half).sentence,
        "A3 starts at (0, 2). Now choose its goal."
    );
    let looking = after(
        &half,
        [Action::Board(BoardAction::MoveCursor(Cell::new(4, 2)))],
    );
    let placing = looking.placing().unwrap();
    assert_eq!(
        (placing.start, placing.goal),
        (Cell::new(0, 2), Cell::new(4, 2))
    );
    let placed = after(&looking, key(9, 1));
    assert_eq!(agent(&placed, 2).goal, Cell::new(9, 1));
    assert_eq!(placed.placing(), None);
    let stays = after(&half, key(0, 2));
    assert_eq!(agent(&stays, 2).goal, Cell::new(0, 2), "it may stay");
}

#[test]
fn a_placing_can_be_left() {
    let half = after(
        &fresh(),
        [Action::Board(BoardAction::PickTool(Tool::Agent))],
    );
    let half = after(&half, key(0, 2));
    for action in [
        Action::Undo,
        Action::Board(BoardAction::Abandon),
        Action::Board(BoardAction::PickTool(Tool::Goal)),
    ] {
        let state = after(&half, [action.clone()]);
        assert_eq!(state.placing(), None, "{action:?}");
        assert_eq!(state.document.draft, fresh().document.draft);
        assert!(!state.history.can_undo());
    }
}

#[test]
fn the_least_free_name_is_given() {
    let state = after(&fresh(), stroke(Tool::Erase, &[(0, 0)]));
    assert_eq!(state.document.draft.agents().len(), 1, "A1 started there");
    let state = after(&state, stroke(Tool::Agent, &[(0, 2), (1, 2)]));
    let names: Vec<_> = state
        .document
        .draft
        .agents()
        .iter()
        .map(|a| &a.name)
        .collect();
    assert_eq!(names, ["A2", "A1"]);
}

#[test]
fn a_tool_of_agents_shows_where_they_start() {
    let state = after(
        &solved(),
        [
            Action::Play(PlayAction::Seek(7)),
            Action::Board(BoardAction::PickTool(Tool::Agent)),
        ],
    );
    assert_eq!(state.view.playback.time, 0);
    let state = after(
        &solved(),
        [
            Action::Play(PlayAction::Seek(7)),
            Action::Board(BoardAction::PickTool(Tool::Charger)),
        ],
    );
    assert_eq!(state.view.playback.time, 7);
}

#[test]
fn the_tool_agent_moves_one_that_stands_there() {
    let state = after(&fresh(), stroke(Tool::Agent, &[(0, 0), (0, 1), (0, 2)]));
    assert_eq!(state.document.draft.agents().len(), 2);
    assert_eq!(agent(&state, 0).start, Cell::new(0, 2));
}

#[test]
fn the_selected_agent_gets_another_goal() {
    let select = [
        Action::Board(BoardAction::PickTool(Tool::Goal)),
        Action::Board(BoardAction::Select(Selection::Agent(1))),
    ];
    let state = after(&fresh(), select);
    let moved = after(&state, key(8, 2));
    assert_eq!(agent(&moved, 1).goal, Cell::new(8, 2));
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
        Cell::new(8, 2),
        "the flag there is of A1"
    );
    let none = after(&fresh(), stroke(Tool::Goal, &[(4, 2), (3, 2)]));
    assert_eq!(none.document.draft, fresh().document.draft);
    assert!(
        none.view
            .notice
            .unwrap()
            .sentence
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
        Action::Board(BoardAction::Drag(Cell::new(0, 2))),
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
    assert_eq!(left[0].goal, left[0].start, "A1 ended there");
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
fn a_stale_plan_is_drawn_for_those_that_still_start_there() {
    let state = after(&solved(), stroke(Tool::Agent, &[(0, 0), (0, 1)]));
    let state = after(&state, stroke(Tool::Agent, &[(0, 2), (1, 0)]));
    let state = after(&state, [Action::Play(PlayAction::Seek(3))]);
    let at = |x, y| state.agent_at(Cell::new(x, y));
    assert_eq!(
        (at(0, 1), at(0, 2)),
        (Some(0), Some(2)),
        "these stand where they start"
    );
    assert_eq!(at(6, 2), Some(1), "this one goes on");
}
