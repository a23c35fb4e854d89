//! Rules in large amounts.

use std::slice;

use giveway_model::format::native;
use serde_json::{Value, json};

use super::{
    MOST, SIDE, ask_all, ask_one, ask_search, assert_little_memory, read, scene, usual_plan, zones,
};

/// A rule of each kind that is mostly kept; `number` tells some of them apart.
fn common(kind: &str, number: u32) -> Value {
    let at = |x: u32| json!([x % SIDE as u32, x / SIDE as u32 % SIDE as u32]);
    let mut rule = match kind {
        "capacity" => json!({ "zone": "middle", "most": number % 3 + 1, "from": number % 50 }),
        "closed" => json!({ "zone": "middle", "from": number + 4, "to": number + 5 }),
        "one-way" => json!({ "lane": [[2, 0], [3, 0], [4, 0]] }),
        "gap" => json!({ "steps": number % 3 + 1 }),
        "apart" => json!({ "distance": 2, "from": number, "to": number + 1 }),
        "sequence" => json!({ "agent": format!("A{}", number % 4), "cells": [at(number)] }),
        "visit" => json!({ "cell": at(number), "agents": [format!("A{}", number % 4)] }),
        "arrive" => json!({ "from": number % 20, "by": number + 500 }),
        "late" => json!({ "by": number % 40, "weight": MOST - number }),
        "depart" => json!({ "from": number % 9 }),
        "before" => json!({ "first": { "agent": "A0", "cell": [1, 0] },
                            "second": { "agent": "A3", "cell": at(number) } }),
        "no-waiting" => json!({ "zone": "middle", "most": number % 7 }),
        "turns" => json!({ "quarter": number % 2 + 1 }),
        "avoid" => json!({ "zone": "middle", "weight": MOST - number }),
        _ => panic!("{kind}"),
    };
    rule["kind"] = json!(if kind == "late" { "arrive" } else { kind });
    rule
}

#[test]
fn ten_thousand_rules_of_a_kind_end_in_time() {
    let usual = usual_plan();
    for kind in giveway_tests::rules_random::KINDS {
        let rules: Vec<Value> = (0..10_000).map(|number| common(kind, number)).collect();
        let scene = read(&scene(&zones(), &rules)).unwrap();
        ask_all(&format!("10,000 of {kind}"), &scene, &usual.1);
    }
    assert_little_memory();
}

/// A scene on a large open map, with so many zones of all its 65,536 cells, one rule each.
fn wide(zones: usize) -> Value {
    let side = 256;
    let all: Vec<Value> = (0..zones)
        .map(|i| json!({ "name": format!("z{i}"), "rect": [0, 0, side - 1, side - 1] }))
        .collect();
    let rules = (0..zones).map(|i| {
        let zone = format!("z{i}");
        match i % 4 {
            0 => json!({ "kind": "capacity", "zone": zone, "most": 4 }),
            1 => json!({ "kind": "no-waiting", "zone": zone, "most": 3 }),
            2 => json!({ "kind": "avoid", "zone": zone, "weight": MOST }),
            _ => json!({ "kind": "closed", "zone": zone, "from": 600, "to": 601 }),
        }
    });
    let rules: Vec<Value> = rules.collect();
    let mut scene = scene(&json!(all), &rules);
    scene["map"] = json!(vec![".".repeat(side); side]);
    scene
}

#[test]
fn large_zones_end_in_time() {
    let usual = usual_plan();
    // As many cells as a scene may have in its zones, and more.
    let scene = read(&wide(64)).unwrap();
    ask_all("64 zones of 65,536 cells", &scene, &usual.1);
    let faults = native::read_instance(&wide(1000).to_string()).unwrap_err();
    assert_eq!(faults[0].place, "zones", "{faults:?}");
    assert_little_memory();
}

#[test]
fn long_orders_end_in_time() {
    let usual = usual_plan();
    for count in [17, 300, 10_000] {
        let cells: Vec<[usize; 2]> = (0..count).map(|i| [i % SIDE, i / SIDE % SIDE]).collect();
        let rule = json!({ "kind": "sequence", "agent": "A0", "cells": cells });
        let what = format!("an order of {count} stops");
        let scene = read(&scene(&zones(), slice::from_ref(&rule))).unwrap();
        ask_all(&what, &scene, &usual.1);
        ask_one(&what, &serde_json::from_value(rule).unwrap(), &usual);
    }
    assert_little_memory();
}

#[test]
fn rules_that_each_name_a_thousand_robots_end_in_time() {
    let side = 64;
    let names: Vec<String> = (0..1000).map(|i| format!("robot {i}")).collect();
    let agents = names.iter().enumerate().map(|(i, name)| {
        let cell = |i: usize| [i % side, i / side * 2];
        json!({ "name": name, "start": cell(i), "goal": cell((i + 1) % 1000) })
    });
    let rules: Vec<Value> = (0..1000)
        .map(|i| json!({ "kind": "capacity", "zone": "half", "most": i, "agents": names }))
        .collect();
    let scene = json!({ "giveway": 1, "map": vec![".".repeat(side); side],
        "agents": agents.collect::<Vec<Value>>(),
        "zones": [{ "name": "half", "rect": [0, 0, 31, 63] }], "constraints": rules });
    let scene = read(&scene).unwrap();
    ask_search("1,000 rules of 1,000 robots", &scene);
    assert_little_memory();
}
