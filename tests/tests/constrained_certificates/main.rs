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

mod requests;
mod states;

use std::collections::BTreeMap;

use giveway_model::check::check;
use giveway_model::format::native;
use giveway_model::{Cost, Instance, Plan};
use giveway_proof::{Budget, Claim, Outcome, plain, prove};
use giveway_solve::{
    Limits, Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, serve,
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
