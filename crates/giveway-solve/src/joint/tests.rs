//! The limits of exhausting joint states.

use giveway_model::format::native;

use super::{Exhaustion, any, is_rather_small, product_of_states};
use crate::{
    Limits, SilentHost,
    budget::{Budget, Stop},
    problem::Problem,
};

/// A corridor of so many cells in which two agents cannot pass each other.
fn corridor(cells: usize) -> Problem {
    let (map, last) = (".".repeat(cells), cells - 1);
    let scene = format!(
        r#"{{ "giveway": 1, "map": ["{map}"], "agents": [
            {{ "name": "A", "start": [0, 0], "goal": [{last}, 0] }},
            {{ "name": "B", "start": [{last}, 0], "goal": [0, 0] }}] }}"#
    );
    problem(&scene)
}

fn problem(scene: &str) -> Problem {
    let budget = Budget::new(&SilentHost, Limits::default());
    let instance = native::read_instance(scene).unwrap();
    let Ok(problem) = Problem::new(&instance, &budget) else {
        panic!("the scene is a problem");
    };
    problem
}

#[test]
fn joint_states_count_as_memory() {
    let problem = corridor(40);
    let exhaust = |memory_bytes| {
        let limits = Limits {
            memory_bytes,
            ..Limits::default()
        };
        any(&problem, &[0, 1], &Budget::new(&SilentHost, limits))
    };
    assert!(matches!(exhaust(None), Ok(Exhaustion::None(_))));
    assert!(matches!(exhaust(Some(10_000_000)), Ok(Exhaustion::None(_))));
    assert_eq!(exhaust(Some(20_000)), Err(Stop::Memory));
}

/// Three robots that have to turn, on eight cells: most headings are never reached.
const TURNING: &str = r####"{ "giveway": 1, "map": ["###.", "....", ".##."], "agents": [
    { "name": "A0", "start": [3, 1], "goal": [3, 0], "waypoints": [[0, 2]] },
    { "name": "A1", "start": [1, 1], "goal": [3, 2], "heading": "east" },
    { "name": "A2", "start": [3, 2], "goal": [0, 1], "heading": "south" }],
    "objective": ["penalty", "waits", "makespan", "moves"],
    "constraints": [{ "kind": "turns", "quarter": 1 }] }"####;

/// SAT refutes one horizon after the other, and so never that there is a plan at all.
#[test]
fn what_is_never_reached_does_not_count() {
    let problem = problem(TURNING);
    let budget = Budget::new(&SilentHost, Limits::default());
    let most = budget.thresholds().few_joint_states * 10;
    assert!(product_of_states(&problem, 0..3) > most);
    assert_eq!(is_rather_small(&problem, &budget), Ok(true));
    let request = crate::Request::Solve(crate::SolveRequest {
        scene: native::read_scene(TURNING).unwrap(),
        limits: Limits {
            work: Some(2_000_000),
            ..Limits::default()
        },
        ..crate::SolveRequest::default()
    });
    let crate::Response::Solved(answer) = crate::serve(&request, &SilentHost) else {
        panic!("a solve request is solved");
    };
    assert_eq!(answer.status, crate::Status::Impossible);
    assert!(answer.reach.is_complete());
}
