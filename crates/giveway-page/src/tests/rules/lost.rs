//! What a person is told at once: of rules that no plan can keep, and of rules that go with a
//! robot.

use giveway_model::condition::Times;

use super::{act, fresh, marked, solved};
use crate::reduce::tests::{after, stroke};
use crate::rules::{RuleAction, Ruling, Value, card};
use crate::words::standing;
use crate::{Action, Edit, Tool};

#[test]
fn a_goal_in_a_zone_that_is_closed_for_ever_is_said_at_once() {
    // (3, 4) is the goal of A2, (0, 0) the start of A1.
    let state = after(&fresh(), stroke(Tool::Zone, &[(3, 4)]));
    let closed = card(&state).unwrap().offers[0].rule.clone();
    let write = |rule| after(&state, [act(RuleAction::Write(rule))]);
    let shown = card(&write(closed.clone())).unwrap().judged;
    assert_eq!(shown.ruling, Ruling::Never);
    assert_eq!(
        shown.details,
        ["A2 has its goal in zone 1, so no plan can keep this rule."]
    );
    // The others can: that is one press away.
    let offer = card(&write(closed.clone())).unwrap().offers[0].clone();
    assert_eq!(offer.sentence, "The same for all robots but A2");
    let robots = ["A1", "A3"].map(str::to_owned);
    assert_eq!(offer.rule.agents.as_deref(), Some(&robots[..]));
    let some = card(&write(offer.rule)).unwrap();
    assert_ne!(some.judged.ruling, Ruling::Never);
    assert_ne!(some.offers[0].sentence, offer.sentence);
    // Closed for a while, it can be kept.
    let until = Value::When(Times {
        from: None,
        to: Some(3),
    });
    let state = after(&write(closed.clone()), [act(RuleAction::Fill(until))]);
    assert_ne!(card(&state).unwrap().judged.ruling, Ruling::Never);
    // Of another robot, too.
    let other = Value::Who(Some(vec!["A1".into()]));
    let state = after(&write(closed), [act(RuleAction::Fill(other))]);
    assert_ne!(card(&state).unwrap().judged.ruling, Ruling::Never);
}

#[test]
fn starts_count_only_from_the_first_time_on() {
    let state = after(&fresh(), stroke(Tool::Zone, &[(0, 0), (1, 0)]));
    let shown = card(&state).unwrap().judged;
    assert_eq!(
        shown.details,
        ["A1 and A2 start in zone 1, so no plan can keep this rule."]
    );
    let offer = card(&state).unwrap().offers[0].sentence.clone();
    assert_eq!(offer, "The same for all robots but A1 and A2");
    let later = Value::When(Times {
        from: Some(4),
        to: None,
    });
    let state = after(&state, [act(RuleAction::Fill(later))]);
    assert_ne!(card(&state).unwrap().judged.ruling, Ruling::Never);
    let two = after(&marked(), [act(RuleAction::Fill(Value::Number(0, 2)))]);
    assert_eq!(card(&two).unwrap().judged.ruling, Ruling::Keeps);
}

#[test]
fn a_rule_that_goes_with_a_robot_is_told_and_comes_back() {
    let who = act(RuleAction::Fill(Value::Who(Some(vec!["A2".into()]))));
    let state = after(&marked(), [who, act(RuleAction::Add)]);
    let gone = after(&state, [Action::Edit(Edit::RemoveAgent(1))]);
    assert_eq!(gone.document.draft.scene().constraints.len(), 1);
    let notice = gone.view.notice.clone().unwrap();
    assert_eq!(
        notice.sentence(),
        "1 rule went with it. Undo brings it back."
    );
    assert_eq!(notice.details(), ["At most 1 of A2 in 'zone 1'"]);
    let back = after(&gone, [Action::Undo]);
    assert_eq!(back.document.draft.scene().constraints.len(), 2);
    assert_eq!(back.document.draft.agents().len(), 3);
    // A robot whom no rule names takes none along, and what is removed on purpose is not told.
    let other = after(&state, [Action::Edit(Edit::RemoveAgent(2))]);
    assert_eq!(other.view.notice, None);
    let removed = after(&state, [act(RuleAction::Remove(0))]);
    assert_eq!(removed.view.notice, None);
}

#[test]
fn the_status_says_how_many_rules_are_in_force() {
    let state = solved(&fresh());
    let said = standing(&state);
    assert_eq!(said.rules.as_deref(), Some("1 rule"));
    assert!(
        said.sentence.ends_with("sum of costs 21, 0 charges."),
        "{said:?}"
    );
    let off = after(&state, [act(RuleAction::Switch(0))]);
    assert_eq!(standing(&off).rules, None);
}
