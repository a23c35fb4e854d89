//! Limits of work: the same request gets the same answer, wherever they end it and
//! whatever a clock says.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::cell::RefCell;
use std::collections::BTreeSet;

use fastrand::Rng;
use giveway_model::{Cost, Instance};
use giveway_solve::{
    Ended, Host, Progress, Request, Response, SilentHost, SolveAnswer, Status, serve,
};
use giveway_tests::{known, random};
use serde_json::{Value, json};

/// A clock that jumps to and fro, by years.
struct WildClock(RefCell<Rng>);

impl WildClock {
    fn new(seed: u64) -> Self {
        Self(RefCell::new(Rng::with_seed(seed)))
    }
}

impl Host for WildClock {
    fn wall_seconds(&self) -> f64 {
        (self.0.borrow_mut().f64() - 0.5) * 1e9
    }

    fn progress(&self, _: &Progress) {}
}

/// A request of a kind with more than a scene, with a limit of work.
fn request(kind: &str, instance: &Instance, work: u64, more: &Value) -> Request {
    let mut request = json!({
        "request": kind,
        "scene": instance.to_scene(),
        "limits": { "work": work },
    });
    for (key, value) in more.as_object().unwrap() {
        request[key] = value.clone();
    }
    serde_json::from_value(request).unwrap()
}

/// The response without what a clock told.
fn told(request: &Request, host: &dyn Host) -> Value {
    let mut response = serde_json::to_value(serve(request, host)).unwrap();
    forget_seconds(&mut response);
    response
}

fn forget_seconds(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            fields.remove("cpu_seconds");
            fields.values_mut().for_each(forget_seconds);
        }
        Value::Array(items) => items.iter_mut().for_each(forget_seconds),
        _ => {}
    }
}

/// Holds that no clock changes an answer, wherever the work ends.
fn hold(kind: &str, instance: &Instance, works: &[u64], more: &Value) {
    for &work in works {
        let request = request(kind, instance, work, more);
        let calm = told(&request, &SilentHost);
        assert_ne!(calm["response"], "refused", "{calm}");
        for seed in 0..2 {
            let wild = told(&request, &WildClock::new(seed));
            assert_eq!(calm, wild, "{kind}, {work} units of work, clock {seed}");
        }
    }
}

const WORKS: [u64; 6] = [0, 1_000, 10_000, 50_000, 200_000, 600_000];

#[test]
fn no_clock_changes_where_a_crowd_is_cut_short() {
    // While tables are made, in the first plan, in local search, in the proof.
    let crowd = known::scenario("random-32-32-20", 250);
    hold(
        "solve",
        &crowd,
        &[10_000, 300_000, 1_000_000, 2_500_000],
        &json!({}),
    );
}

#[test]
fn no_clock_changes_where_a_proof_is_cut_short() {
    for (name, objective) in [
        ("A05", "sum-of-costs"),
        ("A05", "makespan"),
        ("A03", "charges"),
        ("B05", "sum-of-costs"),
    ] {
        hold(
            "solve",
            &known::mmapf(name),
            &WORKS,
            &json!({ "objective": [objective] }),
        );
    }
}

#[test]
fn no_clock_changes_where_joint_states_fronts_and_traces_are_cut_short() {
    for number in 0..10 {
        let small = random::crowded(3, number);
        hold(
            "solve",
            &small,
            &[500, 5_000, 50_000],
            &json!({ "trace": true }),
        );
    }
    let warehouse = known::instance("seed/warehouse.json");
    let front = json!({ "pareto": true, "objective": ["makespan", "charges"] });
    hold("solve", &warehouse, &WORKS, &front);
}

#[test]
fn no_clock_changes_where_other_questions_are_cut_short() {
    let warehouse = known::instance("seed/warehouse.json");
    let plan = serde_json::to_value(known::plan("seed/warehouse.plan.json")).unwrap();
    let question = json!({ "kind": "charge", "agent": "A2", "at": [6, 2] });
    let works = &WORKS[2..5];
    hold(
        "explain",
        &warehouse,
        works,
        &json!({ "plan": plan, "question": question }),
    );
    hold("freedom", &warehouse, works, &json!({ "plan": plan }));
    hold("audit", &warehouse, works, &json!({ "plan": plan }));
    let changes = json!({ "giveway": 1, "changes": [
        { "at": 5, "change": "add-obstacle", "cell": [4, 0] } ] });
    let change = json!({ "plan": plan, "changes": changes, "methods": ["revise", "replan"] });
    hold("change", &warehouse, works, &change);
    let crowd = known::scenario("random-32-32-20", 30);
    for planner in ["prioritised", "cbs", "pibt", "lacam", "lns"] {
        hold(
            "plan",
            &crowd,
            works,
            &json!({ "planner": planner, "objective": ["sum-of-costs"] }),
        );
    }
}

fn solve(instance: &Instance, work: u64) -> SolveAnswer {
    let objective = json!({ "objective": ["sum-of-costs"] });
    match serve(&request("solve", instance, work, &objective), &SilentHost) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

#[test]
fn more_work_knows_more() {
    let mut ends = BTreeSet::new();
    for name in ["A03", "A05", "B05", "B19"] {
        let instance = known::mmapf(name);
        let (mut bound, mut best, mut proved) = (0, u32::MAX, false);
        for work in (0..16).map(|doubled| 250 << doubled) {
            let answer = solve(&instance, work);
            let has = answer.costs.map_or(u32::MAX, |costs| costs.sum_of_costs);
            let least = answer.bounds.get(&Cost::SumOfCosts).copied().unwrap_or(0);
            assert!(bound <= least && has <= best, "{name}, {work}: {answer:?}");
            assert!(
                !proved || answer.status == Status::Optimal,
                "{name}, {work}"
            );
            let is_proof = answer.ended == Some(Ended::Proof);
            assert_eq!(is_proof, answer.status == Status::Optimal, "{name}, {work}");
            assert!(
                is_proof || answer.ended == Some(Ended::Work),
                "{name}, {work}"
            );
            assert_eq!(
                is_proof,
                answer.stats.work <= work,
                "{name}: {}",
                answer.stats.work
            );
            ends.insert((
                answer.status == Status::Optimal,
                answer.plan.is_some(),
                least > 0,
            ));
            (bound, best, proved) = (least, has, is_proof);
        }
    }
    // Without a plan, with one, with a bound, with a proof.
    assert!(ends.len() >= 3, "{ends:?}");
}

#[test]
fn a_search_ends_soon_after_its_work() {
    // No single step between two looks is long: units count what takes time.
    let crowd = known::scenario("random-32-32-20", 250);
    for work in [300_000, 1_000_000] {
        let answer = solve(&crowd, work);
        assert_eq!(answer.ended, Some(Ended::Work));
        assert!(
            answer.stats.work < work + work / 10,
            "{}",
            answer.stats.work
        );
    }
}
