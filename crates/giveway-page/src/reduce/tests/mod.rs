//! Every action, on the warehouse.

mod ask;
mod edit;
mod looks;
mod nothing;
mod notices;
mod play;
mod preview;
mod proof;
mod solve;
mod stale;
mod stopped;
mod things;
mod words;

pub(crate) use ask::asked_and_answered;
use giveway_model::{AtGoal, Cell, Cost, Objective};

use crate::sample::{draft, solved};
use crate::{
    Action, BoardAction, Edit, FileAction, Notice, PlayAction, Selection, Speed, State, Tab, Theme,
    Tool, ViewAction, reduce,
};

/// The warehouse before anything was done.
fn fresh() -> State {
    State::new(draft())
}

/// The state after one action after the other.
pub(crate) fn after(state: &State, actions: impl IntoIterator<Item = Action>) -> State {
    actions.into_iter().fold(state.clone(), |state, action| {
        let next = reduce(&state, action.clone());
        assert_eq!(next, reduce(&state, action), "pure");
        next
    })
}

/// A stroke of a tool over cells.
pub(crate) fn stroke(tool: Tool, cells: &[(u32, u32)]) -> Vec<Action> {
    let mut cells = cells.iter().map(|&(x, y)| Cell::new(x, y));
    let first = cells.next().unwrap();
    let mut actions = vec![
        Action::Board(BoardAction::PickTool(tool)),
        Action::Board(BoardAction::Press(first)),
    ];
    actions.extend(cells.map(|cell| Action::Board(BoardAction::Drag(vec![cell]))));
    actions.push(Action::Board(BoardAction::Release));
    actions
}

/// An edit that no plan of the warehouse minds.
fn edit() -> Vec<Action> {
    stroke(Tool::Charger, &[(1, 0)])
}

#[test]
fn tools_cursor_and_selection() {
    let state = after(
        &fresh(),
        [Action::Board(BoardAction::PickTool(Tool::Erase))],
    );
    assert_eq!(state.view.tool, Tool::Erase);
    let state = after(
        &state,
        [Action::Board(BoardAction::MoveCursor(Cell::new(99, 1)))],
    );
    assert_eq!(state.view.cursor, Cell::new(9, 1), "kept on the map");
    let state = after(
        &state,
        [Action::Board(BoardAction::Select(Selection::Agent(1)))],
    );
    assert_eq!(state.view.selection, Selection::Agent(1));
}

#[test]
fn the_keyboard_goes_step_by_step_as_far_as_the_map() {
    let step = |right, down| {
        Action::Board(BoardAction::StepCursor {
            by: (right, down),
            carries: false,
        })
    };
    let state = after(&fresh(), [step(i32::MIN, i32::MIN), step(0, 1)]);
    assert_eq!(state.view.cursor, Cell::new(0, 1));
    let tools = [
        Action::Board(BoardAction::PickTool(Tool::Obstacle)),
        Action::Board(BoardAction::UseTool),
    ];
    let state = after(&after(&state, tools), [step(0, 1), step(-1, 0)]);
    assert_eq!(state.view.cursor, Cell::new(0, 2));
    let state = after(
        &state,
        [
            Action::Board(BoardAction::PickTool(Tool::Charger)),
            Action::Board(BoardAction::UseTool),
        ],
    );
    let grid = state.document.draft.grid();
    assert!(!grid.is_vertex(Cell::new(0, 1)) && grid.is_charger(Cell::new(0, 2)));
    let state = after(&state, [step(i32::MAX, i32::MAX), step(1, 1)]);
    assert_eq!(state.view.cursor, Cell::new(9, 2));
}

#[test]
fn the_keyboard_carries_what_is_there() {
    let start = fresh().document.draft.agents()[1].start;
    let state = after(
        &fresh(),
        [
            Action::Board(BoardAction::PickTool(Tool::Select)),
            Action::Board(BoardAction::MoveCursor(start)),
        ],
    );
    let up = Action::Board(BoardAction::StepCursor {
        by: (0, -1),
        carries: true,
    });
    let moved = after(&state, [up.clone()]);
    assert_eq!(
        moved.document.draft.agents()[1].start,
        Cell::new(start.x, start.y - 1)
    );
    assert_eq!(moved.view.cursor, moved.document.draft.agents()[1].start);
    let brush = after(
        &state,
        [Action::Board(BoardAction::PickTool(Tool::Obstacle)), up],
    );
    assert_eq!(
        brush.document.draft, state.document.draft,
        "a brush has nothing to carry"
    );
}

#[test]
fn select_takes_the_agent_or_else_the_cell() {
    let press = |x, y| Action::Board(BoardAction::Press(Cell::new(x, y)));
    let state = after(&fresh(), [press(9, 2)]);
    assert_eq!(state.view.selection, Selection::Agent(1));
    let state = after(&state, [press(4, 1)]);
    assert_eq!(state.view.selection, Selection::Cell(Cell::new(4, 1)));
    assert!(!state.history.can_undo());
}

#[test]
fn what_is_shown() {
    let actions = [
        Action::View(ViewAction::ShowTrails(false)),
        Action::View(ViewAction::ShowHeat(true)),
        Action::Edit(Edit::Recolour(1, 8)),
        Action::View(ViewAction::Follow(true)),
        Action::View(ViewAction::ShowTable(false)),
        Action::View(ViewAction::ShowTab(Tab::Plan)),
        Action::View(ViewAction::SetTheme(Theme::Dark)),
        Action::Play(PlayAction::SetSpeed(Speed::Four)),
    ];
    let state = after(&fresh(), actions);
    assert!(!state.view.layers.trails && !state.view.table);
    assert_eq!((state.view.tab, state.view.theme), (Tab::Plan, Theme::Dark));
    assert_eq!(state.view.playback.speed, Speed::Four);
    assert_eq!(
        (state.document.colours.of(1), state.document.colours.of(0)),
        (8, 0)
    );
    let same = after(&state, [Action::Edit(Edit::Recolour(0, 12))]);
    assert_eq!(same, state, "there is no such colour");
    let plain = after(&state, [Action::Undo]).document.colours;
    assert_eq!(plain.of(1), 1, "colours belong to the document");
}

#[test]
fn notices_come_and_go() {
    let notice = Notice::refusal("No.");
    let before = solved();
    let state = after(&before, [Action::File(FileAction::Tell(notice.clone()))]);
    assert_eq!(state.view.notice, Some(notice));
    assert_eq!(
        after(&state, [Action::View(ViewAction::DismissNotice)]),
        before
    );
}

#[test]
fn limits_are_no_part_of_the_scene() {
    let actions = [
        Action::Edit(Edit::Within(Some(40))),
        Action::View(ViewAction::SetSeconds(0)),
        Action::View(ViewAction::SetSolveOnChange(true)),
    ];
    let state = after(&solved(), actions);
    assert_eq!(state.document.within, Some(40));
    assert_eq!(state.settings.seconds, 1, "at least one second");
    assert!(state.settings.solve_on_change);
    assert!(!state.document.is_stale());
    assert_eq!(after(&state, [Action::Undo]).document.within, None);
}

#[test]
fn objective_and_rules_are_edits_of_the_scene() {
    let objective = Objective::new(vec![Cost::Charges]).unwrap();
    let actions = [
        Action::Edit(Edit::Objective(objective.clone())),
        Action::Edit(Edit::AtGoal(AtGoal::Vanish)),
        Action::Edit(Edit::BatteryFloor(2)),
    ];
    let mut state = solved();
    for action in actions.clone() {
        state = after(&state, [action]);
        assert!(state.document.is_stale() && state.history.can_undo());
    }
    let scene = state.document.draft.scene();
    assert_eq!(scene.objective, objective);
    assert_eq!(scene.rules.at_goal, AtGoal::Vanish);
    assert_eq!(scene.rules.battery_floor, 2);
    let again = after(&state, actions);
    assert_eq!(again, state, "what changes nothing is no step of undo");
    let undone = after(&state, [Action::Undo, Action::Undo, Action::Undo]);
    assert_eq!(undone.document.draft, solved().document.draft);
}
