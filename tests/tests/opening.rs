//! The plan that comes with the page is the one that the solver finds.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use expect_test::expect_file;
use giveway_model::format::native;
use giveway_solve::{Request, Response, SilentHost, SolveRequest, serve};

const SCENE: &str = include_str!("../../static/examples/warehouse.json");

/// `UPDATE_EXPECT=1` writes it anew.
#[test]
fn the_opening_scene_comes_with_what_the_solver_answers() {
    let request = SolveRequest {
        scene: native::read_scene(SCENE).unwrap(),
        ..SolveRequest::default()
    };
    let Response::Solved(mut answer) = serve(&Request::Solve(request), &SilentHost) else {
        panic!("the opening scene was refused");
    };
    // It is another one every time.
    answer.stats.cpu_seconds = 0.0;
    let text = serde_json::to_string(&answer).unwrap() + "\n";
    expect_file!["../../static/opening.json"].assert_eq(&text);
}
