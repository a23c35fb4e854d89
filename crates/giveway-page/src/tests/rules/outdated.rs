//! A plan that is older than a rule: it is stale, and red where it breaks the rule.

use super::{act, answered, marked, solved};
use crate::board::{reasons, rules_now};
use crate::reduce::tests::{after, stroke};
use crate::rules::{RuleAction, card, list};
use crate::words::standing;
use crate::{Action, State, Tool};

/// The solved scene with a limit of its aisle, which its plan does not keep.
fn limited() -> State {
    after(&marked(), [act(RuleAction::Add)])
}

#[test]
fn a_plan_that_breaks_a_newer_rule_is_red_on_the_spot() {
    let state = limited();
    assert!(state.document.is_stale());
    let said = standing(&state).sentence;
    let expected = "This plan breaks a rule that came after it: ";
    assert!(said.starts_with(expected), "{said}");
    let rows = list(&state).unwrap().rows;
    assert_eq!(rows[0].broken, None, "the lane was there before");
    let broken = rows[1].broken.as_deref().unwrap();
    assert!(
        broken.starts_with("broken ") && broken.ends_with(" by A1 and A2"),
        "{broken}"
    );
    // The first time at which it is broken is shown, with the zone and the spot in red.
    assert_eq!(rules_now(&state, state.world()).broken, [1]);
    let start = after(&state, [crate::tests::seek(0)]);
    assert!(
        rules_now(&start, start.world()).broken.is_empty(),
        "not at other times"
    );
}

#[test]
fn a_stale_plan_judges_rules_as_long_as_nothing_else_has_changed() {
    let writing = after(&limited(), [act(RuleAction::Edit(1))]);
    let shown = card(&writing).unwrap();
    let title = shown.judged.title;
    assert!(
        title.starts_with("This plan breaks it from 3 to 4"),
        "{title}"
    );
    assert!(!shown.counts.is_empty());
    let edited = after(&limited(), stroke(Tool::Obstacle, &[(6, 0)]));
    let shown = card(&after(&edited, [act(RuleAction::Edit(1))])).unwrap();
    let title = shown.judged.title;
    assert!(
        title.starts_with("The plan on the board is of the scene before"),
        "{title}"
    );
    assert!(shown.counts.is_empty());
}

#[test]
fn a_broken_rule_that_is_priced_tells_both() {
    let priced = answered(&after(&limited(), [act(RuleAction::Price)]));
    let row = list(&priced).unwrap().rows.remove(1);
    let (price, broken) = (row.price.as_ref().unwrap(), row.broken.as_ref().unwrap());
    assert_eq!(price.text, "costs 2 steps of the makespan");
    assert_eq!(
        row.label(),
        format!("{}, {}, {broken}", row.sentence, price.text)
    );
    // Off, it has no price and nothing breaks it.
    let off = after(&priced, [act(RuleAction::Switch(1))]);
    let row = list(&off).unwrap().rows.remove(1);
    assert_eq!(row.label(), row.sentence);
}

#[test]
fn what_is_kept_is_not_red() {
    let state = limited();
    let anew = solved(&state);
    assert!(!anew.document.is_stale());
    assert_eq!(list(&anew).unwrap().rows[1].broken, None);
    let back = after(&state, [Action::Undo]);
    assert!(reasons(&back).bursts.is_empty() && rules_now(&back, back.world()).broken.is_empty());
    // Off, it forbids nothing.
    let off = after(&state, [act(RuleAction::Switch(1))]);
    assert_eq!(list(&off).unwrap().rows[1].broken, None);
}
