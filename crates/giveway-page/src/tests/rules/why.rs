//! Rules as questions, the plan without one beside, and waits that a rule causes.

use giveway_model::Question;

use super::{act, fresh, marked, solved};
use crate::reduce::tests::after;
use crate::rules::{RuleAction, card, list, waits_for};

use crate::tests::answered;
use crate::timeline::Way;
use crate::{
    Action, AskAction, BoardAction, Edit, Selection, SolveAction, State, ViewAction, inspect,
};

/// At most one robot in the aisle, solved.
fn ruled() -> State {
    solved(&after(&marked(), [act(RuleAction::Add)]))
}

#[test]
fn a_wait_names_the_rule_that_causes_it() {
    let state = ruled();
    let mut found = Vec::new();
    for agent in 0..2 {
        let lane = inspect::planned(&state, agent).unwrap();
        for step in lane.steps.iter().filter(|step| step.way == Way::Wait) {
            found.extend(waits_for(&state, agent, step.begins));
        }
    }
    assert!(
        found.contains(&(1, "zone 1".to_owned())),
        "of two that pass the aisle one waits: {found:?}"
    );
    // Without the rule no wait is for one; and who moves waits for nothing.
    let off = solved(&after(&state, [act(RuleAction::Switch(1))]));
    for agent in 0..3 {
        let lane = inspect::planned(&off, agent).unwrap();
        for step in &lane.steps {
            let rules = waits_for(&off, agent, step.begins);
            assert!(rules.iter().all(|(rule, _)| *rule == 0), "{rules:?}");
        }
    }
}

#[test]
fn a_sentence_is_asked_as_a_question_and_made_a_rule() {
    let state = solved(&fresh());
    let asks = after(&state, [act(RuleAction::Question)]);
    let shown = card(&asks).unwrap();
    assert!(shown.asks);
    assert!(shown.offers.len() > 4, "{:?}", shown.offers);
    let apart = shown
        .offers
        .iter()
        .find(|offer| offer.icon == "gap")
        .unwrap();
    let gap = after(&asks, [act(RuleAction::Write(apart.rule.clone()))]);
    let asked = after(&gap, [act(RuleAction::Ask)]);
    let question = asked
        .document
        .mode
        .asking()
        .map(|asking| asking.question().clone());
    let Some(Question::Rule { rule }) = question else {
        // The plan keeps the gap: then it is said, and nothing is asked.
        assert!(asked.view.notice.is_some());
        return;
    };
    assert_eq!(rule.kind_name(), "gap");
    assert!(!asked.is_writing_rule());
    let made = after(&gap, [act(RuleAction::Add)]);
    assert_eq!(made.document.draft.scene().constraints.len(), 2);
}

#[test]
fn a_rule_that_is_off_is_asked_about() {
    let off = after(&ruled(), [act(RuleAction::Switch(1))]);
    let state = answered(&after(&off, [Action::Solve(SolveAction::Solve)]));
    let asked = after(&state, [act(RuleAction::AskAbout(1))]);
    let asking = asked.document.mode.asking().unwrap();
    let Question::Rule { rule } = asking.question() else {
        panic!("{:?}", asking.question());
    };
    assert!(!rule.off);
    let left = after(&asked, [Action::Ask(AskAction::Close)]);
    assert!(left.document.mode.asking().is_none());
}

#[test]
fn the_plan_without_a_rule_stands_beside() {
    let wide = after(&ruled(), [Action::View(ViewAction::SetWide(true))]);
    let nothing = after(&wide, [act(RuleAction::Without(Some(1)))]);
    assert!(nothing.beside().is_none(), "its price is not known");
    let priced = answered(&after(&wide, [act(RuleAction::Price)]));
    let row = &list(&priced).unwrap().rows[1];
    assert!(row.price.as_ref().unwrap().has_plan && !row.is_beside);
    let both = after(&priced, [act(RuleAction::Without(Some(1)))]);
    let beside = both.beside().unwrap();
    assert!(beside.draft.scene().constraints[1].off);
    let costs = |answer: &crate::Answer| answer.solved.costs.unwrap().makespan;
    assert_eq!((costs(both.shown().unwrap()), costs(beside)), (10, 8));
    // Each board shows the rules of its own scene.
    let holds = |draft| crate::board::rules_now(&both, draft).holds;
    assert_eq!(holds(both.world()), [true, true]);
    assert_eq!(holds(&beside.draft), [true, false]);
    assert!(list(&both).unwrap().rows[1].is_beside);
    assert_eq!(crate::beside::other_title(&both), "Without the rule");
    // It goes when the scene changes, and by the same button.
    let away = after(&both, [act(RuleAction::Without(None))]);
    assert!(away.beside().is_none());
    let edited = after(&both, [act(RuleAction::Switch(0))]);
    assert!(edited.beside().is_none());
}

#[test]
fn the_rule_at_goals_changes_where_it_is_listed() {
    let state = fresh();
    let change = list(&state).unwrap().problem[1].change.clone().unwrap();
    let gone = after(&state, [Action::Edit(change)]);
    let now = &list(&gone).unwrap().problem[1];
    assert_eq!(now.sentence, "Robots vanish at their goals");
    assert!(matches!(now.change, Some(Edit::AtGoal(_))));
    let robot = Action::Board(BoardAction::Select(Selection::Agent(0)));
    assert!(card(&after(&gone, [robot, act(RuleAction::Question)])).is_some());
}
