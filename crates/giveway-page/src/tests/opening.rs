//! The scene that the page opens on is what the solver answers.

use expect_test::expect_file;
use giveway_model::format::native;
use giveway_solve::{Response, SilentHost, serve};

use crate::opening::{answer, draft};
use crate::reduce::tests::after;
use crate::{Action, Draft, SolveAction, State, WorkerAction, link};

const SCENE: &str = include_str!("../../../../static/examples/warehouse.json");

/// `UPDATE_EXPECT=1` writes it anew.
#[test]
fn it_is_what_the_solver_answers() {
    let scene = native::read_scene(SCENE).unwrap();
    let asked = after(
        &State::new(Draft::new(scene).unwrap()),
        [Action::Solve(SolveAction::Begin)],
    );
    let (job, request) = asked.work.request().unwrap();
    let Response::Solved(mut solved) = serve(&request, &SilentHost) else {
        panic!("the opening scene was refused");
    };
    // Its record is not worth the bytes, and how long it took is another thing.
    solved.trace = None;
    solved.stats = giveway_solve::Stats::default();
    let response = Box::new(Response::Solved(solved.clone()));
    let state = after(
        &asked,
        [Action::Worker(WorkerAction::Respond { job, response })],
    );
    let text = link::keep_moment(&state.moment());
    expect_file!["../../../../static/opening.txt"].assert_eq(&(text + "\n"));
    assert_eq!(answer().unwrap().solved, solved);
    assert_eq!(draft(), *state.document.draft);
}
