//! Rules that are added and removed while a plan runs.

use giveway_model::change::What;

use super::{act, marked, solved};
use crate::reduce::tests::after;
use crate::rules::{RuleAction, Ruling, Value, card};
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
    // The scene has the limit of one robot already.
    let begun = after(&at_two(), [act(RuleAction::Begin)]);
    assert_eq!(card(&begun).unwrap().judged.ruling, Ruling::InForce);
    let refused = after(&begun, [act(RuleAction::Add)]);
    assert!(list(&refused).is_empty() && refused.view.notice.is_some());
    let two = act(RuleAction::Fill(Value::Number(0, 2)));
    let state = after(&begun, [two]);
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

/// A rule that is removed from now on is no longer in force: it can be added again.
#[test]
fn a_rule_that_is_removed_can_be_added_again() {
    let gone = after(&at_two(), [Action::Edit(Edit::Rules(RuleEdit::Remove(1)))]);
    let begun = after(&gone, [act(RuleAction::Begin)]);
    assert_eq!(card(&begun).unwrap().judged.ruling, Ruling::Open);
}

/// What is in a zone when its rule is added does not count there, and that is said; who would break
/// it otherwise is told, and once a plan is used the list of rules has it.
#[test]
fn a_rule_from_a_time_on_tells_who_does_not_count_and_stays_in_the_list() {
    let solved = solved(&marked());
    let answer = solved.document.plan().unwrap();
    let inside = |time: u32| {
        let aisle = super::AISLE.map(|(x, y)| giveway_model::Cell::new(x, y));
        let at = |name: &str| answer.paths[name].get(time as usize).copied().flatten();
        let names = ["A1", "A2", "A3"];
        let is_in = |name: &&str| at(name).is_some_and(|cell| aisle.contains(&cell));
        names.iter().filter(|name| is_in(name)).count()
    };
    let time = (1..20).find(|&time| inside(time) == 1 && inside(time + 1) == 2);
    let time = time.expect("two robots follow each other through the aisle");
    let seek = Action::Play(PlayAction::Seek(time));
    let begun = after(
        &solved,
        [
            seek,
            Action::Change(ChangeAction::Begin),
            act(RuleAction::Begin),
        ],
    );
    let shown = card(&begun).unwrap();
    let said = shown.judged.details.join(" ");
    assert!(
        said.ends_with("is in zone 1 then, and not counted until it has left."),
        "{said}"
    );
    let none = act(RuleAction::Fill(Value::Number(0, 0)));
    let added = after(&begun, [none, act(RuleAction::Add)]);
    let meets = changing::facts(&added).unwrap().meets;
    assert!(
        meets
            .iter()
            .any(|it| it.contains("would break the new rule at")),
        "{meets:?}"
    );
    let found = answered(&after(&added, [Action::Change(ChangeAction::Adapt)]));
    let last = found.document.mode.comparing().unwrap().tried.len() - 1;
    let used = after(&found, [Action::Change(ChangeAction::Adopt(last))]);
    let changed = crate::rules::list(&used).unwrap().changed;
    assert_eq!(
        changed,
        [format!("From time {time} on: At most 0 robots in 'zone 1'")]
    );
}
