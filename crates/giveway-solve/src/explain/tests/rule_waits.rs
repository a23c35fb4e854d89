//! A wait that a rule of the scene's own causes: the answer names the rule.

use giveway_model::question::from_words;

use super::read;
use crate::{
    Limits, Request, Response, SilentHost,
    explain::{ExplainAnswer, ExplainRequest},
    service::serve,
};

/// Robots on a map, each by its cells in row 0, and a rule that is called `why`.
fn asked(map: &str, agents: &str, rule: &str, paths: &str) -> ExplainAnswer {
    let rule = rule.replacen('{', r#"{ "name": "why", "#, 1);
    let scene = format!(
        r#"{{ "giveway": 1, "map": [{map}], "agents": [{agents}],
            "zones": [{{ "name": "z", "cells": [[1, 0], [2, 0]] }}],
            "constraints": [{rule}] }}"#
    );
    let plan = format!(r#"{{ "giveway": 1, "paths": {{ {paths} }} }}"#);
    let (instance, plan) = read(&scene, &plan);
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan),
        changes: None,
        at: None,
        question: from_words(&["wait", "A1"]).unwrap(),
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits::default(),
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => *answer,
        other => panic!("{rule}: {other:?}"),
    }
}

const ONE: &str = r#"{ "name": "A1", "start": [0, 0], "goal": [3, 0] }"#;

/// A1 alone, along the row.
fn alone(rule: &str, cells: &[u32]) -> ExplainAnswer {
    let path = row(cells);
    asked(r#""....""#, ONE, rule, &format!(r#""A1": {path}"#))
}

/// A1 behind A2.
fn behind(rule: &str, (start, goal): (u32, u32), first: &[u32], second: &[u32]) -> ExplainAnswer {
    let other = format!(r#"{{ "name": "A2", "start": [{start}, 0], "goal": [{goal}, 0] }}"#);
    let paths = format!(r#""A1": {}, "A2": {}"#, row(first), row(second));
    asked(r#"".......""#, &format!("{ONE}, {other}"), rule, &paths)
}

fn row(cells: &[u32]) -> String {
    let cells: Vec<[u32; 2]> = cells.iter().map(|&x| [x, 0]).collect();
    format!("{cells:?}")
}

#[test]
fn every_rule_that_makes_a_robot_wait_is_named() {
    let turn = asked(
        r#""...", "...""#,
        r#"{ "name": "A1", "start": [0, 0], "goal": [1, 1] }"#,
        r#"{ "kind": "turns", "quarter": 1 }"#,
        r#""A1": [[0, 0], [1, 0], [1, 0], [1, 1]]"#,
    );
    let answers = [
        (
            "closed",
            alone(
                r#"{ "kind": "closed", "zone": "z", "to": 2 }"#,
                &[0, 0, 0, 1, 2, 3],
            ),
        ),
        (
            "depart",
            alone(r#"{ "kind": "depart", "from": 2 }"#, &[0, 0, 0, 1, 2, 3]),
        ),
        (
            "arrive",
            alone(r#"{ "kind": "arrive", "from": 5 }"#, &[0, 0, 0, 1, 2, 3]),
        ),
        (
            "visit",
            alone(
                r#"{ "kind": "visit", "cell": [1, 0], "stay": 2 }"#,
                &[0, 1, 1, 1, 2, 3],
            ),
        ),
        ("turns", turn),
        (
            "gap",
            behind(
                r#"{ "kind": "gap", "steps": 1 }"#,
                (1, 4),
                &[0, 0, 1, 2, 3],
                &[1, 2, 3, 4],
            ),
        ),
        (
            "apart",
            behind(
                r#"{ "kind": "apart", "distance": 3, "from": 1 }"#,
                (2, 6),
                &[0, 0, 1, 2, 3],
                &[2, 3, 4, 5, 6],
            ),
        ),
        (
            "capacity",
            behind(
                r#"{ "kind": "capacity", "zone": "z", "most": 1 }"#,
                (1, 4),
                &[0, 0, 1, 2, 3],
                &[1, 2, 3, 4],
            ),
        ),
        (
            "before",
            behind(
                r#"{ "kind": "before", "first": { "agent": "A2", "cell": [3, 0] },
                    "second": { "agent": "A1", "cell": [1, 0] } }"#,
                (1, 4),
                &[0, 0, 0, 1, 2, 3],
                &[1, 2, 3, 4],
            ),
        ),
    ];
    for (kind, answer) in answers {
        assert!(
            answer.words.contains("the rule 'why'"),
            "{kind}: {:?} {}",
            answer.verdict,
            answer.words
        );
    }
}
