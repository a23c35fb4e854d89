//! The native answers to random instances that Wasm must give, too: kept in
//! `crates/giveway-wasm/tests/data/random.json`, which the tests there compare
//! with. Written anew, when the search has changed, by
//! `GIVEWAY_UPDATE=1 cargo test -p giveway-tests --test wasm_answers`.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::fs;

use giveway_model::Instance;
use giveway_solve::{Limits, Request, Response, SilentHost, SolveRequest, serve};
use giveway_tests::{random, source};
use serde_json::{Value, json};

const SEED: u64 = 7;
const SMALL: u64 = 15;
const MEDIUM: u64 = 35;

/// Conflicts for one answer: the same everywhere, so also what is cut short.
const CONFLICTS: u64 = 3000;

/// Work for one answer: most medium instances need more.
const WORK: u64 = 1000;

fn kept(instance: &Instance, limits: Limits) -> Value {
    let scene = instance.to_scene();
    let request = SolveRequest {
        scene: scene.clone(),
        limits,
        ..SolveRequest::default()
    };
    match serve(&Request::Solve(request), &SilentHost) {
        Response::Solved(answer) => json!({
            "scene": scene,
            "limits": limits,
            "status": answer.status,
            "ended": answer.ended,
            // As text, since its bytes are compared.
            "plan": serde_json::to_string(&answer.plan).unwrap(),
        }),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_native_answers_to_random_instances_are_those_that_were_kept() {
    let small = (0..SMALL).map(|number| random::small(SEED, number));
    let medium = (0..MEDIUM).map(|number| random::medium(SEED, number));
    let conflicts = Limits {
        conflicts: Some(CONFLICTS),
        ..Limits::default()
    };
    let work = Limits {
        work: Some(WORK),
        ..Limits::default()
    };
    let cut = medium.clone().map(|instance| kept(&instance, work));
    let rows: Vec<String> = small
        .chain(medium)
        .map(|instance| kept(&instance, conflicts))
        .chain(cut)
        .map(|row| row.to_string())
        .collect();
    let text = format!("[\n{}\n]\n", rows.join(",\n"));
    let path = source::root().join("crates/giveway-wasm/tests/data/random.json");
    if std::env::var_os("GIVEWAY_UPDATE").is_some() {
        fs::write(&path, &text).unwrap();
    }
    let before = fs::read_to_string(&path).unwrap();
    for (row, before) in text.lines().zip(before.lines()) {
        assert_eq!(row, before);
    }
    assert_eq!(text.len(), before.len());
    for said in [
        r#""status":"optimal""#,
        r#""status":"impossible""#,
        r#""ended":"work""#,
        r#""ended":"proof""#,
    ] {
        assert!(text.contains(said), "no {said}");
    }
}
