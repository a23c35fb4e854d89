//! Rules that are added and removed while a plan runs.

use giveway_model::change::What;

use super::{act, marked, solved};
use crate::reduce::tests::after;
use crate::rules::{RuleAction, Ruling, card};
use crate::tests::answered;
use crate::{Action, ChangeAction, Edit, PlayAction, RuleEdit, State, changing};

/// The world changes at 2.
fn at_two() -> State {
    let solved = solved(&after(&marked(), [act(RuleAction::Add)]));
    let seek = Action::Play(PlayAction::Seek(2));
    after(&solved, [seek, Action::Change(ChangeAction::Begin)])
}

fn list(state: &State) -> &[What] {
    &state.document.mode.changing().unwrap().list
}

#[test]
fn a_rule_is_removed_at_a_time_and_taken_back() {
    let state = at_two();
    let facts = changing::facts(&state).unwrap();
    let rules: Vec<usize> = facts.rules.iter().map(|rule| rule.0).collect();
    assert_eq!(rules, [0, 1]);
    let gone = after(&state, [Action::Edit(Edit::Rules(RuleEdit::Remove(1)))]);
    let facts = changing::facts(&gone).unwrap();
    assert_eq!(facts.rules.len(), 1);
    assert_eq!(facts.list[0].text, "Rule removed");
    assert_eq!(
        facts.list[0].detail.as_deref(),
        Some("At most 1 robot in 'zone 1'")
    );
    let back = after(&gone, [Action::Change(ChangeAction::TakeBack(0))]);
    assert_eq!(changing::facts(&back).unwrap().rules.len(), 2);
    // The methods go on without it.
    let found = answered(&after(&gone, [Action::Change(ChangeAction::Adapt)]));
    assert!(found.document.mode.comparing().is_some());
}

#[test]
fn a_rule_is_added_from_a_time_on() {
    let state = after(&at_two(), [act(RuleAction::Begin)]);
    let shown = card(&state).unwrap();
    assert_eq!((shown.icon, shown.marks), ("capacity", false));
    assert_eq!(shown.judged.ruling, Ruling::Open);
    assert_eq!(shown.judged.title, "It holds from time 2 on");
    let added = after(&state, [act(RuleAction::Add)]);
    assert!(card(&added).is_none());
    assert!(
        matches!(list(&added), [What::AddConstraint { .. }]),
        "{:?}",
        list(&added)
    );
    assert_eq!(
        added.document.draft.scene().constraints.len(),
        2,
        "the scene stays"
    );
    let undone = after(&added, [Action::Undo]);
    assert!(list(&undone).is_empty());
}
