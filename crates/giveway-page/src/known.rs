//! What two searches of one scene know together, and what a search tells of a plan
//! that was there before it.

use giveway_model::Objective;
use giveway_solve::{Reason, SolveAnswer, Status};

/// What is known after a search that went on from another one: the better of both
/// plans, and of each cost the greater bound. An answer that is final stays as it
/// is.
pub(crate) fn merged(
    before: &SolveAnswer,
    after: SolveAnswer,
    objective: &Objective,
) -> SolveAnswer {
    if matches!(after.status, Status::Optimal | Status::Impossible)
        || before.reach.within() != after.reach.within()
    {
        return after;
    }
    let is_better = match (value(before, objective), value(&after, objective)) {
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

/// What is known of a plan after the scene was solved: that no plan is better, that
/// a better one was found, or how far it can be from the best.
pub(crate) fn judged(
    plan: &SolveAnswer,
    solved: &SolveAnswer,
    objective: &Objective,
) -> SolveAnswer {
    let (own, found) = (value(plan, objective), value(solved, objective));
    let mut judged = SolveAnswer {
        plan: plan.plan.clone(),
        costs: plan.costs,
        ..solved.clone()
    };
    if own != found || solved.status != Status::Optimal {
        judged.status = Status::Feasible;
        judged.reach = judged.reach.of_bounds();
    }
    if found < own && found.is_some() {
        judged.reason = Some(Reason::Beaten);
    }
    judged
}

/// The costs of a plan in the order of the objective; `None` without a plan.
fn value(answer: &SolveAnswer, objective: &Objective) -> Option<Vec<u32>> {
    let costs = answer.costs.filter(|_| answer.plan.is_some())?;
    let costs = objective.costs().iter().map(|&cost| costs.get(cost));
    Some(costs.collect())
}
