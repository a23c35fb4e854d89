//! The native answers that the tests in Wasm compare with.
//!
//! They are written anew, when the search has changed, by
//! `UPDATE_EXPECT=1 cargo test -p giveway-wasm --test native`.
#![cfg(not(target_arch = "wasm32"))]
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

#[path = "suite/cases.rs"]
mod cases;

use std::path::Path;

use cases::{CASES, CHANGING, Case, Changing, METHODS};
use expect_test::expect_file;
use giveway_model::format::native;
use giveway_solve::change::ChangeRequest;
use giveway_solve::{Limits, Request, Response, SilentHost, SolveRequest, serve};

/// The answer as text; without a clock its seconds are 0.
fn answer(case: &Case) -> String {
    let request = SolveRequest {
        scene: native::read_scene(case.scene).unwrap(),
        objective: case.objective.map(|costs| costs.parse().unwrap()),
        pareto: case.pareto,
        limits: Limits {
            conflicts: case.conflicts,
            ..Limits::default()
        },
        ..SolveRequest::default()
    };
    let text = match serve(&Request::Solve(request), &SilentHost) {
        Response::Solved(answer) => serde_json::to_string(&answer),
        Response::Front(answer) => serde_json::to_string(&answer),
        other => panic!("{other:?}"),
    };
    text.unwrap() + "\n"
}

#[test]
fn the_native_answers_are_those_that_were_kept() {
    for case in CASES {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
        expect_file![path.join(case.name)].assert_eq(&answer(case));
    }
}

fn go_on(case: &Changing) -> String {
    let request = ChangeRequest {
        scene: native::read_scene(case.scene).unwrap(),
        plan: native::read_plan(case.plan).unwrap(),
        changes: native::read_changes(case.changes).unwrap(),
        since: None,
        methods: METHODS.map(|method| method.parse().unwrap()).to_vec(),
        objective: None,
        within: None,
        limits: Limits::default(),
    };
    match serve(&Request::Change(request), &SilentHost) {
        Response::Changed(answer) => serde_json::to_string(&answer).unwrap() + "\n",
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_native_plans_after_a_change_are_those_that_were_kept() {
    for case in CHANGING {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
        expect_file![path.join(case.name)].assert_eq(&go_on(case));
    }
}
