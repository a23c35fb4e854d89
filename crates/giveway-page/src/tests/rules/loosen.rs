//! A rule is loosened by the least that changes something.

use giveway_model::Question;
use giveway_solve::Request;

use super::{act, fresh, marked, solved};
use crate::reduce::tests::{after, stroke};
use crate::rules::{LooserPart, RuleAction, list};
use crate::tests::answered;
use crate::{Action, AskAction, Phase, State, Tool};

/// At most one robot in the aisle, solved.
fn ruled() -> State {
    solved(&after(&marked(), [act(RuleAction::Add)]))
}

fn part(state: &State, rule: usize) -> Option<LooserPart> {
    list(state).unwrap().rows[rule].looser.clone()
}

#[test]
fn the_least_that_helps_is_found_shown_and_taken() {
    let state = ruled();
    let rows = list(&state).unwrap().rows;
    assert_eq!([rows[0].can_loosen, rows[1].can_loosen], [false, true]);
    assert!(rows[1].looser.is_none(), "nobody asked");
    let asking = after(&state, [act(RuleAction::Loosen(1))]);
    let Some((_, Request::Price(request))) = asking.work.request() else {
        panic!("{:?}", asking.work)
    };
    assert_eq!(request.loosen, Some(1));
    assert!(!asking.is_pricing(), "the others keep their prices");
    let shown = list(&asking).unwrap();
    assert!(shown.rows[1].is_open && shown.rows[1].is_lit);
    assert!(part(&asking, 1).unwrap().is_looking);
    let told = answered(&asking);
    let found = part(&told, 1).unwrap();
    assert!(!found.is_looking && found.nothing.is_none(), "{found:?}");
    let [row] = found.looser.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(row.sentence, "At most 2 robots in zone 1");
    assert!(
        row.costs.starts_with("makespan 8, sum of costs 21"),
        "{row:?}"
    );
    assert_eq!(row.saves.as_deref(), Some("\u{2212}2 in the makespan"));
    assert!(row.is_proved && row.open.is_none());
    let taken = after(&told, [act(RuleAction::TakeLooser(0))]);
    let rule = &taken.document.draft.scene().constraints[1];
    assert_eq!(rule.sentence(), "At most 2 robots in 'zone 1'");
    let plan = taken.document.fresh_answer().unwrap();
    assert_eq!(plan.solved.costs.unwrap().makespan, 8, "its plan is there");
    assert!(taken.work.solving().is_some(), "and is proved again");
    let proved = answered(&taken);
    let costs = proved.document.fresh_answer().unwrap().solved.costs;
    assert_eq!(costs.unwrap().makespan, 8);
    assert!(part(&proved, 1).is_none(), "it was about the rule before");
    let undone = after(&taken, [Action::Undo]);
    assert_eq!(undone.document.draft, told.document.draft, "one step");
    assert!(part(&undone, 1).is_some());
}

#[test]
fn it_is_stopped_by_the_same_button_and_by_an_edit() {
    let asking = after(&ruled(), [act(RuleAction::Loosen(1))]);
    let stopped = after(&asking, [act(RuleAction::Loosen(1))]);
    assert!(stopped.work.is_idle());
    assert_eq!(part(&stopped, 1), None);
    let edited = after(&asking, stroke(Tool::Obstacle, &[(6, 0)]));
    assert!(edited.work.is_idle());
    let off = after(
        &ruled(),
        [act(RuleAction::Switch(1)), act(RuleAction::Loosen(1))],
    );
    assert!(!list(&off).unwrap().rows[1].can_loosen, "it is off");
    assert_eq!(part(&off, 1), None);
}

#[test]
fn that_no_looser_form_helps_is_an_answer() {
    let mut scene = super::scene();
    let gap = r#"{ "kind": "arrive", "by": 30 }"#;
    scene.constraints.push(serde_json::from_str(gap).unwrap());
    let state = State::new(crate::Draft::new(scene).unwrap());
    let told = answered(&after(&solved(&state), [act(RuleAction::Loosen(1))]));
    let found = part(&told, 1).unwrap();
    assert!(found.looser.is_empty());
    assert_eq!(
        found.nothing,
        Some("No looser form of this rule changes the costs.")
    );
    assert_eq!(told, after(&told, [act(RuleAction::TakeLooser(0))]));
}

#[test]
fn without_a_plan_the_least_is_found_that_leaves_one() {
    let mut scene = super::scene();
    let by = r#"{ "kind": "arrive", "by": 5 }"#;
    scene.constraints.push(serde_json::from_str(by).unwrap());
    let state = solved(&State::new(crate::Draft::new(scene).unwrap()));
    assert_eq!(state.phase(), Phase::None);
    let why = answered(&after(
        &state,
        [Action::Ask(AskAction::Ask(Question::Unsolvable))],
    ));
    let facts = crate::ask::card(&why).unwrap().cores[0].facts.clone();
    let rules: Vec<_> = facts.iter().filter_map(|fact| fact.loosens).collect();
    assert_eq!(rules, [1], "the rule can be loosened there: {facts:?}");
    let told = answered(&after(&why, [act(RuleAction::Loosen(1))]));
    assert!(told.document.mode.asking().is_none(), "the list is shown");
    let found = part(&told, 1).unwrap();
    let [row] = found.looser.as_slice() else {
        panic!("{found:?}")
    };
    assert!(row.saves.is_none() && row.is_proved, "{row:?}");
    let best = solved(&fresh()).document.fresh_answer().unwrap().makespan();
    assert!(
        row.costs.starts_with(&format!("makespan {best}")),
        "as late as the best plan without it: {row:?}"
    );
    let taken = after(&told, [act(RuleAction::TakeLooser(0))]);
    assert!(taken.document.fresh_answer().unwrap().plan().is_some());
}
