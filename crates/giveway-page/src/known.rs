//! What two searches of one scene know together.

use giveway_model::Objective;
use giveway_solve::{SolveAnswer, Status};

/// What is known after a search that went on from another one: the better of both
/// plans, and of each cost the greater bound. An answer that is final stays as it
/// is.
pub(crate) fn merged(
    before: &SolveAnswer,
    after: SolveAnswer,
    objective: &Objective,
) -> SolveAnswer {
    if matches!(after.status, Status::Optimal | Status::Impossible) || before.within != after.within
    {
        return after;
    }
    let value = |answer: &SolveAnswer| {
        let costs = answer.costs.filter(|_| answer.plan.is_some())?;
        let costs = objective.costs().iter().map(|&cost| costs.get(cost));
        Some(costs.collect::<Vec<_>>())
    };
    let is_better = match (value(before), value(&after)) {
        (Some(before), Some(after)) => before < after,
        (before, None) => before.is_some(),
        (None, Some(_)) => false,
    };
    let mut merged = after;
    for (&cost, &bound) in &before.bounds {
        let known = merged.bounds.entry(cost).or_insert(bound);
        *known = bound.max(*known);
    }
    if is_better {
        merged.plan.clone_from(&before.plan);
        merged.costs = before.costs;
        merged.status = before.status;
    }
    merged
}
