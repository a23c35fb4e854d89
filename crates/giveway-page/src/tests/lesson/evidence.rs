//! What a lesson shows as evidence: plans, the price of a rule by two of them; and the tree of a
//! search by hand, which stays.

use giveway_course::lesson::Layer;
use giveway_course::port::{BoardPlan, Evidence, RulePrice, ToPage, WithoutRule};
use giveway_model::Cost;
use giveway_model::format::native;

use super::{Board, board, opened, say};
use crate::inside::{HandAction, InsideAction};
use crate::reduce::tests::{after, stroke};
use crate::tests::{answered, saying};
use crate::{Action, Tool, ViewAction, sample};

/// A1 lets A2 pass in the bay.
const AROUND: &str = r#"{ "giveway": 1, "paths": {
    "A1": [[0, 0], [1, 0], [1, 1], [1, 0], [2, 0], [3, 0]],
    "A2": [[3, 0], [2, 0], [1, 0], [0, 0]] } }"#;

#[test]
fn evidence_is_shown_until_the_next_edit() {
    let lesson = opened(
        &sample::solved(),
        Board {
            plan: BoardPlan::Hidden,
            show: vec![Layer::Trails, Layer::Lanes],
            ..board(1)
        },
    );
    assert!(lesson.lesson().unwrap().hides_plan());
    assert!(!lesson.lesson().unwrap().shows(Layer::Lanes) && lesson.plan().is_none());
    let legal = r#"{ "giveway": 1, "paths": {
        "A1": [[0, 0], [1, 0], [2, 0], [3, 0]], "A2": [[3, 0], [3, 0]] } }"#;
    // It is not legal in this scene: the audit tells where.
    let plan = native::read_plan(legal).unwrap();
    let evidence = Evidence {
        plan: Some(plan),
        time: Some(2),
        ..Evidence::default()
    };
    let shown = say(&lesson, ToPage::Show(Box::new(evidence)));
    assert!(shown.document.mode.audit().is_some());
    assert!(shown.lesson().unwrap().shows(Layer::Lanes));
    assert_eq!(shown.view.playback.time, 2);
    let playing = say(&say(&shown, ToPage::Go(0)), ToPage::Play);
    assert!(playing.view.playback.playing && playing.view.playback.time == 0);

    let best = Board {
        plan: BoardPlan::Best,
        ..board(2)
    };
    let solved = answered(&opened(&lesson, best));
    assert!(solved.plan().is_some());
    let edited = after(&solved, stroke(Tool::Obstacle, &[(1, 1)]));
    assert!(edited.document.answer.is_none(), "it is of another scene");
}

#[test]
fn the_price_of_a_rule_is_shown_by_both_plans_where_there_is_room() {
    let mut scene = native::read_scene(
        r#"{ "giveway": 1, "map": ["....."], "agents": [
        { "name": "A1", "start": [1, 0], "goal": [4, 0] },
        { "name": "A2", "start": [0, 0], "goal": [3, 0] }] }"#,
    )
    .unwrap();
    scene.constraints = vec![serde_json::from_str(r#"{ "kind": "gap", "steps": 1 }"#).unwrap()];
    let priced = Board {
        scene,
        plan: BoardPlan::Hidden,
        ..board(1)
    };
    let lesson = opened(&sample::solved(), priced);
    let plan = |second: &str| {
        let first = "[[1, 0], [2, 0], [3, 0], [4, 0]]";
        let plan = format!(r#"{{ "giveway": 1, "paths": {{ "A1": {first}, "A2": {second} }} }}"#);
        native::read_plan(&plan).unwrap()
    };
    let without = WithoutRule {
        rule: 0,
        plan: plan("[[0, 0], [1, 0], [2, 0], [3, 0]]"),
        price: Some(RulePrice {
            cost: Cost::Makespan,
            with: 4,
            without: 3,
        }),
    };
    let evidence = Evidence {
        plan: Some(plan("[[0, 0], [0, 0], [1, 0], [2, 0], [3, 0]]")),
        without: Some(Box::new(without.clone())),
        proved: true,
        ..Evidence::default()
    };
    let wide = |is| Action::View(ViewAction::SetWide(is));
    let shown = say(
        &after(&lesson, [wide(true)]),
        ToPage::Show(Box::new(evidence)),
    );
    let beside = shown.beside().unwrap();
    assert!(beside.draft.scene().constraints[0].off);
    assert_eq!(beside.plan().unwrap().path("A2").len(), 4);
    assert_eq!(shown.plan().unwrap().path("A2").len(), 5);
    assert_eq!(
        saying(&shown),
        "The best plan: makespan 4, sum of costs 7, 0 charges."
    );
    // A phone has one board: the plan with the rule stays there.
    let narrow = after(&shown, [wide(false)]);
    assert!(narrow.beside().is_none());
    assert_eq!(narrow.plan().unwrap().path("A2").len(), 5);
    let edited = after(&shown, stroke(Tool::Obstacle, &[(2, 0)]));
    assert!(edited.beside().is_none());

    // Where no plan keeps the rule, the one without it is shown alone.
    let alone = Evidence {
        without: Some(Box::new(WithoutRule {
            price: None,
            ..without
        })),
        ..Evidence::default()
    };
    for is_wide in [true, false] {
        let lesson = after(&lesson, [wide(is_wide)]);
        let shown = say(&lesson, ToPage::Show(Box::new(alone.clone())));
        assert!(shown.beside().is_none() && shown.document.mode.audit().is_none());
        assert_eq!(shown.plan().unwrap().path("A2").len(), 4);
        let words = "Without rule 1 there is a plan: makespan 3, sum of costs 6, 0 charges.";
        assert_eq!(saying(&shown), words);
        let edited = after(&shown, stroke(Tool::Obstacle, &[(2, 0)]));
        assert!(edited.plan().is_none());
    }
}

#[test]
fn a_lesson_by_hand_keeps_its_tree() {
    let by_hand = Board {
        plan: BoardPlan::Hidden,
        show: vec![Layer::ByHand],
        ..board(5)
    };
    let lesson = opened(&sample::solved(), by_hand);
    assert!(lesson.is_by_hand() && lesson.keeps_inside());
    let left = after(&lesson, [Action::Inside(InsideAction::Show(false))]);
    assert!(left.is_by_hand(), "nothing else has its place");
    let planner = InsideAction::Hand(HandAction::Show(false));
    let planner = after(&left, [Action::Inside(planner)]);
    assert!(planner.is_by_hand(), "its tree would tell the answer");
    // With lanes there is something to go back to, once they are shown.
    let both = Board {
        plan: BoardPlan::Given(native::read_plan(AROUND).unwrap()),
        show: vec![Layer::Inside, Layer::Lanes],
        ..board(6)
    };
    let show = |is| Action::Inside(InsideAction::Show(is));
    let inside = after(&opened(&lesson, both), [show(true)]);
    assert!(inside.is_inside());
    assert!(!after(&inside, [show(false)]).is_inside());
}
