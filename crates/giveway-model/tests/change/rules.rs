//! Rules of a scene's own while a plan runs: what is refused, and what the judge says.

use giveway_model::change::History;
use giveway_model::check::{Report, check_changes};
use giveway_model::format::native::{read_changes, read_instance, read_plan};
use giveway_model::snapshot::Snapshot;
use giveway_model::{Fault, Plan};
use serde_json::{Value, json};

/// A corridor of six cells with two robots on it, a zone in its middle, and a plan: A goes
/// from the left to (3, 0), B stays at (5, 0).
fn scene(constraints: &Value) -> Value {
    json!({
        "giveway": 1, "map": ["......", "......"],
        "agents": [{ "name": "A", "start": [0, 0], "goal": [3, 0] },
                   { "name": "B", "start": [5, 0], "goal": [5, 0] }],
        "zones": [{ "name": "middle", "cells": [[2, 0], [3, 0]] }],
        "constraints": constraints,
    })
}

fn plan(a: &Value) -> Plan {
    let text = json!({ "giveway": 1, "paths": { "A": a, "B": [[5, 0]] } });
    read_plan(&text.to_string()).unwrap()
}

fn judge(constraints: &Value, changes: &Value, a: &Value) -> Result<Report, Vec<Fault>> {
    let instance = read_instance(&scene(constraints).to_string()).unwrap();
    let text = json!({ "giveway": 1, "changes": changes });
    let changes = read_changes(&text.to_string()).unwrap();
    check_changes(&instance, &changes, &plan(a))
}

/// The times of the violations, each with the number of the rule.
fn broken(constraints: &Value, changes: &Value, a: &Value) -> Vec<(u32, u32)> {
    let report = judge(constraints, changes, a).unwrap();
    let violations = report.violations.iter();
    violations
        .map(|it| (it.time, it.broken.as_ref().unwrap().index))
        .collect()
}

fn add(at: u32, constraint: &Value) -> Value {
    json!([{ "at": at, "change": "add-constraint", "constraint": constraint }])
}

fn straight() -> Value {
    json!([[0, 0], [1, 0], [2, 0], [3, 0]])
}

#[test]
fn a_closed_zone_does_not_count_who_is_in_it() {
    let closed = json!({ "kind": "closed", "zone": "middle" });
    // It is there already, and may stay for good.
    assert_eq!(broken(&json!([]), &add(2, &closed), &straight()), []);
    // It comes later.
    let late = broken(&json!([]), &add(1, &closed), &straight());
    assert_eq!(late, [(2, 0), (3, 0)]);
    // It has left, and comes back.
    let back = json!([[0, 0], [1, 0], [2, 0], [2, 1], [3, 1], [3, 0]]);
    assert_eq!(broken(&json!([]), &add(2, &closed), &back), [(5, 0)]);
    // One of the scene counts whoever is there.
    let own = json!({ "kind": "closed", "zone": "middle", "from": 3 });
    assert_eq!(broken(&json!([own]), &json!([]), &straight()), [(3, 0)]);
}

#[test]
fn a_breakdown_keeps_a_robot_in_a_zone() {
    let closed = json!([{ "kind": "closed", "zone": "middle", "from": 3, "to": 3 }]);
    let path = json!([[0, 0], [1, 0], [2, 0], [2, 0], [2, 0], [3, 0]]);
    assert_eq!(broken(&closed, &json!([]), &path), [(3, 0)]);
    let delay = json!([{ "at": 2, "change": "delay-agent", "agent": "A", "steps": 2 }]);
    assert_eq!(broken(&closed, &delay, &path), []);
    // Waits of a breakdown do not count.
    let waits = json!([{ "kind": "no-waiting", "zone": "middle" }]);
    assert_eq!(broken(&waits, &json!([]), &path), [(2, 0), (3, 0)]);
    assert_eq!(broken(&waits, &delay, &path), []);
}

#[test]
fn waits_count_from_when_a_rule_begins() {
    let waits = json!({ "kind": "no-waiting", "zone": "middle", "most": 1 });
    let path = json!([[0, 0], [1, 0], [2, 0], [2, 0], [2, 0], [2, 0], [3, 0]]);
    assert_eq!(broken(&json!([waits]), &json!([]), &path), [(3, 0), (4, 0)]);
    assert_eq!(broken(&json!([]), &add(3, &waits), &path), [(4, 0)]);
    assert_eq!(broken(&json!([]), &add(4, &waits), &path), []);
}

#[test]
fn what_was_done_before_counts() {
    let sequence = json!({ "kind": "sequence", "agent": "A", "cells": [[1, 0], [3, 0]] });
    assert_eq!(broken(&json!([]), &add(2, &sequence), &straight()), []);
    let other = json!({ "kind": "sequence", "agent": "A", "cells": [[3, 0], [1, 0]] });
    // What was never done is told at the arrival, or when the rule begins.
    assert_eq!(broken(&json!([]), &add(2, &other), &straight()), [(3, 0)]);
    assert_eq!(broken(&json!([]), &add(7, &other), &straight()), [(7, 0)]);
    let visit = json!({ "kind": "visit", "cell": [1, 0], "agents": ["A"] });
    assert_eq!(broken(&json!([]), &add(2, &visit), &straight()), []);
    // B was there before, so A may be.
    let before = json!({ "kind": "before", "first": { "agent": "B", "cell": [5, 0] },
                         "second": { "agent": "A", "cell": [3, 0] } });
    assert_eq!(broken(&json!([]), &add(2, &before), &straight()), []);
    // A turned back without the time for it.
    let turns = json!({ "kind": "turns", "quarter": 1 });
    let back = json!([[0, 0], [1, 0], [0, 0], [1, 0], [2, 0], [3, 0]]);
    assert_eq!(broken(&json!([]), &add(1, &turns), &back), [(1, 0), (2, 0)]);
    assert_eq!(broken(&json!([]), &add(2, &turns), &back), [(2, 0)]);
    assert_eq!(broken(&json!([]), &add(3, &turns), &back), []);
}

#[test]
fn a_rule_that_is_removed_is_judged_before() {
    let late = json!({ "kind": "arrive", "by": 2, "agents": ["A"] });
    let remove = |at: u32| json!([{ "at": at, "change": "remove-constraint", "index": 0 }]);
    assert_eq!(broken(&json!([late]), &json!([]), &straight()), [(3, 0)]);
    assert_eq!(broken(&json!([late]), &remove(4), &straight()), [(3, 0)]);
    assert_eq!(broken(&json!([late]), &remove(3), &straight()), []);
    // What it has not done yet, it could have done.
    let visit = json!({ "kind": "visit", "cell": [0, 1], "agents": ["A"] });
    assert_eq!(broken(&json!([visit]), &remove(9), &straight()), []);
    let closed = json!({ "kind": "closed", "zone": "middle" });
    assert_eq!(broken(&json!([closed]), &remove(3), &straight()), [(2, 0)]);
}

#[test]
fn a_penalty_counts_while_its_rule_is_there() {
    let avoid = json!({ "kind": "avoid", "zone": "middle", "weight": 5 });
    let path = json!([[0, 0], [1, 0], [2, 0], [2, 0], [2, 0], [3, 0]]);
    let penalty = |constraints: &Value, changes: &Value| {
        let report = judge(constraints, changes, &path).unwrap();
        report.costs.unwrap().penalty
    };
    assert_eq!(penalty(&json!([avoid]), &json!([])), 15);
    assert_eq!(penalty(&json!([]), &add(3, &avoid)), 10);
    let remove = json!([{ "at": 4, "change": "remove-constraint", "index": 0 }]);
    assert_eq!(penalty(&json!([avoid]), &remove), 10);
}

#[test]
fn a_rule_goes_with_its_last_robot() {
    let gap = json!([{ "kind": "gap", "steps": 2 }]);
    let text = json!({ "giveway": 1, "until": { "B": 2 }, "paths": {
        "A": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]], "B": [[5, 0], [5, 0]] } });
    let mut scene = scene(&gap);
    scene["agents"][0]["goal"] = json!([5, 0]);
    scene["agents"][1]["goal"] = json!([5, 1]);
    let instance = read_instance(&scene.to_string()).unwrap();
    let changes = json!({ "giveway": 1, "changes":
        [{ "at": 2, "change": "remove-agent", "agent": "B" }] });
    let changes = read_changes(&changes.to_string()).unwrap();
    let report = check_changes(&instance, &changes, &read_plan(&text.to_string()).unwrap());
    assert!(report.unwrap().is_valid());
    // Its last cell stays closed for two steps.
    let soon = json!({ "giveway": 1, "until": { "B": 4 }, "paths": {
        "A": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]],
        "B": [[5, 0], [5, 0], [5, 0], [5, 0]] } });
    let changes = json!({ "giveway": 1, "changes":
        [{ "at": 4, "change": "remove-agent", "agent": "B" }] });
    let changes = read_changes(&changes.to_string()).unwrap();
    let report = check_changes(&instance, &changes, &read_plan(&soon.to_string()).unwrap());
    let violations = report.unwrap().violations;
    assert_eq!(violations.len(), 1, "{violations:?}");
    assert_eq!(violations[0].time, 5);
}

/// The place of the first fault of some changes.
fn refused(constraints: &Value, changes: &Value) -> String {
    let faults = judge(constraints, changes, &straight()).unwrap_err();
    faults[0].place.clone()
}

#[test]
fn faults_of_rules_name_their_place() {
    let gap = |name: &str| json!({ "kind": "gap", "steps": 1, "name": name });
    for (constraint, place) in [
        (json!({ "kind": "closed", "zone": "far" }), "zone"),
        (json!({ "kind": "gap", "steps": 0 }), "steps"),
        (
            json!({ "kind": "gap", "steps": 1, "agents": ["A", "C"] }),
            "agents[1]",
        ),
        (json!({ "kind": "visit", "cell": [9, 9] }), "cell"),
        (gap("room"), "name"),
        (gap(""), "name"),
    ] {
        let found = refused(&json!([gap("room")]), &add(1, &constraint));
        assert_eq!(found, format!("changes[0].constraint.{place}"));
    }
    for which in [json!({ "index": 1 }), json!({ "name": "space" })] {
        let mut change = json!({ "at": 1, "change": "remove-constraint" });
        let which = which.as_object().unwrap().clone();
        change.as_object_mut().unwrap().extend(which);
        assert_eq!(
            refused(&json!([gap("room")]), &json!([change])),
            "changes[0]"
        );
    }
    // Removed twice; and a new one may have the name.
    let remove = |at: u32| json!({ "at": at, "change": "remove-constraint", "name": "room" });
    assert_eq!(
        refused(&json!([gap("room")]), &json!([remove(1), remove(2)])),
        "changes[1]"
    );
    let again = json!({ "at": 1, "change": "add-constraint", "constraint": gap("room") });
    let both = json!([again, remove(1)]);
    assert!(judge(&json!([gap("room")]), &both, &straight()).is_ok());
}

#[test]
fn the_rest_has_what_is_left_of_the_rules() {
    let rules = json!([
        { "kind": "sequence", "agent": "A", "cells": [[1, 0], [3, 0]] },
        { "kind": "visit", "cell": [1, 0], "agents": ["A"] },
        { "kind": "closed", "zone": "middle", "from": 9, "to": 12, "agents": ["B"] },
        { "kind": "depart", "from": 1, "agents": ["B"] },
        { "kind": "arrive", "from": 3, "by": 8, "agents": ["A"] },
    ]);
    let instance = read_instance(&scene(&rules).to_string()).unwrap();
    let plan = plan(&straight());
    let history = History::new(&instance);
    let snapshot = Snapshot::new(2, &instance, (&history, &history), &plan);
    let rest = serde_json::to_value(snapshot.instance.constraints()).unwrap();
    assert_eq!(rest[0]["cells"], json!([[3, 0]]));
    assert_eq!(rest[1]["off"], true);
    assert_eq!((&rest[2]["from"], &rest[2]["to"]), (&json!(7), &json!(10)));
    assert_eq!(rest[3]["off"], true);
    assert_eq!((&rest[4]["from"], &rest[4]["by"]), (&json!(1), &json!(6)));
    assert!(snapshot.check(&snapshot.rest()).is_valid());
}
