//! The plan of a method: of the best the one that disturbs few, judged.

use std::collections::BTreeSet;

use giveway_model::{Costs, Plan, check::check_history, sorting};

use super::MethodFound;
use crate::{
    change::{Method, compare::compare, freed::Case, splice::splice},
    problem::Problem,
    search::{Before, Bounded, Extent, closest},
    walk::Walk,
};

/// Of all plans as good as the best, one that disturbs few old agents: its
/// walks, who does the same, and whether none disturbs fewer.
pub(super) fn disturb_few(
    case: &Case<'_, '_>,
    found: &MethodFound,
    costs: Costs,
) -> Option<(Vec<Walk>, Vec<bool>, bool)> {
    let problem = &found.problem;
    let members = case.world.members.iter().zip(&problem.tasks);
    let before: Vec<Before> = members
        .map(|(member, task)| member.before(task, &problem.terrain))
        .collect();
    let objective = case.objective.costs().iter();
    let bounded = Bounded {
        horizon: found.bounded.horizon.up_to(costs.makespan),
        limits: sorting::map(objective.map(|&cost| (cost, costs.get(cost)))),
    };
    let near = closest(problem, &before, &bounded, Extent::Agents, &case.budget);
    let near = near.ok().flatten()?;
    Some((near.walks, near.same, near.proved.is_some()))
}

/// The plan behind the past with its costs, where the judge passes it and every
/// agent that is held to the method keeps to it.
pub(super) fn judged(
    case: &Case<'_, '_>,
    problem: &Problem,
    freed: &BTreeSet<usize>,
    walks: &[Walk],
    same: &[bool],
) -> Option<(Plan, Costs)> {
    let plan = splice(case.world, problem, walks, same);
    let report = check_history(case.world.after, &plan);
    let costs = report.costs.filter(|_| report.is_valid())?;
    if case.method == Method::Revise {
        let held = case.held(freed);
        let rerouted = compare(case.world, &plan).rerouted;
        let strays = |agent: usize| {
            let member = case.member(agent);
            member.is_some_and(|member| rerouted.contains(&member.name))
        };
        if held.into_iter().any(strays) {
            return None;
        }
    }
    Some((plan, costs))
}
