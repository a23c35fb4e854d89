//! Rules of a scene's own with extreme numbers and in large amounts: each request ends in
//! time, with an answer or a refusal that names a place, and within the memory of a small
//! machine.
//!
//! `GIVEWAY_HOSTILE_TIMES=1` prints how long each request took.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

mod many;

use std::{fs, slice};

use giveway_model::change::Changes;
use giveway_model::format::native;
use giveway_model::{Constraint, Cost, Fault, Plan, Question, Scene};
use giveway_solve::audit::AuditRequest;
use giveway_solve::change::{ChangeRequest, Method};
use giveway_solve::explain::ExplainRequest;
use giveway_solve::freedom::FreedomRequest;
use giveway_solve::plan::{PlanRequest, Planner};
use giveway_solve::price::PriceRequest;
use giveway_solve::together::TogetherRequest;
use giveway_solve::trace::AgentLimit;
use giveway_solve::{
    CertifyRequest, CheckRequest, Host, Limits, Progress, Refusal, Request, Response, SolveAnswer,
    SolveRequest, serve,
};
use serde_json::{Value, json};

use std::time::SystemTime;

/// The limit of each request, in seconds.
const SECONDS: f64 = 0.2;

/// How many seconds longer than its limit a request may take in the dev profile, on a machine
/// that is three times as slow at times: what does not end at all is found.
const GRACE: f64 = 15.0;

/// The largest number of a rule.
const MOST: u32 = 1_000_000;

/// The side of the usual map.
const SIDE: usize = 6;

/// A clock of the thread's CPU seconds where the system tells them, so that a busy machine
/// changes nothing; of wall seconds elsewhere.
struct Clock(SystemTime);

impl Host for Clock {
    fn wall_seconds(&self) -> f64 {
        let times = fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
        let nanoseconds = times
            .split(' ')
            .next()
            .and_then(|it| it.parse::<f64>().ok());
        let passed = || self.0.elapsed().map_or(0.0, |passed| passed.as_secs_f64());
        nanoseconds.map_or_else(passed, |it| it / 1e9)
    }

    fn progress(&self, _: &Progress) {}
}

fn limits() -> Limits {
    Limits {
        seconds: Some(SECONDS),
        ..Limits::default()
    }
}

/// Serves a request within its time; `what` is told where it is late.
fn ask(what: &str, part: &str, request: &Request) -> Response {
    // Each method has the limit at each time.
    let parts = if part == "change" { 4.0 } else { 1.0 };
    let clock = Clock(SystemTime::now());
    let begin = clock.wall_seconds();
    let response = serve(request, &clock);
    let seconds = clock.wall_seconds() - begin;
    if std::env::var_os("GIVEWAY_HOSTILE_TIMES").is_some() {
        let kind = serde_json::to_value(&response).unwrap();
        let kind = [&kind["response"], &kind["status"], &kind["refusal"]].map(Value::to_string);
        println!("{seconds:7.2} s {what}: {part}: {}", kind.join(" "));
    }
    if std::env::var_os("GIVEWAY_HOSTILE_TIMES").is_some() {
        return response;
    }
    assert!(
        seconds < parts * SECONDS + GRACE,
        "{what}: {part} took {seconds} s"
    );
    if let Response::Refused(Refusal::Scene { faults } | Refusal::Changes { faults }) = &response {
        assert!(faults.iter().all(has_place), "{what}: {part}: {faults:?}");
    }
    response
}

fn has_place(fault: &Fault) -> bool {
    !fault.place.is_empty()
}

/// A scene of four robots on an open map, with zones and rules.
fn scene(zones: &Value, rules: &[Value]) -> Value {
    let last = SIDE - 1;
    let corners = [[0, 0], [last, 0], [0, last], [last, last]];
    let agents: Vec<Value> = (0..4)
        .map(|i| {
            json!({ "name": format!("A{i}"), "start": corners[i], "goal": corners[3 - i],
                    "heading": "east" })
        })
        .collect();
    json!({ "giveway": 1, "map": vec![".".repeat(SIDE); SIDE], "agents": agents,
            "zones": zones, "constraints": rules })
}

/// The usual zones: some cells in the middle, and the goal of the first robot.
fn zones() -> Value {
    json!([{ "name": "middle", "rect": [2, 2, 3, 3] },
           { "name": "goal", "cells": [[SIDE - 1, SIDE - 1]] },
           { "name": "all", "rect": [0, 0, SIDE - 1, SIDE - 1] }])
}

fn read(scene: &Value) -> Result<Scene, Fault> {
    native::read_scene(&scene.to_string())
}

fn solve(what: &str, scene: &Scene) -> Option<SolveAnswer> {
    let request = SolveRequest {
        scene: scene.clone(),
        limits: limits(),
        ..SolveRequest::default()
    };
    match ask(what, "solve", &Request::Solve(request)) {
        Response::Solved(answer) => Some(answer),
        Response::Refused(_) => None,
        other => panic!("{what}: {other:?}"),
    }
}

/// The best plan of the usual scene without rules.
fn usual_plan() -> (Scene, Plan) {
    let scene = read(&scene(&zones(), &[])).unwrap();
    let plan = solve("no rule", &scene).unwrap().plan.unwrap();
    (scene, plan)
}

/// Solves and certifies a scene with rules, and asks every planner for a plan.
fn ask_search(what: &str, scene: &Scene) {
    if let Some(answer) = solve(what, scene) {
        let mut certify = CertifyRequest::of_solved(scene.clone(), None, &answer);
        certify.limits = limits();
        ask(what, "certify", &Request::Certify(certify));
    }
    for planner in Planner::ALL {
        let mut request = PlanRequest::new(scene.clone(), planner);
        request.limits = limits();
        ask(what, &planner.to_string(), &Request::Plan(request));
    }
}

/// Asks everything of a scene with rules, of which one plan without them is known.
fn ask_all(what: &str, scene: &Scene, plan: &Plan) {
    ask_search(what, scene);
    let own = || scene.clone();
    let (objective, within) = (None, None);
    let requests = [
        Request::Check(CheckRequest {
            scene: own(),
            plan: plan.clone(),
            changes: None,
        }),
        Request::Price(PriceRequest {
            scene: own(),
            limits: limits(),
            ..PriceRequest::default()
        }),
        Request::Audit(AuditRequest {
            scene: own(),
            plan: plan.clone(),
            objective: None,
            within,
            limits: limits(),
        }),
        Request::Freedom(FreedomRequest {
            scene: own(),
            plan: None,
            objective: None,
            within,
            proved: None,
            parts: Vec::new(),
            count: None,
            limits: limits(),
        }),
        Request::Together(TogetherRequest {
            scene: own(),
            cost: Cost::Makespan,
            agents: ["A0", "A1"]
                .map(|agent| AgentLimit {
                    agent: agent.to_owned(),
                    least: 0,
                    at_most: 12,
                })
                .to_vec(),
            more: None,
            within,
            limits: limits(),
        }),
        Request::Explain(ExplainRequest {
            scene: own(),
            plan: None,
            changes: None,
            at: None,
            question: Question::Makespan,
            objective,
            within,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: limits(),
        }),
        Request::Explain(ExplainRequest {
            scene: own(),
            plan: None,
            changes: None,
            at: None,
            question: Question::Unsolvable,
            objective: None,
            within,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: limits(),
        }),
    ];
    let parts = [
        "check",
        "price",
        "audit",
        "freedom",
        "together",
        "makespan",
        "unsolvable",
    ];
    for (part, request) in parts.iter().zip(requests) {
        ask(what, part, &request);
    }
}

/// Asks why a plan does not keep a rule, and adds the rule while the plan runs.
fn ask_one(what: &str, rule: &Constraint, (scene, plan): &(Scene, Plan)) {
    let request = ExplainRequest {
        scene: scene.clone(),
        plan: Some(plan.clone()),
        changes: None,
        at: None,
        question: Question::Rule {
            rule: Box::new(rule.clone()),
        },
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: limits(),
    };
    ask(what, "rule", &Request::Explain(request));
    let changes = json!({ "giveway": 1, "changes": [
        { "at": 2, "change": "add-constraint", "constraint": rule },
        { "at": 3, "change": "delay-agent", "agent": "A0", "steps": 2 }] });
    let changes: Changes = serde_json::from_value(changes).unwrap();
    let request = ChangeRequest {
        scene: scene.clone(),
        plan: plan.clone(),
        changes,
        since: None,
        methods: vec![Method::Revise, Method::Replan],
        objective: None,
        within: None,
        limits: limits(),
    };
    ask(what, "change", &Request::Change(request));
}

/// The most memory that the process had so far, where the system tells it.
fn assert_little_memory() {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes: Option<u64> =
        peak.and_then(|text| text.trim().strip_suffix("kB")?.trim().parse().ok());
    if let Some(kilobytes) = kilobytes {
        println!("{} MB at most", kilobytes / 1000);
        assert!(kilobytes < 2_000_000, "{kilobytes} kB");
    }
}

/// Rules of each kind whose numbers are the largest, or nearly.
fn largest() -> Vec<Value> {
    let ends = json!([SIDE - 1, SIDE - 1]);
    vec![
        json!({ "kind": "capacity", "zone": "middle", "most": MOST }),
        json!({ "kind": "capacity", "zone": "all", "most": 0, "from": MOST, "to": MOST }),
        json!({ "kind": "capacity", "zone": "goal", "most": 0, "to": MOST - 1 }),
        json!({ "kind": "capacity", "zone": "middle", "most": 1, "to": MOST - 1 }),
        json!({ "kind": "capacity", "zone": "all", "most": 3, "from": MOST - 2, "to": MOST - 1 }),
        json!({ "kind": "closed", "zone": "goal", "to": MOST - 1 }),
        json!({ "kind": "closed", "zone": "goal", "from": 9, "to": MOST - 1 }),
        json!({ "kind": "closed", "zone": "middle", "from": MOST - 1 }),
        json!({ "kind": "closed", "zone": "goal", "from": MOST }),
        json!({ "kind": "closed", "zone": "all", "from": MOST - 1, "to": MOST - 1 }),
        json!({ "kind": "gap", "steps": MOST }),
        json!({ "kind": "gap", "steps": 1000, "agents": ["A0", "A3"] }),
        json!({ "kind": "apart", "distance": MOST }),
        json!({ "kind": "apart", "distance": MOST, "from": MOST - 1, "to": MOST - 1 }),
        json!({ "kind": "apart", "distance": 3, "to": MOST - 1 }),
        json!({ "kind": "visit", "cell": [2, 2], "stay": MOST }),
        json!({ "kind": "visit", "cell": [2, 2], "stay": 1000 }),
        json!({ "kind": "visit", "cell": [2, 2], "agents": ["A0"], "stay": MOST - 2 }),
        json!({ "kind": "visit", "cell": [2, 2], "agents": ["A0"], "from": MOST - 1 }),
        json!({ "kind": "visit", "cell": ends, "stay": MOST, "agents": ["A0"] }),
        json!({ "kind": "visit", "cell": ends, "from": MOST, "to": MOST, "agents": ["A0"] }),
        json!({ "kind": "arrive", "from": MOST }),
        json!({ "kind": "arrive", "from": MOST - 1, "by": MOST - 1 }),
        json!({ "kind": "arrive", "by": MOST }),
        json!({ "kind": "arrive", "by": MOST - 1 }),
        json!({ "kind": "arrive", "by": 0 }),
        json!({ "kind": "arrive", "by": 0, "weight": MOST }),
        json!({ "kind": "arrive", "by": MOST - 1, "weight": MOST }),
        json!({ "kind": "depart", "from": MOST }),
        json!({ "kind": "depart", "from": MOST - 1, "agents": ["A0"] }),
        json!({ "kind": "no-waiting", "zone": "all", "most": MOST }),
        json!({ "kind": "turns", "quarter": MOST }),
        json!({ "kind": "turns", "quarter": 5000, "agents": ["A1"] }),
        json!({ "kind": "avoid", "zone": "all", "weight": MOST }),
    ]
}

#[test]
fn the_largest_numbers_end_in_time() {
    let usual = usual_plan();
    for rule in largest() {
        let what = rule.to_string();
        let scene = read(&scene(&zones(), slice::from_ref(&rule))).unwrap();
        ask_all(&what, &scene, &usual.1);
        ask_one(&what, &serde_json::from_value(rule).unwrap(), &usual);
    }
    assert_little_memory();
}

#[test]
fn numbers_out_of_range_are_refused_with_their_place() {
    let numbers = [
        "-1",
        "-0.5",
        "0.5",
        "1e400",
        "1000001",
        "4294967295",
        "4294967296",
        "9007199254740992",
        "18446744073709551616",
    ];
    let mut seen = 0;
    for rule in largest() {
        for (key, value) in rule.as_object().unwrap() {
            if !value.is_u64() {
                continue;
            }
            for number in numbers {
                let mut rule = rule.clone();
                rule[key] = json!("@");
                let text = scene(&zones(), slice::from_ref(&rule)).to_string();
                let text = text.replace("\"@\"", number);
                let faults = native::read_instance(&text).unwrap_err();
                let place = format!("constraints[0].{key}");
                let is_there = |fault: &Fault| fault.place == place || number.contains('e');
                assert!(faults.iter().any(is_there), "{number}: {faults:?}: {text}");
                assert!(faults.iter().all(|it| it.line.is_some()), "{faults:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 400, "{seen}");
    // Windows that end before they begin, and stays that are longer than theirs.
    for rule in [
        r#"{ "kind": "closed", "zone": "all", "from": 5, "to": 4 }"#,
        r#"{ "kind": "apart", "distance": 2, "from": 1000000, "to": 0 }"#,
        r#"{ "kind": "arrive", "from": 1000000, "by": 999999 }"#,
        r#"{ "kind": "visit", "cell": [0, 0], "stay": 2, "from": 3, "to": 4 }"#,
        r#"{ "kind": "visit", "cell": [0, 0], "stay": 1000000, "to": 999999 }"#,
    ] {
        let rule: Value = serde_json::from_str(rule).unwrap();
        let faults = native::read_instance(&scene(&zones(), &[rule]).to_string()).unwrap_err();
        assert!(faults[0].place.starts_with("constraints[0]."), "{faults:?}");
    }
}
