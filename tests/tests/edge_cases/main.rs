//! The edge cases of the problem, each with its own small picture of a map
//! (the notation is explained in `src/picture.rs`).
//!
//! Every answer is asked twice: of the solver and of the oracle.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

mod arrivals;
mod batteries;
mod claims;
mod collisions;
mod instances;
mod moves;

use giveway_model::{Costs, Instance, check};
use giveway_solve::{SolveAnswer, Status};
use giveway_tests::oracle::{Question, Verdict};
use giveway_tests::{ask, picture, recount};

/// Expects an answer such as `optimal: makespan 2, charges 0; complete`,
/// `impossible; complete` or `impossible; within 3`. Without the part after the
/// semicolon, the claim may reach as far as it likes.
#[track_caller]
fn check(picture: &str, expect: &str) {
    check_horizon(picture, None, expect);
}

/// The same, where only plans of at most this makespan count.
#[track_caller]
fn check_within(picture: &str, within: u32, expect: &str) {
    check_horizon(picture, Some(within), expect);
}

#[track_caller]
fn check_horizon(picture: &str, within: Option<u32>, expect: &str) {
    let instance = picture::instance(picture);
    let claim = expect.split(';').next().unwrap_or_default();
    let oracle = said_by_oracle(&instance, within);
    assert_eq!(oracle, claim, "the oracle, in\n{picture}");
    let answer = ask::best(&instance, within);
    let mut solver = said_by_solver(&instance, &answer);
    if expect == claim {
        solver.truncate(solver.find(';').unwrap_or(solver.len()));
    }
    assert_eq!(solver, expect, "the solver, in\n{picture}");
    if let Some(plan) = answer.plan {
        let violations = check::check(&instance, &plan).violations;
        assert!(violations.is_empty(), "{violations:?} in\n{picture}");
        assert_eq!(Some(recount::costs(&plan)), answer.costs, "in\n{picture}");
    }
}

fn said_by_oracle(instance: &Instance, within: Option<u32>) -> String {
    let question = Question {
        instance,
        within,
        cap: 1_000_000,
    };
    match question.best() {
        Verdict::Best(point) => optimal(instance, &recount::costs(&point.plan)),
        Verdict::Impossible => "impossible".to_owned(),
        Verdict::Capped => "too large for the oracle".to_owned(),
    }
}

fn said_by_solver(instance: &Instance, answer: &SolveAnswer) -> String {
    let claim = match (answer.status, &answer.costs) {
        (Status::Optimal, Some(costs)) => optimal(instance, costs),
        (Status::Impossible, None) => "impossible".to_owned(),
        other => format!("{other:?}"),
    };
    let reach = match (answer.reach.is_complete(), answer.reach.within()) {
        (true, None) => "complete".to_owned(),
        (false, Some(within)) => format!("within {within}"),
        other => format!("{other:?}"),
    };
    format!("{claim}; {reach}")
}

fn optimal(instance: &Instance, costs: &Costs) -> String {
    let values = instance.objective().costs().iter();
    let values: Vec<String> = values.map(|&c| format!("{c} {}", costs.get(c))).collect();
    format!("optimal: {}", values.join(", "))
}
