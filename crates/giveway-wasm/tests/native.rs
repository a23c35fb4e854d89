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

use cases::{CASES, Case};
use expect_test::expect_file;
use giveway_model::format::native;
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
