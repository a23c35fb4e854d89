//! The question `penalty`: the best plan is asked why its penalty is not less, and an
//! exhaustive search of joint states says whether a plan with less exists, and at which costs.
//!
//! `GIVEWAY_RULE_SCENES` sets how many random scenes are asked about, and
//! `GIVEWAY_RANDOM_SEED` which ones.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::check::check;
use giveway_model::format::native;
use giveway_model::{Cost, Question};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest, Verdict};
use giveway_solve::{
    Limits, Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, serve,
};
use giveway_tests::environment;
use giveway_tests::rules_oracle::{Answer, RuleScene, best};
use giveway_tests::rules_random::scene_with_rules;
use serde_json::{Value, json};

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 30_000;

fn solve(scene: &Value) -> SolveAnswer {
    let request = SolveRequest {
        scene: native::read_scene(&scene.to_string()).unwrap(),
        ..SolveRequest::default()
    };
    match serve(&Request::Solve(request), &SilentHost) {
        Response::Solved(answer) => answer,
        other => unreachable!("{other:?}"),
    }
}

fn ask(scene: &Value, solved: &SolveAnswer) -> ExplainAnswer {
    let request = ExplainRequest {
        scene: native::read_scene(&scene.to_string()).unwrap(),
        plan: solved.plan.clone(),
        changes: None,
        at: None,
        question: Question::Penalty,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits::default(),
    };
    match serve(&Request::Explain(request), &SilentHost) {
        Response::Explained(answer) => *answer,
        other => unreachable!("{other:?}"),
    }
}

/// The costs of the best plan whose penalty is less than `most + 1`, penalty first: the
/// least penalty is what the oracle finds when it is the first cost.
fn least_penalty(scene: &Value) -> Option<i64> {
    let mut scene = scene.clone();
    scene["objective"] = json!(["penalty", "makespan"]);
    match best(&RuleScene::read(&scene.to_string(), &[]), None, MOST_STATES) {
        Answer::Best(costs) => costs.first().copied(),
        Answer::Impossible | Answer::Capped => None,
    }
}

#[test]
fn the_penalty_is_less_in_another_plan_just_where_the_oracle_has_one() {
    let (mut necessary, mut costly) = (0, 0);
    for number in 0..environment::number("GIVEWAY_RULE_SCENES", 400) {
        let kinds = [["avoid", "capacity"], ["late", "avoid"], ["late", "gap"]];
        let kinds = kinds[number as usize % 3];
        let seed = environment::number("GIVEWAY_RANDOM_SEED", 53);
        let mut scene = scene_with_rules(seed, number, &kinds);
        scene["objective"] = json!(["makespan", "sum-of-costs", "penalty"]);
        let solved = solve(&scene);
        let (Status::Optimal, Some(costs)) = (solved.status, solved.costs) else {
            continue;
        };
        let what = format!("scene {number}: {scene}");
        if costs.penalty == 0 {
            continue;
        }
        let Some(least) = least_penalty(&scene) else {
            continue;
        };
        let answer = ask(&scene, &solved);
        if i64::from(costs.penalty) == least {
            assert_eq!(answer.verdict, Verdict::Necessary, "{what}");
            necessary += 1;
            continue;
        }
        assert_eq!(answer.verdict, Verdict::Costly, "{what}");
        let other = answer.alternative.as_ref().unwrap();
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let report = check(&instance, other);
        let (other, objective) = (report.costs.unwrap(), instance.objective());
        assert!(report.violations.is_empty(), "{what}");
        assert!(other.get(Cost::Penalty) < costs.penalty, "{what}");
        assert!(
            other.vector(objective) > costs.vector(objective),
            "{what}: the best plan was not the best"
        );
        costly += 1;
    }
    println!("{necessary} necessary, {costly} costly");
    assert!(
        necessary > 20 && costly > 10,
        "{necessary} necessary, {costly} costly"
    );
}
