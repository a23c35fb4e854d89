//! How far bounds reach that a search had proved when it ended early, and the
//! bounds that need no search.

use std::collections::BTreeMap;

use giveway_model::{Cost, Objective};

use super::{ForEver, Reach, latest_of_sum};
use crate::{
    budget::{Budget, Stop},
    problem::Problem,
    search::{horizon::Horizon, tally::least},
};

/// What no plan of any makespan has less of, since each agent alone needs as much.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn lone_bound(problem: &Problem, cost: Cost, budget: &Budget) -> Result<u32, Stop> {
    let mut bound: u32 = 0;
    for agent in 0..problem.agents() {
        bound = match cost {
            Cost::Makespan => bound.max(problem.optima[agent]),
            Cost::SumOfCosts => bound.saturating_add(problem.least_cost(agent)),
            Cost::Charges | Cost::Moves | Cost::Waits => {
                bound.saturating_add(least(problem, agent, cost, budget)?)
            }
        };
    }
    Ok(bound)
}

/// How far the bounds reach that a search within a horizon proved before it ended
/// early: of each cost of the objective in turn, as far as it came. `lone` are
/// those that each agent alone shows.
pub(crate) fn reach_of_bounds(
    problem: &Problem,
    horizon: Horizon,
    objective: &Objective,
    bounds: &BTreeMap<Cost, u32>,
    lone: &BTreeMap<Cost, u32>,
) -> Reach {
    let latest = horizon.latest();
    for cost in objective.costs() {
        let Some(&bound) = bounds.get(cost) else {
            break;
        };
        let holds = match cost {
            // A plan of a lesser makespan would be within the horizon; so are all
            // among which the later costs are bounded.
            Cost::Makespan => return Reach::ForEver(ForEver(())),
            Cost::SumOfCosts => latest_of_sum(problem, bound) <= latest,
            Cost::Charges | Cost::Moves | Cost::Waits => false,
        };
        let is_lone = lone.get(cost) == Some(&bound);
        if !(holds || is_lone || horizon.is_beyond_use()) {
            return Reach::Within(latest);
        }
        if *cost == Cost::SumOfCosts && holds {
            // Of the plans among which the later costs are bounded none is later.
            break;
        }
    }
    Reach::ForEver(ForEver(()))
}
