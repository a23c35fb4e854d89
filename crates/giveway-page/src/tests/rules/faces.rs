//! Where a robot faces at its start, under a rule about turns: seen, turned, undone.

use giveway_model::constraint::{ConstraintKind, Heading};

use super::{act, fresh, solved};
use crate::board::{Cast, nose};
use crate::reduce::tests::after;
use crate::rules::{RuleAction, card};
use crate::tests::{seek, select};
use crate::{Action, Edit, State, link};

/// The scene with a rule about turns, and A1 selected.
fn turning() -> State {
    let begun = after(&fresh(), [act(RuleAction::Begin)]);
    let offers = card(&begun).unwrap().offers;
    let is_turns = |kind: &ConstraintKind| matches!(kind, ConstraintKind::Turns { .. });
    let turns = offers
        .into_iter()
        .find(|offer| is_turns(&offer.rule.kind))
        .unwrap();
    after(
        &begun,
        [
            act(RuleAction::Write(turns.rule)),
            act(RuleAction::Add),
            select(0),
        ],
    )
}

fn faces(state: &State, time: f64) -> Option<f64> {
    Cast::of(state).tracks[0].pose(time).unwrap().heading
}

#[test]
fn a_nose_is_there_where_turns_take_time() {
    assert_eq!(nose(&after(&fresh(), [select(0)])), None, "turns are free");
    let state = turning();
    assert_eq!(nose(&state).unwrap().heading, None);
    assert_eq!(faces(&state, 0.0), None, "nobody said where it faces");
    let turned = after(&state, [Action::Edit(Edit::Face(0, Some(Heading::North)))]);
    assert_eq!(nose(&turned).unwrap().heading, Some(Heading::North));
    assert_eq!(faces(&turned, 0.0), Some(270.0), "without a plan, too");
    let undone = after(&turned, [Action::Undo]);
    assert_eq!(nose(&undone).unwrap().heading, None);
    let open = after(&turned, [Action::Edit(Edit::Face(0, None))]);
    assert_eq!(open.document.draft, state.document.draft);
}

#[test]
fn the_plan_turns_as_the_rule_asks() {
    // A1 starts at the left edge and faces north; its first move leads east.
    let state = after(
        &turning(),
        [Action::Edit(Edit::Face(0, Some(Heading::North)))],
    );
    let solved = solved(&state);
    let path = solved.plan().unwrap().path("A1").to_vec();
    assert_eq!(path[0], path[1], "it has to turn first");
    let there = after(&solved, [seek(0), select(0)]);
    assert!(nose(&there).is_some());
    assert_eq!(faces(&there, 0.0), Some(270.0));
    let track = &Cast::of(&there).tracks[0];
    let arrival = f64::from(track.arrival());
    assert!(
        track.pose(arrival).unwrap().heading.is_some(),
        "it faces somewhere at its goal"
    );
    assert_eq!(
        nose(&after(&there, [seek(1)])),
        None,
        "it is turned at its start"
    );
}

#[test]
fn where_it_faces_is_kept() {
    let state = after(
        &turning(),
        [Action::Edit(Edit::Face(0, Some(Heading::South)))],
    );
    let again = link::kept(&link::keep(&state)).unwrap();
    assert_eq!(again.document.draft, state.document.draft);
}
