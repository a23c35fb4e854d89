//! A robot breaks down for some steps or for good, and one that joins has a battery.

use giveway_model::change::What;
use giveway_model::{Battery, Cell};

use super::{changing, joined, list, running};
use crate::changing::{broken_down_for_good, facts, history, offers};
use crate::find::{self, FindAction};
use crate::inspect::{self, whole};
use crate::reduce::tests::{after, stroke};
use crate::tests::{answered, saying, seek};
use crate::timeline::{Axis, Lane, Row, Shapes};
use crate::{Action, ChangeAction, Edit, Phase, Selection, State, Tool};

/// The cell of A1 at time 1.
fn place(state: &State) -> Cell {
    crate::board::place_of(state, 0).unwrap()
}

#[test]
fn one_button_lets_a_robot_break_down_here() {
    let state = after(&running(), [Action::Change(ChangeAction::BreakDown(0))]);
    assert_eq!(state.phase(), Phase::Changing);
    assert_eq!(list(&state), ["A1 breaks down for 10 steps"]);
    assert_eq!(state.view.selection, Selection::Agent(0));
    assert_eq!(offers(&state, 0).unwrap().delay, Some(10));
    let longer = after(&state, [Action::Edit(Edit::Delay(0, 3))]);
    assert_eq!(list(&longer), ["A1 breaks down for 3 steps"]);
}

#[test]
fn for_good_it_stays_as_an_obstacle_with_its_name() {
    let before = running();
    let cell = place(&before);
    let state = after(
        &before,
        [
            Action::Change(ChangeAction::BreakDown(0)),
            Action::Edit(Edit::Stop(0)),
        ],
    );
    assert_eq!(list(&state), [format!("A1 breaks down for good at {cell}")]);
    let said = "The world changes at time 1: 1 change listed.";
    assert_eq!(saying(&state), said, "the obstacle is no change of its own");
    assert!(!state.world().grid().is_vertex(cell));
    assert!(!state.is_there(0));
    let named = broken_down_for_good(&state);
    assert_eq!(
        (named.len(), named[0].name.as_str(), named[0].cell),
        (1, "A1", cell)
    );
    assert!(broken_down_for_good(&after(&state, [seek(0)])).is_empty());
    // Both changes are taken back as one.
    let index = facts(&state).unwrap().list[0].index;
    let back = after(&state, [Action::Change(ChangeAction::TakeBack(index))]);
    assert!(list(&back).is_empty() && back.world().grid().is_vertex(cell));
    // It stays there in the plan that goes on.
    let found = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    let adopted = after(&found, [Action::Change(ChangeAction::Adopt(2)), seek(2)]);
    assert_eq!(adopted.phase(), Phase::Planned);
    assert_eq!(broken_down_for_good(&adopted), named);
    let again = crate::link::kept(&crate::link::keep(&adopted)).unwrap();
    assert_eq!(broken_down_for_good(&after(&again, [seek(2)])), named);
    let answer = adopted.shown().unwrap();
    let past = history(answer);
    let said = format!("A1 breaks down for good at {cell}");
    assert_eq!(past.last().unwrap().text, said);
    let lane = Lane::of(answer, 0).unwrap();
    assert_eq!(lane.stopped, Some((1, cell)));
    let sentence = lane.sentence();
    assert!(
        sentence.ends_with(&format!("{} at 1", said.replace("A1 ", ""))),
        "{sentence}"
    );
    let axis = Axis::fit(answer.makespan(), 600.0, 0.0);
    let shapes = Shapes::of(&lane, axis, Row::BARE, &(0..9));
    assert!(!shapes.crosses.is_empty() && !shapes.moves.is_empty());
    assert!(broken_down_for_good(&after(&adopted, [seek(0)])).is_empty());
}

#[test]
fn for_good_it_is_still_counted_and_found() {
    let broken = [
        Action::Change(ChangeAction::BreakDown(0)),
        Action::Edit(Edit::Stop(0)),
    ];
    let state = after(&running(), broken);
    let cell = broken_down_for_good(&state)[0].cell;
    let told = whole(&state).contents;
    assert!(told.contains(", 1 broken down for good,"), "{told}");
    let looking = [FindAction::Open, FindAction::Type("A1".to_owned())];
    let state = after(&state, looking.map(Action::Find));
    let place = find::found(&state).unwrap().place;
    assert!(place.ends_with(", broken down for good"), "{place}");
    assert_eq!(state.view.selection, Selection::Cell(cell));
    let roles = inspect::cell(&state, cell).unwrap().roles;
    assert!(roles.contains(&(0, "A1, broken down for good".to_owned())));
}

#[test]
fn what_was_told_of_a_change_goes_with_it() {
    let begun = after(&running(), [Action::Change(ChangeAction::Begin)]);
    let again = after(&begun, [Action::Undo, Action::Redo]);
    let told = |state: &State| state.view.notice.as_ref().map(crate::Notice::sentence);
    assert_eq!(told(&again).unwrap(), "The world changes again at time 1.");
    let left = after(&again, [Action::Change(ChangeAction::Discard)]);
    assert_eq!(told(&left), None);
}

#[test]
fn who_would_run_into_a_change_is_told_while_it_is_made() {
    assert!(facts(&changing()).unwrap().meets.is_empty());
    let state = after(&changing(), stroke(Tool::Obstacle, &[(2, 0)]));
    let told = facts(&state).unwrap().meets;
    assert_eq!(told.len(), 1);
    assert!(
        told[0].starts_with("A1 would run into (2, 0) at "),
        "{told:?}"
    );
    let free = after(&changing(), stroke(Tool::Obstacle, &[(0, 2)]));
    let told = facts(&free).unwrap().meets;
    let plan = free
        .document
        .mode
        .changing()
        .unwrap()
        .about
        .plan()
        .unwrap()
        .clone();
    let passes = plan
        .paths
        .values()
        .any(|path| path[1..].contains(&Some(Cell::new(0, 2))));
    assert_eq!(told.is_empty(), !passes, "{told:?}");
}

#[test]
fn one_that_joins_has_a_battery() {
    let state = joined();
    let battery = Some(Battery {
        capacity: 20,
        initial: 12,
    });
    assert_eq!(offers(&state, 2).unwrap().battery, Some(None));
    assert_eq!(offers(&state, 0).unwrap().battery, None);
    let state = after(&state, [Action::Edit(Edit::SetBattery(2, battery))]);
    let changing = state.document.mode.changing().unwrap();
    assert!(matches!(&changing.list[..], [What::AddAgent { agent }] if agent.battery == battery));
    assert_eq!(offers(&state, 2).unwrap().battery, Some(battery));
    let none = after(&state, [Action::Edit(Edit::SetBattery(2, None))]);
    assert_eq!(offers(&none, 2).unwrap().battery, Some(None));
}
