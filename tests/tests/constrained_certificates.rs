//! Certificates of scenes with rules of their own, beside the oracle of these rules: the
//! plain formula, the search of states, and certificates as a whole.
//!
//! `GIVEWAY_RULE_SCENES` sets how many random scenes each test compares, and
//! `GIVEWAY_RANDOM_SEED` which ones. The long run:
//!
//! ```text
//! GIVEWAY_RULE_SCENES=20000 cargo test --release -p giveway-tests --test constrained_certificates
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use giveway_model::check::check;
use giveway_model::condition::{Act, Times, Visit};
use giveway_model::format::native;
use giveway_model::{Cell, Condition, Cost, Instance, Plan};
use giveway_proof::exhaust::{Exhausted, exhaust, exhaust_kind};
use giveway_proof::{Budget, Certified, Claim, Conclusion, Outcome, export, plain, prove, verify};
use giveway_solve::{
    CertifyRequest, Limits, Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, serve,
};
use giveway_tests::environment;
use giveway_tests::formula::{allows, names_all};
use giveway_tests::rules_oracle::{Answer, RuleScene, best};
use giveway_tests::rules_random::{KINDS, scene_with_rules};
use serde_json::Value;

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 30_000;
/// The makespan up to which formulas are written here.
const LAST: u32 = 11;

fn scenes(usual: u64) -> u64 {
    environment::number("GIVEWAY_RULE_SCENES", usual)
}

fn seed(usual: u64) -> u64 {
    environment::number("GIVEWAY_RANDOM_SEED", usual)
}

/// One kind, or two.
fn kinds(number: u64) -> Vec<&'static str> {
    let of = |number: u64| KINDS[number as usize % KINDS.len()];
    if number.is_multiple_of(3) {
        vec![of(number / 3)]
    } else {
        vec![of(number), of(number / KINDS.len() as u64)]
    }
}

fn is_satisfiable(instance: &Instance, claim: &Claim) -> bool {
    let formula = plain::formula(instance, claim, &Budget::default()).unwrap();
    match prove(&formula, &Budget::default()) {
        Outcome::Satisfiable => true,
        Outcome::Proof(_) => false,
        Outcome::Stopped => panic!("too large"),
    }
}

/// The claims that a scene with these optima has: all of them can be met together, and of
/// each that none has less, the ones before met.
struct Optima {
    costs: Vec<(Cost, u32)>,
}

impl Optima {
    fn of(instance: &Instance, vector: &[i64]) -> Self {
        let objective = instance.in_force(instance.objective().clone());
        let values = vector.iter().map(|&value| u32::try_from(value).unwrap());
        let costs = objective.costs().iter().copied().zip(values);
        Self {
            costs: costs.collect(),
        }
    }

    fn met(&self) -> BTreeMap<Cost, u32> {
        self.costs.iter().copied().collect()
    }

    fn less(&self) -> Vec<BTreeMap<Cost, u32>> {
        let mut less = Vec::new();
        for (i, &(cost, least)) in self.costs.iter().enumerate() {
            if let Some(below) = least.checked_sub(1) {
                let before = self.costs[..i].iter().copied();
                less.push(before.chain([(cost, below)]).collect());
            }
        }
        less
    }
}

#[test]
fn a_formula_is_satisfiable_exactly_where_the_oracle_has_a_plan() {
    let (mut plans, mut none, mut limits) = (0, 0, 0);
    for number in 0..scenes(252) {
        let scene = scene_with_rules(seed(61), number, &kinds(number)).to_string();
        let instance = native::read_instance(&scene).unwrap();
        let claim = |most| Claim {
            most,
            ..Claim::default().within(Some(LAST))
        };
        let oracle = RuleScene::read(&scene, &[]);
        match best(&oracle, Some(i64::from(LAST)), MOST_STATES) {
            Answer::Capped => {}
            Answer::Impossible => {
                none += 1;
                let any = claim(BTreeMap::new());
                assert!(!is_satisfiable(&instance, &any), "{number}: {scene}");
            }
            Answer::Best(vector) => {
                plans += 1;
                let optima = Optima::of(&instance, &vector);
                let met = claim(optima.met());
                assert!(
                    is_satisfiable(&instance, &met),
                    "{number}: {vector:?} {scene}"
                );
                for less in optima.less() {
                    limits += 1;
                    assert!(
                        !is_satisfiable(&instance, &claim(less.clone())),
                        "{number}: {less:?} of {vector:?} {scene}"
                    );
                }
            }
        }
    }
    println!("{plans} with plans, {none} without, {limits} limits");
    assert!(plans > 100 && none > 50 && limits > 150);
}

fn solved(instance: &Instance) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        within: Some(LAST),
        limits: Limits {
            work: Some(5_000_000),
            ..Limits::default()
        },
        ..SolveRequest::default()
    });
    let Response::Solved(answer) = serve(&request, &SilentHost) else {
        unreachable!("a solve request is solved")
    };
    answer
}

/// The oracle knows no robots that may rest anywhere: here the solver says what is best.
#[test]
fn a_formula_agrees_with_the_solver_on_robots_without_goals() {
    let (mut plans, mut none, mut limits) = (0, 0, 0);
    for number in 0..scenes(168) {
        let mut scene = scene_with_rules(seed(65), number, &kinds(number));
        let agents = scene["agents"].as_array_mut().unwrap();
        for agent in agents.iter_mut().skip(number as usize % 2) {
            agent.as_object_mut().unwrap().remove("goal");
        }
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let claim = |most| Claim {
            most,
            ..Claim::default().within(Some(LAST))
        };
        let answer = solved(&instance);
        let status = answer.status;
        if status == Status::Impossible {
            none += 1;
            let any = claim(BTreeMap::new());
            assert!(!is_satisfiable(&instance, &any), "{number}: {scene}");
        }
        if let Some(costs) = answer.costs.filter(|_| status == Status::Optimal) {
            plans += 1;
            let objective = instance.in_force(instance.objective().clone());
            let vector: Vec<i64> = costs
                .vector(&objective)
                .into_iter()
                .map(i64::from)
                .collect();
            let optima = Optima::of(&instance, &vector);
            let met = claim(optima.met());
            assert!(is_satisfiable(&instance, &met), "{number}: {scene}");
            for less in optima.less() {
                limits += 1;
                assert!(
                    !is_satisfiable(&instance, &claim(less.clone())),
                    "{number}: {less:?} of {vector:?} {scene}"
                );
            }
        }
    }
    println!("{plans} with plans, {none} without, {limits} limits");
    assert!(plans > 80 && none > 10 && limits > 80);
}

/// Plans that were made without rules, and with them, and those that begin later.
#[test]
fn a_plan_satisfies_the_formula_exactly_where_it_keeps_the_rules() {
    let (mut valid, mut broken) = (0, 0);
    for number in 0..scenes(420) {
        let mut scene = scene_with_rules(seed(62), number, &kinds(number));
        let instance = native::read_instance(&scene.to_string()).unwrap();
        for rule in scene["constraints"].as_array_mut().unwrap() {
            rule["off"] = Value::Bool(true);
        }
        let free = native::read_instance(&scene.to_string()).unwrap();
        let answers = [solved(&free), solved(&instance)];
        let mut plans: Vec<Plan> = answers.into_iter().filter_map(|it| it.plan).collect();
        plans.extend(plans.clone().iter().map(|plan| later(&instance, plan)));
        let claim = Claim::default().within(Some(LAST));
        let formula = plain::formula(&instance, &claim, &Budget::default()).unwrap();
        for plan in plans {
            let report = check(&instance, &plan);
            if report.costs.is_none_or(|costs| costs.makespan > LAST) {
                continue;
            }
            let allowed =
                names_all(&formula, &instance, &plan) && allows(&formula, &instance, &plan);
            let is_valid = report.is_valid();
            assert_eq!(
                allowed, is_valid,
                "{number}: {:?} {plan:?} {scene}",
                report.violations
            );
            *(if is_valid { &mut valid } else { &mut broken }) += 1;
        }
    }
    println!("{valid} valid, {broken} broken");
    assert!(valid > 300 && broken > 200, "{valid} {broken}");
}

/// The same plan, begun a step later.
fn later(instance: &Instance, plan: &Plan) -> Plan {
    let mut late = plan.clone();
    for path in late.paths.values_mut() {
        path.insert(0, path[0]);
    }
    for time in late.charges.values_mut().flatten() {
        *time += 1;
    }
    late.cut_trailing_goals(instance);
    late
}

#[test]
fn a_search_of_states_agrees_with_the_oracle_at_any_horizon() {
    let budget = Budget {
        states: 60_000,
        ..Budget::default()
    };
    let (mut plans, mut none, mut limits, mut stopped) = (0, 0, 0, 0);
    for number in 0..scenes(420) {
        let scene = scene_with_rules(seed(63), number, &kinds(number)).to_string();
        let instance = native::read_instance(&scene).unwrap();
        let all: Vec<usize> = (0..instance.agents().len()).collect();
        let mut agrees = |most: &BTreeMap<Cost, u32>, exists: bool| {
            let found = exhaust(&instance, &all, most, &budget);
            stopped += u32::from(found == Exhausted::Stopped);
            found == Exhausted::Stopped || matches!(found, Exhausted::Plan(_)) == exists
        };
        match best(&RuleScene::read(&scene, &[]), None, MOST_STATES) {
            Answer::Capped => {}
            Answer::Impossible => {
                none += 1;
                assert!(agrees(&BTreeMap::new(), false), "{number}: {scene}");
            }
            Answer::Best(vector) => {
                plans += 1;
                let optima = Optima::of(&instance, &vector);
                assert!(agrees(&optima.met(), true), "{number}: {vector:?} {scene}");
                for less in optima.less() {
                    limits += 1;
                    assert!(
                        agrees(&less, false),
                        "{number}: {less:?} of {vector:?} {scene}"
                    );
                }
            }
        }
    }
    println!("{plans} with plans, {none} without, {limits} limits, {stopped} too large");
    assert!(plans > 200 && none > 50 && limits > 300 && stopped < 40);
}

/// A condition of a claim about agents and cells of a scene.
fn condition(number: u64, instance: &Instance) -> Condition {
    let agents = instance.agents();
    let agent = |n: u64| &agents[n as usize % agents.len()];
    let name = agent(number).name.clone();
    let cells: Vec<Cell> = instance.grid().cells().map(|(cell, _)| cell).collect();
    let cell = cells[number as usize % cells.len()];
    let visit = |n: u64, cell: Cell| Visit {
        agent: agent(n).name.clone(),
        cell,
    };
    match number % 5 {
        0 => Condition::Visit {
            agent: Some(name),
            cell,
        },
        1 => Condition::Never {
            agent: name,
            act: Act::Visit(cell),
            times: Times::at(Some(number as u32 % 7)),
        },
        2 => Condition::Never {
            agent: name,
            act: Act::Wait {
                cell: None,
                steps: 1,
            },
            times: Times::default(),
        },
        3 => Condition::Before {
            first: visit(number, cell),
            second: visit(number + 1, agent(number).goal.unwrap()),
        },
        _ => Condition::Below {
            agent: Some(name),
            cost: Cost::Moves,
            limit: 3 + number as u32 % 3,
        },
    }
}

/// Formula and search are written apart, and agree on what a condition and rules leave.
#[test]
fn conditions_hold_beside_rules() {
    let budget = Budget {
        states: 60_000,
        ..Budget::default()
    };
    let (mut plans, mut none, mut later) = (0, 0, 0);
    for number in 0..scenes(280) {
        let scene = scene_with_rules(seed(66), number, &kinds(number)).to_string();
        let instance = native::read_instance(&scene).unwrap();
        let claim = Claim {
            condition: Some(condition(number, &instance)),
            ..Claim::default()
        };
        let in_time = claim.clone().within(Some(LAST));
        match exhaust_kind(&instance, &claim, &budget) {
            Exhausted::Stopped => {}
            Exhausted::NoPlan => {
                none += 1;
                assert!(!is_satisfiable(&instance, &in_time), "{claim:?} {scene}");
            }
            Exhausted::Plan(_) if is_satisfiable(&instance, &in_time) => plans += 1,
            Exhausted::Plan(_) => later += 1,
        }
    }
    println!("{plans} with plans, {none} without, {later} perhaps with later ones");
    assert!(plans > 100 && none > 40 && later * 10 < plans);
}

/// The certificate of what is answered about a scene.
fn certified(instance: &Instance) -> (giveway_proof::Bundle, giveway_proof::Report) {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    });
    let Response::Solved(answer) = serve(&request, &SilentHost) else {
        unreachable!("a solve request is solved")
    };
    let request = CertifyRequest::of_solved(instance.to_scene(), None, &answer);
    let bundle = export(&request.claims(instance), &Budget::default());
    let report = verify(&bundle, &Budget::default());
    (bundle, report)
}

#[test]
fn a_request_for_a_certificate_heeds_rules() {
    let scene = r#"{ "giveway": 1, "map": ["...."], "objective": ["makespan"],
        "zones": [{ "name": "end", "cells": [[3, 0]] }],
        "constraints": [{ "kind": "closed", "zone": "end", "to": 5, "name": "shut" }],
        "agents": [{ "name": "a", "start": [0, 0], "goal": [3, 0] }] }"#;
    let report = |scene: &str| {
        let instance = native::read_instance(scene).unwrap();
        let request = CertifyRequest {
            scene: instance.to_scene(),
            bounds: BTreeMap::from([(Cost::Makespan, 6)]),
            complete: true,
            ..CertifyRequest::default()
        };
        match serve(&Request::Certify(request), &SilentHost) {
            Response::Certified(report) => report,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(report(scene).certified, Certified::Proved);
    let off = scene.replace("\"to\": 5", "\"to\": 5, \"off\": true");
    assert_eq!(report(&off).certified, Certified::NotCertified);
    let shorter = scene.replace("\"to\": 5", "\"to\": 4");
    assert_eq!(report(&shorter).certified, Certified::NotCertified);
}

#[test]
fn the_known_answers_have_certificates() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/rules");
    let mut by: BTreeMap<&str, u32> = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let known: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        if known["status"] == "broken" {
            continue;
        }
        let what = path.display().to_string();
        let instance = native::read_instance(&known["instance"].to_string()).unwrap();
        let (bundle, report) = certified(&instance);
        assert!(report.accepted, "{what}: {:?}", report.reason);
        assert_ne!(
            report.certified,
            Certified::NotCertified,
            "{what}: {report:?}"
        );
        *by.entry(report.certified.words()).or_default() += 1;
        match (&known["status"], report.concluded) {
            (Value::String(status), Some(Conclusion::Best { within: None, .. }))
                if status == "optimal" =>
            {
                let manifest: Value = serde_json::from_slice(&bundle["manifest.json"]).unwrap();
                let objective = instance.in_force(instance.objective().clone());
                for cost in objective.costs() {
                    let told = &manifest["costs"][cost.name()];
                    let told = if told.is_null() {
                        &Value::from(0)
                    } else {
                        told
                    };
                    assert_eq!(known["costs"][cost.name()], *told, "{what}: {cost}");
                }
            }
            (Value::String(status), Some(Conclusion::NoPlan { .. })) if status == "impossible" => {}
            (status, concluded) => panic!("{what}: {status}, {concluded:?}"),
        }
        let readme = String::from_utf8(bundle["README.md"].clone()).unwrap();
        for rule in instance.constraints_in_force() {
            let line = format!("- Rule {}: ", rule.index);
            assert!(readme.contains(&line), "{what}: {readme}");
        }
    }
    println!("{by:?}");
    assert_eq!(by.values().sum::<u32>(), 57, "{by:?}");
}
