//! The JSON Schema accepts what is written and refuses what is broken.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

use giveway_model::check::check;
use giveway_model::compare::compare;
use giveway_model::format::{native, schema};
use giveway_model::{Agent, AtGoal, Battery, Cell, Cost, Objective, Plan, Rules, Scene};
use jsonschema::Validator;
use serde_json::{Value, json};

/// The schema of one definition.
fn definition(name: &str) -> Validator {
    let mut schema: Value = serde_json::from_str(schema()).unwrap();
    let object = schema.as_object_mut().unwrap();
    object.remove("anyOf");
    object.insert("$ref".into(), format!("#/$defs/{name}").into());
    jsonschema::draft202012::new(&schema).unwrap()
}

#[track_caller]
fn accepts(name: &str, value: &Value) {
    if let Err(error) = definition(name).validate(value) {
        panic!("{error} at {}", error.instance_path());
    }
    let whole: Value = serde_json::from_str(schema()).unwrap();
    assert!(jsonschema::draft202012::is_valid(&whole, value));
}

#[track_caller]
fn refuses(name: &str, value: &Value) {
    assert!(!definition(name).is_valid(value), "{value}");
}

/// Refuses a good value with one part set to another; `null` takes it away.
#[track_caller]
fn refuses_with(name: &str, good: &Value, pointer: &str, bad: Value) {
    let mut value = good.clone();
    let (object, key) = pointer.rsplit_once('/').unwrap();
    let object = value.pointer_mut(object).unwrap();
    if let Value::Array(list) = object {
        list[key.parse::<usize>().unwrap()] = bad;
    } else if bad.is_null() {
        object.as_object_mut().unwrap().remove(key).unwrap();
    } else {
        object[key] = bad;
    }
    refuses(name, &value);
}

fn scene() -> Scene {
    Scene {
        name: "warehouse".into(),
        map: vec!["..~".into(), "+#*".into()],
        rules: Rules {
            at_goal: AtGoal::Vanish,
            battery_floor: 2,
        },
        objective: Objective::new(vec![Cost::Waits, Cost::SumOfCosts]).unwrap(),
        agents: vec![Agent {
            name: "A1".into(),
            start: Cell::new(0, 0),
            goal: Some(Cell::new(2, 0)),
            waypoints: vec![Cell::new(0, 1)],
            battery: Some(Battery {
                capacity: 9,
                initial: 8,
            }),
            heading: None,
        }],
        ..Scene::default()
    }
}

fn written(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn the_schema_is_one() {
    let schema: Value = serde_json::from_str(schema()).unwrap();
    assert!(jsonschema::meta::is_valid(&schema));
}

#[test]
fn written_scenes_are_accepted() {
    accepts("instance", &written(&native::write_scene(&scene())));
    accepts("instance", &serde_json::to_value(scene()).unwrap());
    let plain = Scene {
        map: vec![".".into()],
        ..Scene::default()
    };
    accepts("instance", &written(&native::write_scene(&plain)));
}

#[test]
fn broken_scenes_are_refused() {
    let good = written(&native::write_scene(&scene()));
    let broken = [
        ("/giveway", json!(2)),
        ("/giveway", Value::Null),
        ("/map", Value::Null),
        ("/map", json!([])),
        ("/map/0", json!("..x")),
        ("/agents", Value::Null),
        ("/extra", json!(1)),
        ("/rules/at_goal", json!("sleep")),
        ("/rules/battery_floor", json!(-1)),
        ("/rules/extra", json!(1)),
        ("/objective", json!([])),
        ("/objective", json!(["moves", "moves"])),
        ("/objective/0", json!("speed")),
        ("/agents/0/name", json!("")),
        ("/agents/0/name", Value::Null),
        ("/agents/0/extra", json!(1)),
        ("/agents/0/start", json!([0])),
        ("/agents/0/start", json!([0, 0, 0])),
        ("/agents/0/start", json!([0, 1.5])),
        ("/agents/0/waypoints", json!([[0, 0], [0, 0]])),
        ("/agents/0/battery", json!([9, 9])),
        ("/agents/0/battery/initial", Value::Null),
    ];
    for (pointer, bad) in broken {
        refuses_with("instance", &good, pointer, bad);
    }
}

fn plan() -> Plan {
    let text = r#"{ "giveway": 1, "paths": { "A1": [[0, 0], null, [2, 0]] },
        "charges": { "A1": [0] }, "from": { "A1": 1 }, "until": { "A1": 4 } }"#;
    native::read_plan(text).unwrap()
}

#[test]
fn written_plans_are_accepted() {
    accepts("plan", &written(&native::write_plan(&plan())));
    accepts("plan", &serde_json::to_value(plan()).unwrap());
    accepts("plan", &written(&native::write_plan(&Plan::default())));
}

#[test]
fn broken_plans_are_refused() {
    let good = written(&native::write_plan(&plan()));
    for (pointer, bad) in [
        ("/paths", Value::Null),
        ("/paths", json!([])),
        ("/paths/A1/1", json!(3)),
        ("/charges/A1/0", json!(-1)),
        ("/from/A1", json!("now")),
        ("/extra", json!(1)),
    ] {
        refuses_with("plan", &good, pointer, bad);
    }
}

#[test]
fn check_results_are_accepted() {
    let instance = native::read_instance(
        r#"{ "giveway": 1, "map": ["..", ".."], "agents": [
            { "name": "A", "start": [0, 0], "goal": [1, 0] },
            { "name": "B", "start": [1, 0], "goal": [0, 0] },
            { "name": "C", "start": [0, 1], "goal": [0, 1] } ] }"#,
    )
    .unwrap();
    let plan = native::read_plan(
        r#"{ "giveway": 1, "charges": { "C": [0] },
             "paths": { "A": [[0, 0], [1, 0]], "B": [[1, 0], [0, 0]], "C": [[0, 1], [1, 0]] } }"#,
    )
    .unwrap();
    let report = check(&instance, &plan);
    let result = json!({
        "giveway": 1, "valid": report.is_valid(),
        "costs": report.costs, "violations": report.violations,
    });
    assert!(report.violations.iter().any(|v| v.cell.is_some()));
    assert!(report.violations.iter().any(|v| v.edge.is_some()));
    accepts("checkResult", &result);
    for (pointer, bad) in [
        ("/valid", json!(true)),
        ("/violations/0/rule", json!("speeding")),
        ("/violations/0/time", json!(-1)),
        ("/violations/0/agents", json!("A")),
        ("/violations/0/message", Value::Null),
        ("/costs/waits", Value::Null),
    ] {
        refuses_with("checkResult", &result, pointer, bad);
    }
}

#[test]
fn comparisons_are_accepted() {
    let instance = native::read_instance(
        r#"{ "giveway": 1, "map": ["..."], "agents": [
            { "name": "A", "start": [0, 0], "goal": [1, 0] },
            { "name": "B", "start": [2, 0], "goal": [2, 0] } ] }"#,
    )
    .unwrap();
    let plan = |text: &str| native::read_plan(text).unwrap();
    let one = plan(r#"{ "giveway": 1, "paths": { "A": [[0, 0], [1, 0]], "B": [[2, 0]] } }"#);
    let other = plan(r#"{ "giveway": 1, "paths": { "A": [[0, 0], null, [1, 0]] } }"#);
    for other in [&one, &other] {
        let compared = serde_json::to_value(compare(&instance, &one, other)).unwrap();
        accepts("compareResult", &compared);
        for (pointer, bad) in [
            ("/costs/0", json!(3)),
            ("/agents/0/difference", json!("gone")),
            ("/agents/0/arrivals", json!([1])),
            ("/agents/0/first", json!(true)),
            ("/extra", json!(1)),
        ] {
            refuses_with("compareResult", &compared, pointer, bad);
        }
    }
}

#[test]
fn audits_are_accepted() {
    let audit = json!({
        "giveway": 1, "file": "p.txt", "format": "paths.txt", "conventions": { "cells": ".." },
        "why": "..", "name": "", "agents": 8, "notes": [], "legal": true, "violations": [],
        "objective": ["makespan"], "costs": solved()["costs"],
        "claimed": { "sum-of-costs": 9 },
        "claims": [{ "cost": "sum-of-costs", "claimed": 9, "counted": 1, "definition": null }],
        "bounds": { "makespan": 1 }, "within": null, "complete": true, "status": "optimal",
        "gap": 0.0, "better": null, "better_costs": null, "search": "optimal",
        "stats": solved()["stats"],
    });
    accepts("auditResult", &audit);
    for (pointer, bad) in [
        ("/status", json!("illegal")),
        ("/legal", json!(false)),
        ("/gap", json!(0.1)),
        ("/gap", json!(-1)),
        ("/format", json!("csv")),
        ("/better_costs", solved()["costs"].clone()),
        ("/within", json!(4)),
        ("/claims/0/definition", json!("guess")),
        ("/search", json!("illegal")),
        ("/extra", json!(1)),
    ] {
        refuses_with("auditResult", &audit, pointer, bad);
    }
}

fn solved() -> Value {
    json!({
        "giveway": 1, "status": "optimal",
        "costs": { "makespan": 1, "sum-of-costs": 1, "charges": 0, "moves": 1, "waits": 0 },
        "bounds": { "makespan": 1, "sum-of-costs": 1 },
        "within": null, "complete": true,
        "plan": written(&native::write_plan(&plan())),
        "stats": { "cpu_seconds": 0.01, "solver_calls": 1, "variables": 9, "clauses": 30, "conflicts": 4 }
    })
}

#[test]
fn solve_results_are_accepted() {
    accepts("solveResult", &solved());
    let front = json!({
        "giveway": 1, "status": "feasible", "complete": false, "within": 40, "front": [solved()],
    });
    accepts("paretoResult", &front);
    for (pointer, bad) in [
        ("/status", json!("fine")),
        ("/plan", json!(false)),
        ("/within", json!(7)),
        ("/costs/moves", Value::Null),
        ("/bounds/speed", json!(1)),
        ("/status", json!("impossible")),
    ] {
        refuses_with("solveResult", &solved(), pointer, bad);
    }
}

#[test]
fn changes_are_accepted() {
    let changes = json!({ "giveway": 1, "changes": [
        { "at": 1, "change": "add-agent",
          "agent": { "name": "A3", "start": [2, 2], "goal": [1, 0] } },
        { "at": 2, "change": "move-obstacle", "from": [0, 0], "to": [1, 0] },
        { "at": 2, "change": "set-slow", "cells": [[0, 0], [1, 0]] },
        { "at": 3, "change": "delay-agent", "agent": "A3", "steps": 2 },
        { "at": 4, "change": "add-constraint", "constraint": { "kind": "gap", "steps": 1 } },
        { "at": 5, "change": "remove-constraint", "name": "room" },
        { "at": 5, "change": "remove-constraint", "index": 0 },
        { "at": 6, "change": "stop-agent", "agent": "A3" },
    ] });
    accepts("changes", &changes);
    for (pointer, bad) in [
        ("/changes/0/at", json!(-1)),
        ("/changes/0/agent", json!("A3")),
        ("/changes/1/change", json!("add-obstacle")),
        ("/changes/2/cells", Value::Null),
        ("/changes/3/steps", json!("two")),
        ("/changes/3/extra", json!(1)),
        ("/changes/4/constraint/steps", Value::Null),
        ("/changes/5/index", json!(1)),
        ("/changes/7/steps", json!(2)),
        ("/changes/6/index", json!("room")),
    ] {
        refuses_with("changes", &changes, pointer, bad);
    }
}

#[test]
fn explain_and_change_results_are_accepted() {
    let violation = json!({ "rule": "vertex", "agents": ["A1", "A2"], "cell": [2, 1], "time": 3,
                            "message": "..", "class": "collision" });
    let explained = json!({
        "giveway": 1, "question": { "kind": "wait", "agent": "A1", "at": [0, 0], "to": 3 },
        "verdict": "needless",
        "costs": solved()["costs"], "deltas": { "makespan": 0 }, "within": 40,
        "alternative": null, "witness": [violation], "closest": true, "complete": true,
        "core": { "facts": [{ "kind": "obstacle", "agents": [], "cell": [0, 0], "text": "..",
                               "helps": null }],
                  "minimal": true },
        "repairs": [{ "edits": [{ "edit": "vanish" }], "least": true, "proved": true, "costs": solved()["costs"],
                      "plan": solved()["plan"], "text": ".." }],
        "further_repairs": 0, "exhaustive": false, "words": "..",
    });
    accepts("explainResult", &explained);
    for (pointer, bad) in [
        ("/verdict", json!("perhaps")),
        ("/question/kind", json!("why")),
        ("/question/at", json!("here")),
        ("/question/extra", json!(1)),
        ("/deltas/makespan", json!("more")),
        ("/closest", Value::Null),
        ("/core/minimal", Value::Null),
        ("/core/facts/0/helps", json!("yes")),
        ("/core/facts/0/kind", json!("start")),
        ("/repairs/0/least", Value::Null),
        ("/repairs/0/edits/0/edit", json!("fly")),
        ("/extra", json!(1)),
    ] {
        refuses_with("explainResult", &explained, pointer, bad);
    }
    let mut method = solved();
    for key in ["kept", "retimed", "rerouted", "added", "freed"] {
        method[key] = json!(["A1"]);
    }
    method["cause"] = Value::Null;
    let change = json!({
        "giveway": 1, "methods": { "tunnel=2": method }, "adopted": null,
        "history": [{ "at": 1, "methods": {}, "adopted": "revise" }],
    });
    accepts("changeResult", &change);
    refuses_with("changeResult", &change, "/methods/guess", method);
}
