//! Rules of a scene's own: the solver against an exhaustive search of joint states, and
//! against scenes whose optima were found elsewhere.
//!
//! `GIVEWAY_RULE_SCENES` sets how many random scenes each test compares, and
//! `GIVEWAY_RANDOM_SEED` which ones. The long run:
//!
//! ```text
//! GIVEWAY_RULE_SCENES=50000 cargo test --release -p giveway-tests --test rules_oracle
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::fs;
use std::path::Path;

use giveway_model::check::check;
use giveway_model::format::native;
use giveway_model::{Cost, Instance, Objective};
use giveway_solve::plan::{PlanEnd, PlanRequest, Planner};
use giveway_solve::together::TogetherRequest;
use giveway_solve::trace::AgentLimit;
use giveway_solve::{
    Limits, Reason, Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, Stop, serve,
};
use giveway_tests::environment;
use giveway_tests::rules_oracle::{Answer, RuleScene, best};
use giveway_tests::rules_random::{KINDS, scene_with_rules};
use serde_json::Value;

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 30_000;

fn solve(instance: &Instance, within: Option<u32>) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        within,
        limits: Limits {
            work: Some(20_000_000),
            ..Limits::default()
        },
        ..SolveRequest::default()
    });
    let Response::Solved(answer) = serve(&request, &SilentHost) else {
        unreachable!("a solve request is solved")
    };
    answer
}

/// Plans with the planners that keep rules: what they find is legal, and what CBS proves
/// is the optimum.
fn plan(instance: &Instance, costs: Option<&[i64]>, what: &str) -> u32 {
    let mut found = 0;
    for planner in [Planner::Prioritised, Planner::Lns, Planner::Cbs] {
        let mut request = PlanRequest::new(instance.to_scene(), planner);
        request.limits.work = Some(200_000);
        let Response::Planned(answer) = serve(&Request::Plan(request), &SilentHost) else {
            unreachable!("a plan request is planned")
        };
        if let Some(plan) = &answer.plan {
            let report = check(instance, plan);
            assert!(
                report.is_valid(),
                "{what}, {planner}: {:?}",
                report.violations
            );
            assert!(costs.is_some(), "{what}, {planner}: there is no plan");
            found += 1;
        }
        match answer.ended {
            PlanEnd::Best { reach } if reach.is_complete() => {
                let first = answer.objective.costs()[0];
                let value = answer.costs.unwrap().get(first);
                assert_eq!(
                    costs.map(|costs| costs[0]),
                    Some(i64::from(value)),
                    "{what}"
                );
            }
            PlanEnd::Alone { .. } => assert_eq!(costs, None, "{what}, {planner}"),
            PlanEnd::Stopped { reason } => {
                let contradiction = Reason::Stopped(Stop::Contradiction);
                assert_ne!(reason, contradiction, "{what}, {planner}");
            }
            _ => {}
        }
    }
    found
}

/// The costs of an answer, in the order of the objective in force.
fn vector(instance: &Instance, answer: &SolveAnswer) -> Vec<i64> {
    let objective = instance.in_force(instance.objective().clone());
    let costs = answer.costs.unwrap().vector(&objective);
    costs.into_iter().map(i64::from).collect()
}

/// Compares one scene; whether the oracle came to an end.
fn compare(text: &str, within: Option<u32>, what: &str) -> Option<bool> {
    let instance =
        native::read_instance(text).unwrap_or_else(|faults| panic!("{what}: {faults:?}\n{text}"));
    let scene = RuleScene::read(text, &[]);
    let expected = best(&scene, within.map(i64::from), MOST_STATES);
    let answer = solve(&instance, within);
    if let Some(plan) = &answer.plan {
        let report = check(&instance, plan);
        assert!(report.is_valid(), "{what}: {:?}\n{text}", report.violations);
    }
    let costs = match &expected {
        Answer::Best(costs) => Some(costs.as_slice()),
        Answer::Impossible => None,
        Answer::Capped => return None,
    };
    if within.is_none() && what.len().is_multiple_of(3) {
        plan(&instance, costs, what);
    }
    match expected {
        Answer::Capped => None,
        Answer::Best(costs) => {
            assert_eq!(
                answer.status,
                Status::Optimal,
                "{what}: {costs:?} {:?}\n{text}",
                answer.reason
            );
            assert_eq!(vector(&instance, &answer), costs, "{what}\n{text}");
            Some(true)
        }
        Answer::Impossible => {
            assert_eq!(answer.status, Status::Impossible, "{what}\n{text}");
            Some(false)
        }
    }
}

/// Some agents by themselves can keep limits on their arrivals just when there is a plan for
/// them under deadlines.
#[test]
fn agents_by_themselves_keep_limits_where_the_oracle_has_a_plan() {
    let (mut kept, mut refuted) = (0, 0);
    for number in 0..scenes(200) {
        let kinds = [KINDS[number as usize % KINDS.len()]];
        let scene = scene_with_rules(seed(17), number, &kinds);
        let what = format!("scene {number}, {kinds:?}");
        let limits: Vec<AgentLimit> = (0..2)
            .map(|agent| AgentLimit {
                agent: format!("A{agent}"),
                least: 0,
                at_most: (number as u32 * 7 + agent * 3) % 6 + 2,
            })
            .collect();
        let request = TogetherRequest {
            scene: native::read_scene(&scene.to_string()).unwrap(),
            cost: Cost::SumOfCosts,
            agents: limits.clone(),
            more: None,
            within: None,
            limits: Limits::default(),
        };
        let Response::Together(answer) = serve(&Request::Together(request), &SilentHost) else {
            unreachable!("a question about some agents is answered")
        };
        let mut few = scene.clone();
        few["agents"].as_array_mut().unwrap().truncate(2);
        few["objective"] = serde_json::json!(["makespan"]);
        let rules = few["constraints"].as_array_mut().unwrap();
        for rule in rules.iter_mut() {
            if let Some(names) = rule["agents"].as_array_mut() {
                names.retain(|name| name != "A2");
            }
        }
        let is_about = |rule: &Value| {
            let names = [
                &rule["agent"],
                &rule["first"]["agent"],
                &rule["second"]["agent"],
            ];
            rule["agents"] != serde_json::json!([]) && names.iter().all(|name| **name != "A2")
        };
        rules.retain(is_about);
        for limit in &limits {
            let by = serde_json::json!({
                "kind": "arrive", "agents": [limit.agent], "by": limit.at_most,
            });
            rules.push(by);
        }
        let told = answer.alone.as_ref().and_then(|alone| alone.refuted);
        let expected = match best(&RuleScene::read(&few.to_string(), &[]), None, MOST_STATES) {
            Answer::Capped => continue,
            Answer::Best(_) => false,
            Answer::Impossible => true,
        };
        assert_eq!(told, Some(expected), "{what}, {limits:?}: {few}");
        let counted = if expected { &mut refuted } else { &mut kept };
        *counted += 1;
    }
    println!("{kept} kept, {refuted} refuted");
    assert!(kept > 60 && refuted > 60, "{kept} kept, {refuted} refuted");
}

/// Compares so many scenes with the rules of some kinds; how many have a plan, have none,
/// and were too large.
fn compare_all(scenes: u64, kinds: impl Fn(u64) -> Vec<&'static str>) -> [u32; 3] {
    let mut counts = [0; 3];
    for number in 0..scenes {
        let kinds = kinds(number);
        let scene = scene_with_rules(seed(31), number, &kinds);
        let within = (number % 7 == 0).then_some(number as u32 % 9);
        let what = format!("scene {number}, {kinds:?}, within {within:?}");
        let found = compare(&scene.to_string(), within, &what);
        counts[found.map_or(2, |found| usize::from(!found))] += 1;
    }
    counts
}

/// How many scenes the usual run compares.
fn scenes(usual: u64) -> u64 {
    environment::number("GIVEWAY_RULE_SCENES", usual)
}

/// The seed of the random scenes.
fn seed(usual: u64) -> u64 {
    environment::number("GIVEWAY_RANDOM_SEED", usual)
}

#[test]
fn each_kind_alone_has_the_optimum_of_the_oracle() {
    let [plans, none, large] = compare_all(scenes(500), |number| {
        vec![KINDS[number as usize % KINDS.len()]]
    });
    println!("{plans} with a plan, {none} without, {large} too large");
    assert!(
        plans > 300 && none > 30,
        "{plans} with a plan, {none} without"
    );
}

#[test]
fn two_kinds_together_have_the_optimum_of_the_oracle() {
    let pair = |number: u64| {
        let (i, k) = (
            number as usize % KINDS.len(),
            number as usize / KINDS.len() % KINDS.len(),
        );
        vec![KINDS[i], KINDS[k]]
    };
    let [plans, none, large] = compare_all(scenes(900), pair);
    println!("{plans} with a plan, {none} without, {large} too large");
    assert!(
        plans > 350 && none > 100,
        "{plans} with a plan, {none} without"
    );
}

#[test]
fn scenes_with_known_answers_have_these() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/rules");
    let mut seen = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let known: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let what = path.display().to_string();
        let text = known["instance"].to_string();
        let instance = native::read_instance(&text).unwrap();
        seen += 1;
        if known["status"] == "broken" {
            broken(&known, &instance, &what);
            continue;
        }
        let answer = solve(&instance, None);
        assert_eq!(word(answer.status), known["status"], "{what}");
        assert_eq!(
            answer.reach.is_complete(),
            known["complete"] == true,
            "{what}"
        );
        if let Some(costs) = answer.costs {
            let objective: Objective = instance.in_force(instance.objective().clone());
            for &cost in objective.costs() {
                assert_eq!(
                    known["costs"][cost.name()],
                    costs.get(cost),
                    "{what}: {cost}"
                );
            }
        }
    }
    assert_eq!(seen, 75);
}

fn word(status: Status) -> Value {
    serde_json::to_value(status).unwrap()
}

/// A plan that breaks one rule: each time at which it does is told.
fn broken(known: &Value, instance: &Instance, what: &str) {
    let by_name = |lists: &Value| -> Value {
        let agents = instance.agents().iter().zip(lists.as_array().unwrap());
        agents
            .map(|(agent, list)| (agent.name.clone(), list.clone()))
            .collect()
    };
    let plan = serde_json::json!({
        "giveway": 1,
        "paths": by_name(&known["plan"]["paths"]),
        "charges": by_name(&known["plan"]["charges"]),
    });
    let plan = native::read_plan(&plan.to_string()).unwrap();
    let report = check(instance, &plan);
    let told = report.violations.iter().map(|it| {
        let broken = it.broken.as_ref().unwrap();
        serde_json::json!([it.time, broken.kind, broken.name, it.agents, broken.cells])
    });
    let told: Vec<Value> = told.collect();
    let expected = known["violations"].as_array().unwrap().iter();
    let expected = expected.map(|it| {
        serde_json::json!([
            it["time"],
            it["rule"],
            it["name"],
            it["agents"],
            it["cells"]
        ])
    });
    assert_eq!(told, expected.collect::<Vec<Value>>(), "{what}");
    let costs = report.costs.unwrap();
    assert_eq!(
        known["costs"]["penalty"],
        costs.get(Cost::Penalty),
        "{what}"
    );
}
