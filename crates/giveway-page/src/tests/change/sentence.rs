//! The sentence of a breakdown: its slots are filled in place, and what it leads to is told.

use giveway_model::Scene;

use super::{list, running};
use crate::changing::{Blank, Breakdown, Filled, Piece, facts};
use crate::reduce::tests::after;
use crate::tests::{answered, seek};
use crate::{Action, ChangeAction, Draft, Selection, SolveAction, State};

fn broken() -> State {
    after(&running(), [Action::Change(ChangeAction::BreakDown(0))])
}

fn fill(state: &State, filled: Filled) -> State {
    after(state, [Action::Change(ChangeAction::Fill(0, filled))])
}

fn card(state: &State) -> Breakdown {
    let mut cards = facts(state).unwrap().breakdowns;
    assert_eq!(cards.len(), 1, "{cards:?}");
    cards.remove(0)
}

fn said(card: &Breakdown) -> String {
    let words = card.pieces.iter().map(|piece| match piece {
        Piece::Words(words) => words.clone(),
        Piece::Slot(_, text) => format!("[{text}]"),
    });
    words.collect()
}

#[test]
fn a_slot_changes_the_breakdown_that_is_listed() {
    let state = broken();
    let own = card(&state);
    let cell = crate::board::place_of(&state, 0).unwrap();
    assert_eq!(
        said(&own),
        format!("[A1] breaks down at [1] at {cell} for [10 steps].")
    );
    let slots: Vec<Blank> = own
        .pieces
        .iter()
        .filter_map(|piece| match piece {
            Piece::Slot(blank, _) => Some(*blank),
            Piece::Words(_) => None,
        })
        .collect();
    assert_eq!(slots, [Blank::Robot, Blank::Time, Blank::Steps]);
    let one = fill(&state, Filled::Steps(Some(1)));
    assert_eq!(list(&one), ["A1 breaks down for 1 step"]);
    let later = fill(&one, Filled::Time(2));
    assert_eq!((card(&later).time.0, later.view.playback.time), (2, 2));
    assert_eq!(list(&later), ["A1 breaks down for 1 step"]);
    let other = fill(&later, Filled::Robot(1));
    assert_eq!(list(&other), ["A2 breaks down for 1 step"]);
    assert_eq!(
        other.view.selection,
        Selection::Agent(1),
        "the card goes along"
    );
    let stopped = fill(&other, Filled::Steps(None));
    let told = card(&stopped);
    assert!(said(&told).ends_with("[for good]."), "{}", said(&told));
    assert_eq!(stopped.view.selection, Selection::Nothing);
    let back = fill(&stopped, Filled::Steps(Some(4)));
    assert_eq!(list(&back), ["A2 breaks down for 4 steps"]);
    // Each is a step of undo.
    let undone = after(&back, [Action::Undo, Action::Undo, Action::Undo]);
    assert_eq!(list(&undone), list(&later));
}

#[test]
fn what_cannot_be_is_refused_and_the_rest_stays() {
    let state = broken();
    // No time is later than the end of the plan.
    let late = fill(&state, Filled::Time(u32::MAX));
    assert_eq!(card(&state).time.1, (0, 4));
    assert_eq!(card(&late).time.0, 4);
    let nobody = fill(&state, Filled::Robot(99));
    assert_eq!(nobody.document, state.document);
    let none = after(
        &state,
        [Action::Change(ChangeAction::Fill(7, Filled::Steps(None)))],
    );
    assert_eq!(none.document, state.document);
    let most = fill(&state, Filled::Steps(Some(u32::MAX)));
    assert_eq!(list(&most), ["A1 breaks down for 10000 steps"]);
}

/// A corridor, solved, at time 1, when its first robot breaks down.
fn corridor(map: &str, agents: &str, steps: Option<u32>) -> Breakdown {
    let scene: Scene = serde_json::from_str(&format!(
        r#"{{ "giveway": 1, "map": ["{map}"], "agents": [{agents}] }}"#
    ))
    .unwrap();
    let state = State::new(Draft::new(scene).unwrap());
    let state = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    let at = after(
        &state,
        [seek(1), Action::Change(ChangeAction::BreakDown(0))],
    );
    card(&fill(&at, Filled::Steps(steps)))
}

#[test]
fn whether_its_battery_lasts_is_told() {
    let with = |capacity: u32, initial: u32| {
        format!(
            r#"{{ "name": "A1", "start": [0, 0], "goal": [4, 0],
                "battery": {{ "capacity": {capacity}, "initial": {initial} }} }}"#
        )
    };
    // Four steps to go, and one more in the battery.
    let told = |steps| corridor(".....", &with(6, 5), Some(steps)).told;
    let good = "The battery of A1 lasts: 0 steps are left where it is lowest.";
    assert_eq!(told(1), [(false, good.to_owned())]);
    let bad = "1 robot could not arrive any more: A1.";
    assert_eq!(told(2), [(true, bad.to_owned())]);
    assert_eq!(told(9), [(true, bad.to_owned())]);
    // On the way there is a charger, at which the plan does not charge.
    let passes = |steps| corridor("..+..", &with(5, 4), Some(steps)).told;
    let charges = "The battery of A1 does not last on its path: it is too low at 5. Another path has to charge it.";
    assert_eq!(passes(2), [(true, charges.to_owned())]);
    assert_eq!(passes(3), [(true, bad.to_owned())]);
    // It stands on the charger.
    let stands = corridor(".+...", &with(5, 5), Some(40)).told;
    assert_eq!(stands.len(), 1);
    assert!(
        !stands[0].0 && stands[0].1.starts_with("The battery of A1 lasts"),
        "{stands:?}"
    );
    let none = corridor(
        ".....",
        r#"{ "name": "A1", "start": [0, 0], "goal": [4, 0] }"#,
        Some(9),
    );
    assert_eq!((none.met, none.told), (None, vec![]));
}

#[test]
fn who_runs_into_it_and_who_cannot_arrive_is_told() {
    let both = r#"{ "name": "A1", "start": [1, 0], "goal": [4, 0] },
                  { "name": "A2", "start": [0, 0], "goal": [3, 0] }"#;
    let some = corridor(".....", both, Some(2));
    let met = "1 robot would run into it: A2 at 2";
    assert_eq!((some.met.as_deref(), &some.told[..]), (Some(met), &[][..]));
    let good = corridor(".....", both, None);
    assert_eq!(good.met.as_deref(), Some(met));
    let told: Vec<&str> = good.told.iter().map(|(_, text)| text.as_str()).collect();
    assert_eq!(
        told,
        [
            "A1 does not arrive: it stays there as an obstacle.",
            "1 robot could not arrive any more: A2."
        ]
    );
}
