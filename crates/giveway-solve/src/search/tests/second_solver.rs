//! The whole search on either of two SAT solvers: the same answers.

use giveway_model::{Costs, Instance};

use crate::{
    Host, Limits, Progress, Request, Response, SolveAnswer, SolveRequest, Thresholds, serve,
    tests::random,
};

/// A host that asks for the second solver, or not, and turns to nothing else but SAT.
struct On {
    second: bool,
}

impl Host for On {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn thresholds(&self) -> Thresholds {
        Thresholds {
            few_joint_states: 0,
            ..Thresholds::default()
        }
    }

    fn uses_second_solver(&self) -> bool {
        self.second
    }

    fn progress(&self, _: &Progress) {}
}

fn solve(instance: &Instance, host: &dyn Host) -> SolveAnswer {
    let request = SolveRequest {
        scene: instance.to_scene(),
        limits: Limits {
            conflicts: Some(100_000),
            ..Limits::default()
        },
        ..SolveRequest::default()
    };
    match serve(&Request::Solve(request), host) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

/// Compares the answers of both; the conflicts that the second solver met.
fn compare(instance: &Instance) -> u64 {
    let [first, second] = [false, true].map(|second| solve(instance, &On { second }));
    let vector = |costs: Option<Costs>| costs.map(|costs| costs.vector(instance.objective()));
    assert_eq!(first.status, second.status);
    assert_eq!(vector(first.costs), vector(second.costs));
    assert_eq!(first.bounds, second.bounds);
    assert_eq!(first.reach, second.reach);
    second.stats.conflicts
}

#[test]
fn the_same_answers_by_either_solver() {
    let mut conflicts = 0;
    for seed in 0..60 {
        conflicts += compare(&random(seed, 2 + seed as usize % 3));
    }
    assert!(conflicts > 2, "{conflicts} conflicts");
}
