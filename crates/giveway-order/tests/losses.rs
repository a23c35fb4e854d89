//! What the order keeps by itself, and what it does not.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use giveway_model::change::{Changes, History};
use giveway_model::check::check_changes;
use giveway_model::format::native::{read_changes, read_instance, read_plan};
use giveway_order::{Lateness, Loss, OrderGraph, Outcome, losses, words};

/// A row in which B follows A, with rules and changes.
fn graph<T>(rules: &str, changes: &str, read: impl FnOnce(&OrderGraph<'_>, Outcome) -> T) -> T {
    let scene = format!(
        r#"{{ "giveway": 1, "map": ["......", "......"], "agents": [
            {{ "name": "A", "start": [1, 0], "goal": [4, 0] }},
            {{ "name": "B", "start": [0, 0], "goal": [3, 1] }}],
          "zones": [{{ "name": "hall", "rect": [0, 0, 5, 1] }}], "constraints": [{rules}] }}"#
    );
    let instance = read_instance(&scene).unwrap();
    let changes: Changes =
        read_changes(&format!(r#"{{ "giveway": 1, "changes": [{changes}] }}"#)).unwrap();
    let plan = read_plan(
        r#"{ "giveway": 1, "paths": {
            "A": [[1, 0], [2, 0], [3, 0], [4, 0]],
            "B": [[0, 0], [0, 0], [1, 0], [2, 0], [3, 0], [3, 0], [3, 1]] } }"#,
    )
    .unwrap();
    let report = check_changes(&instance, &changes, &plan).unwrap();
    assert!(report.is_valid(), "{:?}", report.violations);
    let history = History::of(&instance, &changes, &plan).unwrap();
    let graph = OrderGraph::new(&history, &changes, &plan).unwrap();
    let late = Lateness {
        agent: "A".to_owned(),
        cell: giveway_model::Cell::new(4, 0),
        visit: 1,
        steps: 5,
    };
    let outcome = graph.late(&instance, &[late]).unwrap();
    read(&graph, outcome)
}

fn kinds(rules: &str) -> Vec<String> {
    let kind = |loss: Loss| match loss {
        Loss::Rule { kind, .. } => kind,
        Loss::Battery { .. } | Loss::Changes { .. } | Loss::MovingObstacles => String::new(),
    };
    graph(rules, "", |graph, _| {
        losses(graph).into_iter().map(kind).collect()
    })
}

#[test]
fn rules_about_ways_and_first_times_are_kept() {
    let kept = r#"{ "kind": "one-way", "lane": [[1, 0], [2, 0]] },
        { "kind": "sequence", "agent": "A", "cells": [[2, 0], [3, 0]] },
        { "kind": "depart", "agents": ["B"], "from": 1 },
        { "kind": "visit", "agents": ["B"], "cell": [3, 0], "from": 4 },
        { "kind": "arrive", "agents": ["B"], "from": 5 },
        { "kind": "gap", "steps": 1 }, { "kind": "turns", "quarter": 1 },
        { "kind": "capacity", "zone": "hall", "most": 2, "off": true }"#;
    assert_eq!(kinds(kept), [""; 0]);
}

#[test]
fn rules_about_last_times_and_pairs_are_not() {
    let lost = r#"{ "kind": "capacity", "zone": "hall", "most": 2 },
        { "kind": "apart", "distance": 2, "from": 1, "to": 3 },
        { "kind": "visit", "agents": ["B"], "cell": [3, 0], "stay": 1 },
        { "kind": "arrive", "agents": ["B"], "by": 6 },
        { "kind": "no-waiting", "zone": "hall", "most": 3 }"#;
    assert_eq!(
        kinds(lost),
        ["capacity", "apart", "visit", "arrive", "no-waiting"]
    );
    let told = graph(lost, "", |graph, _| {
        losses(graph).iter().map(words::loss).next()
    });
    assert!(
        told.unwrap()
            .starts_with("The order alone does not keep this rule when robots are late: ")
    );
}

#[test]
fn a_late_plan_is_judged_by_the_rules() {
    let broken = |rules: &str| -> Vec<String> {
        graph(rules, "", |_, outcome| {
            let broken = outcome
                .violations
                .iter()
                .filter_map(|it| it.broken.as_ref());
            broken.map(|it| it.kind.clone()).collect()
        })
    };
    assert_eq!(
        broken(r#"{ "kind": "arrive", "agents": ["B"], "by": 6 }"#),
        ["arrive"]
    );
    assert_eq!(
        broken(r#"{ "kind": "gap", "steps": 1 }, { "kind": "turns", "quarter": 1 }"#),
        [""; 0]
    );
}

#[test]
fn what_changes_does_so_at_its_own_time() {
    let obstacle = r#"{ "at": 7, "change": "add-obstacle", "cell": [3, 0] }"#;
    graph("", obstacle, |graph, outcome| {
        assert_eq!(losses(graph), [Loss::Changes { last: 7 }]);
        // A is still there then: nobody can put it down.
        assert!(outcome.violations.is_empty());
        assert_eq!(outcome.refused.len(), 1);
        let told = words::outcome(&outcome).join(" ");
        assert!(told.contains("This does not go well then: "), "{told}");
        assert!(
            told.contains("an obstacle at (3, 0), where A is at time 7"),
            "{told}"
        );
    });
}

/// A robot that breaks down for good is carried out up to where it stands; late, that is elsewhere.
#[test]
fn who_breaks_down_for_good_stands_where_it_is_by_then() {
    let instance = read_instance(
        r#"{ "giveway": 1, "map": ["......", "......"], "agents": [
            { "name": "A", "start": [0, 0], "goal": [5, 0] },
            { "name": "B", "start": [0, 1], "goal": [3, 1] }] }"#,
    )
    .unwrap();
    let changes =
        r#"{ "giveway": 1, "changes": [{ "at": 3, "change": "stop-agent", "agent": "A" }] }"#;
    let changes = read_changes(changes).unwrap();
    let plan = read_plan(
        r#"{ "giveway": 1, "paths": { "A": [[0, 0], [1, 0], [2, 0], [3, 0]],
            "B": [[0, 1], [1, 1], [2, 1], [3, 1]] } }"#,
    )
    .unwrap();
    assert!(
        check_changes(&instance, &changes, &plan)
            .unwrap()
            .is_valid()
    );
    let history = History::of(&instance, &changes, &plan).unwrap();
    let graph = OrderGraph::new(&history, &changes, &plan).unwrap();
    assert_eq!(graph.late(&instance, &[]).unwrap().plan, plan);
    let late = Lateness {
        agent: "A".to_owned(),
        cell: giveway_model::Cell::new(1, 0),
        visit: 1,
        steps: 1,
    };
    let carried = graph.late(&instance, &[late]).unwrap().plan;
    let cells: Vec<u32> = carried
        .path("A")
        .iter()
        .flatten()
        .map(|cell| cell.x)
        .collect();
    assert_eq!((cells.len(), cells.last()), (4, Some(&2)), "{carried:?}");
    let report = check_changes(&instance, &changes, &carried).unwrap();
    assert!(report.is_valid(), "{:?}", report.violations);
}
