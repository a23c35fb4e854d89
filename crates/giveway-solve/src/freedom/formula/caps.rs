//! The latest arrival that each agent can have in a best plan.

use giveway_model::{Cost, Costs, Objective};

use crate::{
    problem::Problem,
    search::{LatestArrivals, Proved, reach_of_best_plans},
};

/// The latest arrivals, and how far what is shown of all best plans reaches.
pub(in crate::freedom) struct Caps {
    pub(in crate::freedom) latest: Vec<u32>,
    pub(in crate::freedom) reach: Proved,
}

/// The caps that the best costs give and that their proof leaves, and else the horizon.
pub(in crate::freedom) fn caps(
    problem: &Problem,
    (objective, best): (&Objective, &Costs),
    horizon: u32,
    (optimum, left): (Proved, Option<&LatestArrivals>),
) -> Caps {
    let horizon = optimum
        .within()
        .map_or(horizon, |within| within.min(horizon));
    let counts = |cost| objective.costs().contains(&cost);
    let total: u32 = problem.optima.iter().sum();
    let delay = best.sum_of_costs.saturating_sub(total);
    let by_costs = |optimum: u32| {
        let makespan = counts(Cost::Makespan).then_some(best.makespan);
        let sum = counts(Cost::SumOfCosts).then(|| optimum.saturating_add(delay));
        makespan.into_iter().chain(sum).min()
    };
    let each = problem.optima.iter().enumerate();
    let latest = each.map(|(agent, &optimum)| {
        let by_costs = by_costs(optimum).unwrap_or(u32::MAX);
        let by_proof = left.map_or(u32::MAX, |left| left.of(agent));
        let latest = by_costs.min(by_proof).min(horizon);
        latest.min(problem.not_after(agent))
    });
    Caps {
        latest: latest.collect(),
        reach: reach_of_best_plans(problem, (objective, best), horizon, optimum),
    }
}
