//! Keys with and without a plan, with Ctrl, and Escape.

use super::*;
use crate::grow::{GrowAction, Side};
use crate::{Draft, Notice, Selection, reduce};

fn state() -> State {
    State::new(Draft::default())
}

fn key(name: &str) -> Key<'_> {
    Key {
        name,
        ..Key::default()
    }
}

fn act(key: Key<'_>, state: &State) -> Option<Action> {
    match command(key, state) {
        Some(Command::Act(action)) => Some(action),
        _ => None,
    }
}

#[test]
fn every_tool_has_its_key_and_its_row() {
    let rows = HELP.iter().flat_map(|(_, rows)| rows.iter());
    let rows: Vec<_> = rows.collect();
    for tool in Tool::ALL {
        let name = tool.key().to_string();
        assert_eq!(
            act(key(&name), &state()),
            Some(Action::Board(BoardAction::PickTool(tool)))
        );
        let upper = name.to_uppercase();
        let told = rows.iter().find(|row| row.keys == [upper.as_str()]);
        assert_eq!(told.map(|row| row.what.text()), Some(tool.name()));
    }
}

#[test]
fn chords() {
    let ctrl = |name, shift| Key {
        name,
        ctrl: true,
        shift,
        alt: false,
    };
    assert_eq!(
        act(ctrl("Enter", false), &state()),
        Some(Action::Solve(SolveAction::Solve))
    );
    assert_eq!(act(ctrl("z", false), &state()), Some(Action::Undo));
    assert_eq!(act(ctrl("Z", true), &state()), Some(Action::Redo));
    assert_eq!(act(ctrl("c", false), &state()), None, "copying stays");
    assert_eq!(act(ctrl("o", false), &state()), None);
}

#[test]
fn without_a_plan_there_is_no_time() {
    for name in [" ", ",", ".", "Home", "End"] {
        assert_eq!(command(key(name), &state()), None, "{name:?}");
    }
}

#[test]
fn escape_takes_one_thing_after_the_other() {
    let mut state = reduce(&state(), Action::Solve(SolveAction::Solve));
    state.view.notice = Some(Notice::refusal(String::new()));
    state.view.selection = Selection::Agent(0);
    for expect in [
        Action::Solve(SolveAction::Cancel),
        Action::View(ViewAction::DismissNotice),
        Action::Board(BoardAction::Select(Selection::Nothing)),
    ] {
        let action = act(key("Escape"), &state);
        assert_eq!(action, Some(expect.clone()));
        state = reduce(&state, expect);
    }
    assert_eq!(command(key("Escape"), &state), None);
}

#[test]
fn escape_lets_a_side_of_the_floor_go_back_then_drops_the_size() {
    let grow = |state: &State, action| reduce(state, Action::Grow(action));
    let open = grow(&state(), GrowAction::Open);
    let held = grow(&open, GrowAction::Hold);
    let held = grow(&held, GrowAction::Drag(Side::Right, 2));
    let back = act(key("Escape"), &held);
    assert_eq!(back, Some(Action::Grow(GrowAction::Abandon)));
    let back = grow(&held, GrowAction::Abandon);
    assert_eq!(back.view.growing, open.view.growing);
    let closed = act(key("Escape"), &back);
    assert_eq!(closed, Some(Action::Grow(GrowAction::Cancel)));
}

#[test]
fn other_keys_are_left_alone() {
    let alt = Key {
        alt: true,
        ..key("o")
    };
    assert_eq!(command(alt, &state()), None);
    for name in ["x", "F5", "Tab", "Dead", ""] {
        assert_eq!(command(key(name), &state()), None, "{name}");
    }
    assert_eq!(command(key("?"), &state()), Some(Command::Help));
}
