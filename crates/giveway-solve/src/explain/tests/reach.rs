//! Reasons and repairs reach as far as the answer that they stand in.

use giveway_model::{Question, format::native};

use crate::{
    Limits, Request, Response, SilentHost,
    explain::{Core, ExplainAnswer, ExplainRequest, facts_claim},
    serve,
};

fn explained(scene: &str, question: Question, within: Option<u32>) -> Response {
    serve(
        &Request::Explain(ExplainRequest {
            // Obstacles are an X, since no raw string can hold them.
            scene: native::read_scene(&scene.replace('X', "#")).unwrap(),
            plan: None,
            changes: None,
            at: None,
            question,
            objective: None,
            within,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: Limits::default(),
        }),
        &SilentHost,
    )
}

fn answer(scene: &str, question: Question, within: Option<u32>) -> ExplainAnswer {
    match explained(scene, question, within) {
        Response::Explained(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

/// Two robots that swap in a corridor so long that fewer walls leave a plan later than the
/// horizon: none of these walls is left out on the word of the horizon.
const CORRIDOR: &str = r#"{ "giveway": 1, "map": ["...........", "XXXXXXXXXX.", "...........",
    ".XXXXXXXXXX", "...........", "XXXXXXXXXX.", "...........", ".XXXXXXXXXX", "...........",
    "XXXXXXXXXX.", "..........."], "agents": [
    { "name": "A1", "start": [0, 0], "goal": [1, 0] },
    { "name": "A2", "start": [1, 0], "goal": [0, 0] }] }"#;

#[test]
fn no_fact_is_left_out_of_a_set_on_the_word_of_a_horizon() {
    let answer = answer(CORRIDOR, Question::Unsolvable, None);
    assert!(answer.reach.is_complete());
    for core in answer.core.iter().flat_map(Core::sets) {
        assert!(core.reach.is_complete(), "{core:?}");
    }
}

/// With a battery of 3 the robots go a long way round, later than the horizon.
const BATTERY: &str = r#"{ "giveway": 1, "map": ["X.XXXXX", ".......", "XXXXXX.", "*******",
    "*XXXXXX", "*******", "XXXXXX*", "*******", "X.XXXXX"], "agents": [
    { "name": "A1", "start": [5, 1], "goal": [6, 1], "battery": { "capacity": 2, "initial": 2 } },
    { "name": "A2", "start": [6, 1], "goal": [5, 1] }] }"#;

#[test]
fn a_battery_is_the_least_where_less_is_ruled_out_as_far_as_the_answer() {
    let answer = answer(BATTERY, Question::Unsolvable, None);
    assert!(answer.reach.is_complete());
    let larger = |edit: &crate::explain::Edit| matches!(edit, crate::explain::Edit::Battery { capacity, .. } if *capacity > 3);
    for repair in &answer.repairs {
        let claims = repair.least && repair.edits.iter().any(larger);
        assert!(!claims, "{}", repair.text);
    }
}

#[test]
fn a_plan_is_the_best_and_there_is_none_to_ask_about_within_a_makespan() {
    let detour = r#"{ "giveway": 1, "map": ["...", ".#.", ".#.", "..."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#;
    let Response::Refused(refusal) = explained(detour, Question::Plan, Some(1)) else {
        panic!("a plan of one step");
    };
    let sentence = refusal.sentences().join(" ");
    assert!(
        sentence.contains("no plan of makespan at most 1 to ask about"),
        "{sentence}"
    );
    let slow = r##"{ "giveway": 1, "map": ["..~~~~~..", "#.######.", "........."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [8, 0] },
        { "name": "B", "start": [8, 0], "goal": [0, 0] }], "objective": ["moves"] }"##;
    let answer = answer(slow, Question::Plan, Some(12));
    assert_eq!(answer.reach.within(), Some(12));
    assert_eq!(
        answer.words,
        "The plan keeps all rules, and no plan of makespan at most 12 is better."
    );
}

#[test]
fn a_robot_without_a_goal_has_a_task() {
    let scene = r##"{ "giveway": 1, "map": ["...", "#.#"], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }, { "name": "A2", "start": [1, 0] }] }"##;
    let question = Question::Arrival { agent: "A2".into() };
    let answer = answer(scene, question.clone(), None);
    let core = answer.core.expect("facts");
    let claim = facts_claim(&question, answer.verdict, &core);
    assert!(!claim.contains("goal"), "{claim}");
}
