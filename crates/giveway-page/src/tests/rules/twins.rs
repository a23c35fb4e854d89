//! A rule that is in force already is not added again, nor asked about: that is said.

use super::{act, marked};
use crate::reduce::tests::after;
use crate::rules::{Lit, RuleAction, Ruling, card};
use crate::{Notice, State};

fn told(state: &State) -> String {
    state
        .view
        .notice
        .as_ref()
        .map(Notice::sentence)
        .unwrap_or_default()
}

/// The solved scene with a limit of its aisle, and the same limit written again.
fn written_twice() -> State {
    let once = after(&marked(), [act(RuleAction::Add)]);
    let zone = once.document.draft.scene().zones[0].name.clone();
    after(&once, [act(RuleAction::OfZone(zone))])
}

#[test]
fn a_rule_in_force_is_not_added_again() {
    let state = written_twice();
    assert_eq!(card(&state).unwrap().judged.ruling, Ruling::InForce);
    let added = after(&state, [act(RuleAction::Add)]);
    assert_eq!(added.document.draft, state.document.draft);
    assert_eq!(
        told(&added),
        "This rule is in force already: At most 1 robot in 'zone 1'."
    );
    assert_eq!(added.lit_rule(), Some(&Lit::Rule(1)), "it is shown");
    // Another one is.
    let more = act(RuleAction::Fill(crate::rules::Value::Number(0, 2)));
    let other = after(&state, [more, act(RuleAction::Add)]);
    assert_eq!(other.document.draft.scene().constraints.len(), 3);
    // One that is off forbids nothing: it can be added.
    let off = after(&state, [act(RuleAction::Switch(1)), act(RuleAction::Add)]);
    assert_eq!(off.document.draft.scene().constraints.len(), 3);
}

#[test]
fn nothing_is_asked_about_a_rule_in_force() {
    let state = written_twice();
    let asked = after(&state, [act(RuleAction::Ask)]);
    assert_eq!(asked.document.mode.asking(), None);
    assert!(told(&asked).starts_with("This rule is in force already"));
}
