//! Asking the solver through its one door.

use giveway_model::{Instance, Plan, Question};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest};
use giveway_solve::{
    FrontAnswer, Host, Limits, Progress, Request, Response, SilentHost, SolveAnswer, SolveRequest,
    Thresholds, serve,
};

/// Far more conflicts than a test needs: a solver that does not end fails here.
const CONFLICTS: u64 = 300_000;

fn response(instance: &Instance, within: Option<u32>, pareto: bool, conflicts: u64) -> Response {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        pareto,
        within,
        limits: Limits {
            conflicts: Some(conflicts),
            ..Limits::default()
        },
        ..SolveRequest::default()
    });
    serve(&request, &SilentHost)
}

/// The solver's answer for the objective of the instance.
pub fn best(instance: &Instance, within: Option<u32>) -> SolveAnswer {
    best_within_conflicts(instance, within, CONFLICTS)
}

/// The same, with a limit of conflicts, which does not depend on the machine.
pub fn best_within_conflicts(
    instance: &Instance,
    within: Option<u32>,
    conflicts: u64,
) -> SolveAnswer {
    match response(instance, within, false, conflicts) {
        Response::Solved(answer) => answer,
        other => panic!("expected an answer, got {other:?}"),
    }
}

/// A host that sets the pace of the search.
struct Paced(Thresholds);

impl Host for Paced {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn thresholds(&self) -> Thresholds {
        self.0
    }

    fn progress(&self, _: &Progress) {}
}

/// The best plan at a pace, with its trace, from a plan on where one is given.
pub fn best_at_pace(
    instance: &Instance,
    within: Option<u32>,
    pace: Thresholds,
    start: Option<Plan>,
) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        within,
        start,
        trace: true,
        limits: Limits {
            conflicts: Some(CONFLICTS),
            ..Limits::default()
        },
        ..SolveRequest::default()
    });
    match serve(&request, &Paced(pace)) {
        Response::Solved(answer) => answer,
        other => panic!("expected an answer, got {other:?}"),
    }
}

/// The solver's Pareto front for the objective of the instance.
pub fn front(instance: &Instance, within: Option<u32>) -> FrontAnswer {
    match response(instance, within, true, CONFLICTS) {
        Response::Front(answer) => answer,
        other => panic!("expected a front, got {other:?}"),
    }
}

/// Why an instance has no plan; `None` where it has one.
pub fn unsolvable(instance: &Instance) -> Option<ExplainAnswer> {
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: None,
        question: Question::Unsolvable,
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits::default(),
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => Some(*answer),
        Response::Refused(_) => None,
        other => panic!("{other:?}"),
    }
}

/// The answer without what may differ between two runs: the seconds.
#[must_use]
pub fn without_seconds(mut answer: SolveAnswer) -> SolveAnswer {
    answer.stats.cpu_seconds = 0.0;
    answer
}
