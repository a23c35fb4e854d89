//! Finding by a part of a name: the first, the next, the one before.

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

/// The robot that is selected, and which of how many it is.
fn told(state: &State) -> (String, String) {
    let found = found(state).unwrap();
    let name = |agent: usize| state.world().agents()[agent].name.clone();
    if let Some(agent) = found.agent {
        assert_eq!(state.view.selection, Selection::Agent(agent));
    }
    (found.agent.map_or_else(String::new, name), found.place)
}

fn is(name: &str, place: &str) -> (String, String) {
    (name.to_owned(), place.to_owned())
}

#[test]
fn typing_selects_the_best_fit() {
    assert_eq!(told(&typed("1")), is("R1", "1 of 4"));
    assert_eq!(told(&typed(" r1 ")), is("R1", "1 of 4"));
    assert_eq!(told(&typed("2")), is("R2", "1 of 2"));
    assert_eq!(told(&typed("12")), is("R12", "1 of 1"));
    let exact = reduce(&state(), Action::Edit(Edit::Rename(0, "2".to_owned())));
    let exact = act(&exact, FindAction::Type("2".to_owned()));
    assert_eq!(told(&exact).1, "1 of 3");
    assert_eq!(told(&exact).0, "2");
}

#[test]
fn where_nothing_fits_the_selection_stays() {
    let before = typed("12");
    let none = act(&before, FindAction::Type("x".to_owned()));
    assert_eq!(told(&none), is("", "none"));
    assert_eq!(none.view.selection, before.view.selection);
    let empty = act(&before, FindAction::Type(" ".to_owned()));
    assert_eq!(told(&empty), is("", ""));
    let on = FindAction::Step { on: true };
    assert_eq!(act(&none, on).view.selection, before.view.selection);
}

#[test]
fn enter_goes_round() {
    let on = || FindAction::Step { on: true };
    let state = act(&typed("2"), on());
    assert_eq!(told(&state), is("R12", "2 of 2"));
    assert_eq!(told(&act(&state, on())), is("R2", "1 of 2"));
    let before = act(&typed("2"), FindAction::Step { on: false });
    assert_eq!(told(&before), is("R12", "2 of 2"));
    // With another text the first is selected again.
    let other = act(&state, FindAction::Type("1".to_owned()));
    assert_eq!(told(&other).1, "1 of 4");
}

#[test]
fn a_robot_is_selected_and_brought_into_view() {
    let found = typed("11");
    assert_eq!(found.view.selection, Selection::Agent(10));
    assert_eq!(found.view.cursor, Cell::new(10, 0));
    let sought = found.view.sought.unwrap();
    assert_eq!(sought.cell, Cell::new(10, 0));
    // Once more: the same robot comes into view again.
    let again = act(&found, FindAction::Step { on: true });
    assert_eq!(again.view.sought.unwrap().cell, sought.cell);
    assert_ne!(again.view.sought, found.view.sought);
    let closed = act(&again, FindAction::Close);
    assert_eq!(
        (closed.view.find, closed.view.selection),
        (None, Selection::Agent(10))
    );
}

#[test]
fn without_robots_there_is_none_to_find() {
    let state = act(&State::new(Draft::default()), FindAction::Open);
    assert_eq!(found(&state), None);
}
