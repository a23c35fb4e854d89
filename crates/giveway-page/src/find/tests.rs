//! Finding, choosing, taking: by a part of a name.

use giveway_model::{Agent, Cell, Scene};

use super::*;
use crate::{Action, Draft, Edit, Selection, reduce};

/// Twelve robots in a row, each to the cell below.
fn state() -> State {
    let agent = |n: u32| Agent {
        name: format!("R{n}"),
        start: Cell::new(n - 1, 0),
        goal: Some(Cell::new(n - 1, 1)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    let scene = Scene {
        map: vec![".".repeat(12), ".".repeat(12)],
        agents: (1..=12).map(agent).collect(),
        ..Scene::default()
    };
    act(&State::new(Draft::new(scene).unwrap()), FindAction::Open)
}

fn act(state: &State, action: FindAction) -> State {
    reduce(state, Action::Find(action))
}

fn typed(text: &str) -> State {
    act(&state(), FindAction::Type(text.to_owned()))
}

fn names(state: &State) -> Vec<String> {
    let found = found(state).unwrap();
    found.matches.into_iter().map(|one| one.name).collect()
}

#[test]
fn the_best_fit_comes_first() {
    assert_eq!(names(&typed("1")), ["R1", "R10", "R11", "R12"]);
    assert_eq!(names(&typed(" r1 ")), ["R1", "R10", "R11", "R12"]);
    assert_eq!(names(&typed("2")), ["R2", "R12"]);
    let exact = reduce(&state(), Action::Edit(Edit::Rename(0, "2".to_owned())));
    let exact = act(&exact, FindAction::Type("2".to_owned()));
    assert_eq!(names(&exact), ["2", "R2", "R12"]);
}

#[test]
fn so_many_are_told_and_some_are_listed() {
    let sentence = |text: &str| found(&typed(text)).unwrap().sentence;
    assert_eq!(names(&typed("")).len(), MOST);
    assert_eq!(sentence(""), "Type a part of a name.");
    assert_eq!(sentence("r"), "12 robots fit, the first 8 are listed.");
    assert_eq!(sentence("12"), "1 robot fits.");
    assert_eq!(sentence("x"), "No robot has \u{201c}x\u{201d} in its name.");
    assert_eq!(found(&typed("12")).unwrap().matches[0].place, "at (11, 0)");
}

#[test]
fn the_choice_goes_round() {
    let up = FindAction::Step { down: false };
    let down = FindAction::Step { down: true };
    let state = act(&typed("2"), up);
    let chosen = |state: &State| {
        let found = found(state).unwrap();
        found.matches.iter().position(|one| one.is_chosen)
    };
    assert_eq!(chosen(&state), Some(1));
    let state = act(&state, down.clone());
    assert_eq!(chosen(&state), Some(0));
    // With another text the first is chosen again; without a robot there is nothing.
    let state = act(&act(&state, down.clone()), FindAction::Type("1".to_owned()));
    assert_eq!(chosen(&state), Some(0));
    let none = act(&typed("x"), down);
    assert_eq!(act(&none, FindAction::Take(None)), none);
}

#[test]
fn a_robot_is_selected_and_brought_into_view() {
    let taken = act(&typed("1"), FindAction::Take(Some(2)));
    assert_eq!(taken.view.selection, Selection::Agent(10));
    assert_eq!(taken.view.find, None);
    assert_eq!(taken.view.cursor, Cell::new(10, 0));
    let sought = taken.view.sought.unwrap();
    assert_eq!(sought.cell, Cell::new(10, 0));
    // Once more: the same robot comes into view again.
    let again = act(
        &act(&taken, FindAction::Open),
        FindAction::Type("11".to_owned()),
    );
    let again = act(&again, FindAction::Take(None));
    assert_eq!(again.view.sought.unwrap().cell, sought.cell);
    assert_ne!(again.view.sought, taken.view.sought);
}

#[test]
fn without_robots_there_is_none_to_find() {
    let state = act(&State::new(Draft::default()), FindAction::Open);
    assert_eq!(found(&state), None);
    let closed = act(&typed("1"), FindAction::Close);
    assert_eq!(found(&closed), None);
}
