//! What is done on the board of a lesson, and what the lesson hears of it.

use giveway_course::lesson::Layer;
use giveway_course::port::{
    BoardNumber, BoardPlan, Evidence, Hand, Happened, Lit, Pick, RulePrice, ToPage, WithoutRule,
};
use giveway_model::Cost;
use giveway_model::format::native;

use super::{Board, at, board, heard, opened, say, scene, swapping, told};
use crate::audit::bursts_of;
use crate::inside::{HandAction, InsideAction};
use crate::reduce::tests::{after, stroke};
use crate::steering::Lead;
use crate::tests::{answered, saying, seek, select};
use crate::{Action, BoardAction, PlayAction, Selection, State, Tab, Tool, ViewAction, sample};

fn press(x: u32, y: u32) -> [Action; 2] {
    [
        Action::Board(BoardAction::Press(at(x, y))),
        Action::Board(BoardAction::Release),
    ]
}

#[test]
fn an_edit_is_told_once_when_the_stroke_ends_and_is_taken_back() {
    let lesson = opened(&sample::solved(), board(7));
    let (edited, said) = heard(&lesson, stroke(Tool::Obstacle, &[(1, 0), (2, 0)]));
    let mut after_it = scene();
    after_it.map[0] = ".##.".to_owned();
    assert_eq!(said, [told(7, Happened::Board(Box::new(after_it)))]);
    let sealed = say(&edited, ToPage::Seal(vec![at(1, 0)]));
    assert_eq!(sealed.lesson().unwrap().sealed, [at(1, 0)]);
    let action = Action::Lesson(super::says(ToPage::TakeBack));
    let (back, said) = heard(&sealed, [action]);
    assert_eq!(said, [told(7, Happened::Board(Box::new(scene())))]);
    assert!(back.lesson().unwrap().sealed.is_empty());
    let afresh = say(&edited, ToPage::StartAfresh(BoardNumber(8)));
    assert_eq!(afresh.document.draft.scene(), &scene());
    assert_eq!(afresh.lesson().unwrap().board.number, BoardNumber(8));
    let action = Action::Lesson(super::says(ToPage::StartAfresh(BoardNumber(8))));
    assert_eq!(heard(&edited, [action]).1, [], "it knows that itself");
}

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
        without: Some(without.clone()),
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
        without: Some(WithoutRule {
            price: None,
            ..without
        }),
        ..Evidence::default()
    };
    for is_wide in [true, false] {
        let lesson = after(&lesson, [wide(is_wide)]);
        let shown = say(&lesson, ToPage::Show(Box::new(alone.clone())));
        assert!(shown.beside().is_none() && shown.document.mode.audit().is_none());
        assert_eq!(shown.plan().unwrap().path("A2").len(), 4);
        let words = "Without the rule there is a plan: makespan 3, sum of costs 6, 0 charges.";
        assert_eq!(saying(&shown), words);
        let edited = after(&shown, stroke(Tool::Obstacle, &[(2, 0)]));
        assert!(edited.plan().is_none());
    }
}

#[test]
fn conflicts_are_not_shown_to_who_is_to_find_them() {
    let spot = Board {
        plan: BoardPlan::Given(swapping()),
        hand: Hand::Points,
        ..board(3)
    };
    let lesson = opened(&sample::solved(), spot);
    assert!(lesson.document.mode.audit().is_some());
    assert!(bursts_of(&lesson, "A1").is_empty());
    assert_eq!(saying(&lesson), "Does this plan keep the rules?");
    let (state, said) = heard(&lesson, [seek(1)].into_iter().chain(press(1, 0)));
    let pick = Pick {
        cell: at(1, 0),
        time: 1,
        robots: vec!["A1".to_owned()],
    };
    let expected = [Happened::Time(1), Happened::Picked(pick.clone())];
    assert_eq!(said, expected.map(|what| told(3, what)));
    let (state, said) = heard(&state, press(1, 0));
    let again = [told(3, Happened::Picked(pick))];
    assert_eq!(said, again, "the same again");
    // A click selects, and a key uses the tool where the cursor is.
    let (state, said) = heard(&state, [select(0)]);
    assert_eq!(said, again, "selected");
    let cursor = Action::Board(BoardAction::MoveCursor(at(1, 0)));
    let (state, said) = heard(&state, [cursor, Action::Board(BoardAction::UseTool)]);
    assert_eq!(said, again, "by a key");
    let shown = say(&state, ToPage::Show(Box::default()));
    assert_eq!(bursts_of(&shown, "A1"), [1.5]);
    assert!(saying(&shown).contains("rule"), "{}", saying(&shown));
}

#[test]
fn robots_are_led_step_by_step() {
    let lead = Board {
        hand: Hand::Leads(vec!["A2".to_owned()]),
        tools: Vec::new(),
        ..board(4)
    };
    let lesson = opened(&sample::solved(), lead);
    assert_eq!(lesson.view.selection, Selection::Agent(1));
    let step = |by| Action::Steer(Lead::Step(by));
    let (state, said) = heard(&lesson, [step((-1, 0)), step((-1, 0))]);
    let led = |state: &State| state.document.mode.steering().unwrap().led().0.clone();
    let cells = led(&state).path("A2").to_vec();
    assert_eq!(cells, [at(3, 0), at(2, 0), at(1, 0)].map(Some));
    let plans: Vec<_> = said
        .iter()
        .filter_map(|said| match &said.what {
            Happened::Led(plan) => Some(plan.path("A2").len()),
            _ => None,
        })
        .collect();
    assert_eq!(plans, [2, 3]);
    let back = say(&state, ToPage::TakeBack);
    assert_eq!(led(&back).path("A2").len(), 2);
    let waits = say(&back, ToPage::Wait);
    let cells = led(&waits).path("A2").to_vec();
    assert_eq!(cells, [at(3, 0), at(2, 0), at(2, 0)].map(Some));
    // Nobody else is led.
    let other = after(&state, [select(0), Action::Steer(Lead::Begin)]);
    assert_eq!(other.document, state.document);
    let left = after(&state, [Action::Steer(Lead::Discard)]);
    assert_eq!(left.document, state.document, "only the lesson ends it");
}

#[test]
fn the_robot_that_is_chosen_is_led_on_from_where_it_is() {
    let lead = Board {
        hand: Hand::Leads(vec!["A1".to_owned(), "A2".to_owned()]),
        tools: Vec::new(),
        ..board(4)
    };
    let lesson = opened(&sample::solved(), lead);
    let step = |by| Action::Steer(Lead::Step(by));
    let own = |state: &State| state.document.mode.steering().unwrap().agent;
    let lengths = |state: &State| {
        let plan = state.document.mode.steering().unwrap().led().0.clone();
        ["A1", "A2"].map(|name| plan.path(name).len())
    };
    let one = after(&lesson, [step((1, 0))]);
    assert_eq!((own(&one), lengths(&one)), (0, [2, 1]));
    let chosen = Action::Lesson(super::says(ToPage::Lead("A2".to_owned())));
    let (two, said) = heard(&one, [chosen]);
    assert!(said.contains(&told(4, Happened::Leads("A2".to_owned()))));
    assert_eq!((own(&two), lengths(&two)), (1, [2, 1]));
    assert_eq!(two.view.playback.time, 0, "it has not moved yet");
    let both = after(&two, [step((-1, 0)), step((-1, 0)), select(0)]);
    assert_eq!((own(&both), lengths(&both)), (0, [2, 3]));
    assert_eq!(both.view.playback.time, 1);
    // To choose a robot is no step that can be taken back.
    let back = say(&both, ToPage::TakeBack);
    assert_eq!((own(&back), lengths(&back)), (1, [2, 2]));
    let nobody = say(&both, ToPage::Lead("A9".to_owned()));
    assert_eq!(nobody.document, both.document);
}

#[test]
fn the_lesson_lights_what_it_names() {
    let lesson = opened(&sample::solved(), board(1));
    let lit = Lit::Robot("A1".to_owned());
    let state = say(&lesson, ToPage::Light(Some(lit.clone())));
    assert_eq!(state.lesson().unwrap().lit, Some(lit));
    let dark = say(&state, ToPage::Light(None));
    assert_eq!(dark.lesson().unwrap().lit, None);
    let play = after(&dark, [Action::Play(PlayAction::Play)]);
    assert!(!play.view.playback.playing, "there is no plan to play");
}

#[test]
fn a_phone_shows_the_lesson_first() {
    let lesson = opened(&sample::solved(), board(5));
    assert_eq!(lesson.view.tab, Tab::Inspector);
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
    assert!(planner.is_inside() && !planner.is_by_hand());
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

/// A1 lets A2 pass in the bay.
const AROUND: &str = r#"{ "giveway": 1, "paths": {
    "A1": [[0, 0], [1, 0], [1, 1], [1, 0], [2, 0], [3, 0]],
    "A2": [[3, 0], [2, 0], [1, 0], [0, 0]] } }"#;
