//! Events name the rules of the scene's own that they rest on, and no others.

use giveway_model::format::native;

use crate::{
    Request, Response, SilentHost, SolveAnswer, SolveRequest,
    service::serve,
    trace::{SearchTrace, TraceEvent},
};

fn solved(scene: &str) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: native::read_scene(scene).unwrap(),
        trace: true,
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

fn traced(map: &str, agents: &str, rules: &str) -> SearchTrace {
    let scene = format!(
        r#"{{ "giveway": 1, "map": [{map}], "agents": [{agents}],
            "zones": [{{ "name": "aisle", "rect": [1, 0, 1, 2] }}],
            "constraints": [{rules}, {{ "kind": "closed", "zone": "aisle", "from": 90, "name": "free" }}] }}"#
    );
    solved(&scene).trace.unwrap()
}

/// The names of the rules that events rest on, each event's in one text.
fn named(trace: &SearchTrace) -> Vec<String> {
    let rules = trace.events.iter().filter(|event| !event.rules.is_empty());
    let names = rules.map(|event: &TraceEvent| {
        let names = event.rules.iter().filter_map(|rule| rule.name.clone());
        let names: Vec<String> = names.collect();
        assert!(
            event.text.contains("This rests on the rule"),
            "{}",
            event.text
        );
        names.join(" ")
    });
    names.collect()
}

const AISLE: &str = r##""...", "#.#", "...""##;
const THROUGH: &str = r#"{ "name": "A1", "start": [0, 0], "goal": [0, 2] },
    { "name": "A2", "start": [2, 0], "goal": [2, 2] }"#;

#[test]
fn a_bound_that_comes_from_a_capacity_names_it() {
    let capacity = r#"{ "kind": "capacity", "zone": "aisle", "most": 1, "name": "narrow" }"#;
    let trace = traced(AISLE, THROUGH, capacity);
    let named = named(&trace);
    assert!(!named.is_empty(), "{:?}", trace.events);
    assert!(named.iter().all(|names| names == "narrow"), "{named:?}");
}

#[test]
fn a_bound_that_comes_from_a_lane_names_it() {
    let lane = r#"{ "kind": "one-way", "lane": [[2, 0], [1, 0], [0, 0]], "name": "back" }"#;
    let agent = r#"{ "name": "A1", "start": [0, 0], "goal": [2, 0] }"#;
    let trace = traced(r#""...", "...", "...""#, agent, lane);
    assert_eq!(named(&trace)[0], "back", "{:?}", trace.events);
    assert_eq!(
        trace.events[0].text,
        "A1 alone needs 4 steps: makespan at least 4. This rests on the rule 'back'."
    );
}

#[test]
fn a_bound_that_comes_from_an_order_names_it() {
    let order = r#"{ "kind": "before", "first": { "agent": "A1", "cell": [3, 0] },
        "second": { "agent": "A2", "cell": [1, 2] }, "name": "order" }"#;
    let agents = r#"{ "name": "A1", "start": [0, 0], "goal": [3, 0] },
        { "name": "A2", "start": [0, 2], "goal": [2, 2] }"#;
    let trace = traced(r#####""....", "####", "....""#####, agents, order);
    let named = named(&trace);
    assert!(!named.is_empty(), "{:?}", trace.events);
    assert!(named.iter().all(|names| names == "order"), "{named:?}");
}

#[test]
fn rules_that_are_free_are_not_named() {
    let gone = r#"{ "kind": "closed", "zone": "aisle", "from": 50, "name": "later" }"#;
    let trace = traced(AISLE, THROUGH, gone);
    assert_eq!(named(&trace), Vec::<String>::new(), "{:?}", trace.events);
}

#[test]
fn no_plan_names_the_rules_that_leave_none() {
    let rules = r#"{ "kind": "arrive", "by": 5, "name": "soon" },
        { "kind": "capacity", "zone": "aisle", "most": 1, "name": "narrow" }"#;
    let trace = traced(AISLE, THROUGH, rules);
    let last = named(&trace).pop();
    assert_eq!(last.as_deref(), Some("soon narrow"), "{:?}", trace.events);
}

#[test]
fn a_robot_that_rules_shut_in_is_told_with_them() {
    let scene = |rules: &str| {
        format!(
            r#"{{ "giveway": 1, "map": ["...", "..."],
                "agents": [{{ "name": "A1", "start": [0, 0], "goal": [2, 0] }}],
                "zones": [{{ "name": "low", "cells": [[1, 1]] }},
                          {{ "name": "high", "cells": [[1, 0]] }}],
                "constraints": [{rules}] }}"#
        )
    };
    let both = r#"{ "kind": "gap", "steps": 2 },
        { "kind": "closed", "zone": "low", "name": "below" },
        { "kind": "depart", "from": 3 },
        { "kind": "closed", "zone": "high" }"#;
    let reason = |rules: &str| {
        let answer = solved(&scene(rules));
        crate::words::reason(&answer.reason.unwrap())
    };
    assert_eq!(
        reason(both),
        "A1 cannot do its task, even alone, because of the rule 'below' and the rule \
         \"No robot in 'high'\"."
    );
    // Walls shut it in, whatever the rules are.
    let walled = scene(both).replace(r#"["...", "..."]"#, r#"[".#.", ".#."]"#);
    let walled = walled
        .replace("[[1, 1]]", "[[0, 1]]")
        .replace("[[1, 0]]", "[[2, 1]]");
    let answer = solved(&walled);
    assert_eq!(
        crate::words::reason(&answer.reason.unwrap()),
        "A1 cannot do its task, even alone."
    );
}
