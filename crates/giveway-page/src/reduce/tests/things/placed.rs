//! Agents are placed: with a goal, in one gesture or two.

use giveway_model::Cell;

use super::{agent, key};
use crate::reduce::tests::{after, fresh, stroke};
use crate::sample::solved;
use crate::{Action, BoardAction, Phase, PlayAction, Selection, Tool, words};

#[test]
fn an_agent_is_placed_with_its_goal_in_one_gesture() {
    let state = after(&solved(), stroke(Tool::Agent, &[(0, 2), (4, 2), (9, 1)]));
    let placed = agent(&state, 2);
    assert_eq!(
        (placed.name.as_str(), placed.start, placed.goal),
        ("A3", Cell::new(0, 2), Some(Cell::new(9, 1)))
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
    assert_eq!(agent(&placed, 2).goal, Some(Cell::new(9, 1)));
    assert_eq!(placed.placing(), None);
    let stays = after(&half, key(0, 2));
    assert_eq!(agent(&stays, 2).goal, Some(Cell::new(0, 2)), "it may stay");
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
