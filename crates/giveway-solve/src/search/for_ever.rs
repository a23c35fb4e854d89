//! What is so whatever the horizon.
//!
//! The search looks at plans up to a horizon. A claim goes beyond it only where
//! one of these arguments carries it: a bound on time that every better plan
//! keeps, the agents' own minima, or joint states that are exhausted.

use giveway_model::Cost;

use super::{incumbent::Incumbent, lexicographic::Bounded, stage::Search, tally::least};
use crate::{
    joint,
    meter::{Meter, Stop},
    problem::Problem,
};

/// No plan with this sum of costs has a later makespan.
pub(super) fn latest_of_sum(problem: &Problem, sum: u32) -> u32 {
    let total: u32 = problem.optima.iter().sum();
    let longest = problem.optima.iter().copied().max().unwrap_or(0);
    sum.saturating_sub(total) + longest
}

/// Whether the bound on the first cost holds whatever the horizon.
pub(super) fn holds_for_ever(
    search: &mut Search,
    cost: Cost,
    least: u32,
    bounded: &Bounded,
) -> Result<bool, Stop> {
    match cost {
        Cost::Makespan => Ok(true),
        Cost::SumOfCosts => {
            let latest = latest_of_sum(search.problem, least);
            Ok(!search.met_horizon || bounded.horizon >= latest)
        }
        _ => Ok(least == search.sum_of_minima(cost)?),
    }
}

/// The least charges, moves or waits at any horizon, where these stand first
/// and the joint states can be exhausted: SAT could show it within the horizon
/// only. It becomes a limit, so that a plan is all that is left to find.
pub(super) fn known_for_ever(
    problem: &Problem,
    bounded: &Bounded,
    incumbent: &Incumbent,
    meter: &Meter,
) -> Result<Option<(Cost, u32)>, Stop> {
    let cost = incumbent.objective().costs().first().copied();
    let (Some(cost), Some(costs)) = (cost, incumbent.costs()) else {
        return Ok(None);
    };
    let timed = matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    if timed || !bounded.limits.is_empty() {
        return Ok(None);
    }
    let mut minima = 0;
    for agent in 0..problem.agents() {
        minima += least(problem, agent, cost, meter)?;
    }
    if costs.get(cost) == minima {
        return Ok(None);
    }
    let all: Vec<usize> = (0..problem.agents()).collect();
    match joint::least(problem, &all, cost, meter)? {
        joint::Found::Least(least) => Ok(Some((cost, least))),
        _ => Ok(None),
    }
}

/// Whether there is no plan at any horizon: by the limits themselves, or by
/// exhausting the joint states of the agents that clash.
pub(super) fn impossible_for_ever(
    problem: &Problem,
    bounded: &Bounded,
    clash: &[usize],
    meter: &Meter,
) -> Result<bool, Stop> {
    if clash.is_empty()
        || bounded.limits_time(problem)
        || joint::least(problem, clash, Cost::Makespan, meter)? == joint::Found::None
    {
        return Ok(true);
    }
    let all: Vec<usize> = (0..problem.agents()).collect();
    for (&cost, &most) in &bounded.limits {
        let counted = !matches!(cost, Cost::Makespan | Cost::SumOfCosts);
        if counted
            && let joint::Found::Least(least) = joint::least(problem, &all, cost, meter)?
            && least > most
        {
            return Ok(true);
        }
    }
    Ok(false)
}
