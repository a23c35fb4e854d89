//! What an answer of the solver proves: what it only believes is unknown.

use giveway_model::{Costs, Plan};
use giveway_solve::{Refusal, Response, SolveAnswer, Status};

use super::Why;
use crate::port::Evidence;

/// What is proved of a scene, whatever the horizon.
pub(crate) enum Proved<'a> {
    /// The best plan.
    Best(Costs, &'a Plan),
    /// There is none.
    NoPlan,
}

/// What a solve answer proves.
pub(super) fn answer(answer: &SolveAnswer) -> Result<Proved<'_>, Why> {
    match (answer.status, answer.costs, &answer.plan) {
        (Status::Optimal, Some(costs), Some(plan)) if answer.reach.is_complete() => {
            Ok(Proved::Best(costs, plan))
        }
        (Status::Impossible, ..) if answer.reach.is_complete() => Ok(Proved::NoPlan),
        _ => Err(Why::Unknown(answer.reason.clone())),
    }
}

/// What the response to a solve request proves.
pub(crate) fn solved(response: Option<&Response>) -> Result<Proved<'_>, Why> {
    match response {
        Some(Response::Solved(solved)) => answer(solved),
        other => Err(unexpected(other)),
    }
}

/// What is said where a response is not the one that was asked for.
pub(super) fn unexpected(response: Option<&Response>) -> Why {
    match response {
        Some(Response::Refused(refusal)) => Why::Refused(sentence(refusal)),
        _ => Why::Unknown(None),
    }
}

fn sentence(refusal: &Refusal) -> String {
    refusal.sentences().into_iter().next().unwrap_or_default()
}

/// A plan that is proved best, as evidence.
pub(super) fn best_plan(plan: &Plan) -> Evidence {
    Evidence {
        plan: Some(plan.clone()),
        proved: true,
        ..Evidence::default()
    }
}
