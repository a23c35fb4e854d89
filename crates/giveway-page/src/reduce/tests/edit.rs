//! Edits, undo and redo.

use giveway_model::{Agent, Cell, Scene};

use super::{after, edit, fresh, stroke};
use crate::sample::solved;
use crate::{
    Action, BoardAction, Edit, FileAction, MAX_SIDE, Phase, Selection, SolveAction, State, Tool,
    ViewAction,
};

fn row(state: &State, y: usize) -> &str {
    &state.document.draft.scene().map[y]
}

#[test]
fn a_stroke_is_one_step_of_undo() {
    let painted = after(&fresh(), stroke(Tool::Obstacle, &[(5, 2), (6, 2), (8, 2)]));
    assert_eq!(row(&painted, 2), "...+.####.", "without gaps");
    let undone = after(&painted, [Action::Undo]);
    assert_eq!(undone.document.draft, fresh().document.draft);
    assert!(!undone.history.can_undo());
    let redone = after(&undone, [Action::Redo]);
    assert_eq!(redone.document.draft, painted.document.draft);
    assert!(!redone.history.can_redo());
}

#[test]
fn a_stroke_shows_before_it_ends() {
    let actions = [
        Action::Board(BoardAction::PickTool(Tool::Charger)),
        Action::Board(BoardAction::Press(Cell::new(0, 1))),
        Action::Board(BoardAction::Drag(vec![Cell::new(0, 2)])),
    ];
    let state = after(&fresh(), actions);
    let map = &state.world().scene().map;
    assert_eq!(map[1..], ["+##.##.##.", "+..+..+..."]);
    assert_eq!(state.document, fresh().document, "the document comes last");
    assert!(!state.history.can_undo(), "not yet");
    let state = after(&state, [Action::Board(BoardAction::PickTool(Tool::Select))]);
    assert!(state.history.can_undo(), "another tool ends it");
}

#[test]
fn a_stroke_that_changes_nothing_is_none() {
    let state = after(&fresh(), stroke(Tool::Erase, &[(1, 0)]));
    assert!(!state.history.can_undo());
}

#[test]
fn what_agents_need_is_not_built_over() {
    let state = after(&fresh(), stroke(Tool::Obstacle, &[(1, 0), (0, 0)]));
    assert_eq!(row(&state, 0), ".#~~~~~~..");
}

#[test]
fn a_new_edit_forgets_what_was_undone() {
    let state = after(&fresh(), edit());
    let state = after(&state, [Action::Undo]);
    let state = after(&state, stroke(Tool::Obstacle, &[(9, 1)]));
    assert!(!state.history.can_redo());
}

#[test]
fn an_edit_makes_the_plan_stale_and_undo_fresh_again() {
    let planned = solved();
    assert_eq!(planned.phase(), Phase::Planned);
    let stale = after(&planned, edit());
    assert!(stale.document.is_stale() && !stale.view.playback.playing);
    assert_eq!(stale.phase(), Phase::Editing);
    assert!(stale.plan().is_some(), "shown faded");
    assert!(stale.document.fresh_answer().is_none());
    let undone = after(&stale, [Action::Undo]);
    assert!(!undone.document.is_stale());
    assert_eq!(undone.phase(), Phase::Planned);
    assert_eq!(after(&undone, [Action::Redo]).phase(), Phase::Editing);
}

#[test]
fn edits_cancel_a_solve() {
    let solving = after(&fresh(), [Action::Solve(SolveAction::Solve)]);
    assert!(after(&solving, edit()).work.is_idle());
    let undone = after(&fresh(), edit());
    let undone = after(&undone, [Action::Solve(SolveAction::Solve), Action::Undo]);
    assert!(undone.work.is_idle());
    let redone = after(&undone, [Action::Solve(SolveAction::Solve), Action::Redo]);
    assert!(redone.work.is_idle());
}

#[test]
fn every_edit_may_be_solved_at_once() {
    let state = after(
        &solved(),
        [Action::View(ViewAction::SetSolveOnChange(true))],
    );
    let state = after(&state, edit());
    assert_eq!(state.phase(), Phase::Solving);
    let run = state.work.solving().unwrap();
    assert_eq!(run.draft, state.document.draft);
    let undone = after(&state, [Action::Undo]);
    assert_eq!(undone.phase(), Phase::Planned, "answered already");
}

#[test]
fn undo_of_nothing_does_nothing() {
    let state = fresh();
    assert_eq!(after(&state, [Action::Undo, Action::Redo]), state);
}

fn open(rows: &[&str]) -> Action {
    Action::File(FileAction::Open(Box::new(Scene {
        name: "other".to_owned(),
        map: rows.iter().map(|&row| row.to_owned()).collect(),
        ..Scene::default()
    })))
}

#[test]
fn a_crowd_opens_without_the_plan_table() {
    let agent = |x| Agent {
        name: format!("A{x}"),
        start: Cell::new(x, 0),
        goal: Some(Cell::new(x, 1)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    let crowd = |agents| {
        Action::File(FileAction::Open(Box::new(Scene {
            map: vec![".".repeat(9); 2],
            agents: (0..agents).map(agent).collect(),
            ..Scene::default()
        })))
    };
    let before = solved();
    assert!(before.view.table);
    let table = |agents| after(&before, [crowd(agents)]).view.table;
    assert_eq!((table(6), table(7)), (true, false));
}

#[test]
fn opening_replaces_the_scene_and_can_be_undone() {
    let actions = [
        Action::Board(BoardAction::Select(Selection::Agent(1))),
        Action::Edit(Edit::Within(Some(20))),
        Action::View(ViewAction::SetSeconds(7)),
    ];
    let state = after(&solved(), actions);
    let state = after(
        &state,
        [
            Action::Board(BoardAction::MoveCursor(Cell::new(9, 2))),
            open(&["..", ".."]),
        ],
    );
    assert_eq!(state.document.draft.scene().name, "other");
    assert_eq!(state.document.answer, None);
    let (within, seconds) = (state.document.within, state.settings.seconds);
    assert_eq!((within, seconds), (None, 7));
    assert_eq!(state.view.selection, Selection::Nothing);
    assert_eq!(
        (state.view.playback.time, state.view.playback.playing),
        (0, false)
    );
    assert_eq!(state.view.cursor, Cell::new(1, 1));
    let undone = after(&state, [Action::Undo]);
    assert_eq!(undone.document.draft, solved().document.draft);
}

#[test]
fn opening_cancels_a_solve() {
    let state = after(&fresh(), [Action::Solve(SolveAction::Solve), open(&[".."])]);
    assert!(state.work.is_idle());
}

#[test]
fn what_cannot_be_drawn_or_solved_is_refused_and_the_old_scene_stays() {
    let before = solved();
    let wide = ".".repeat(MAX_SIDE as usize + 1);
    for rows in [&["..", "."][..], &[], &[wide.as_str()], &["x"]] {
        let state = after(&before, [open(rows)]);
        let notice = state.view.notice.clone().unwrap();
        assert!(!notice.details().is_empty(), "{rows:?}");
        let dismissed = after(&state, [Action::View(ViewAction::DismissNotice)]);
        assert_eq!(dismissed, before, "{rows:?}");
    }
}
