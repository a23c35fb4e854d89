//! The plan of a method: of the best the one that disturbs few, judged.

use std::collections::BTreeSet;

use giveway_model::{Costs, Plan, check::check_history, sorting};

use super::MethodFound;
use crate::{
    change::{Method, compare::compare, method_case::MethodCase},
    problem::Problem,
    search::{Bounded, ClosestInput, Extent, GivenWalk, closest},
    walk::{Walk, of_path, to_plan},
};

/// Of all plans as good as the best, one that disturbs few old agents: its
/// walks, who does the same, and whether none disturbs fewer.
pub(super) fn disturb_few(
    case: &MethodCase<'_, '_>,
    found: &MethodFound,
    costs: Costs,
) -> Option<(Vec<Walk>, Vec<bool>, bool)> {
    let problem = &found.problem;
    let agents = case.snapshot.agents.iter().zip(&problem.tasks);
    // (A path that can no longer be followed is as far away as none.)
    let before: Vec<GivenWalk> = agents
        .map(|(running, task)| GivenWalk {
            walk: of_path(task, &problem.terrain, &running.path).unwrap_or_default(),
            charges: running.charges.clone(),
        })
        .collect();
    let objective = case.objective.costs().iter();
    let bounded = Bounded {
        horizon: found.bounded.horizon.up_to(costs.makespan),
        limits: sorting::map(objective.map(|&cost| (cost, costs.get(cost)))),
    };
    let is_proved = found.verdict.stop.is_none();
    let given = ClosestInput {
        before: &before,
        bounded: &bounded,
        latest: found.verdict.latest.as_ref().filter(|_| is_proved),
    };
    let near = closest(problem, given, Extent::Agents, &case.budget);
    let near = near.ok()?.plan()?;
    // Plans as good end no later (the makespan is in every objective here), so that as far as the
    // search looked is far enough.
    Some((near.walks, near.same, near.proved.is_some()))
}

/// The plan behind the past with its costs, where the judge passes it and every
/// agent that is held to the method keeps to it.
pub(super) fn judged(
    case: &MethodCase<'_, '_>,
    problem: &Problem,
    freed: &BTreeSet<usize>,
    walks: &[Walk],
    same: &[bool],
) -> Option<(Plan, Costs)> {
    let agents = case.snapshot.instance.agents().iter();
    let names: Vec<String> = agents.map(|agent| agent.name.clone()).collect();
    let mut rest = to_plan(problem, &names, walks);
    for (agent, name) in names.iter().enumerate() {
        // An agent that does the same as before also charges as before.
        if same.get(agent) == Some(&true) {
            let charges = case.snapshot.agents.get(agent).map(|it| it.charges.clone());
            rest.charges
                .insert(name.clone(), charges.unwrap_or_default());
        }
    }
    let plan = case.snapshot.whole(&rest);
    let report = check_history(case.snapshot.history, &plan);
    let costs = report.costs.filter(|_| report.is_valid())?;
    if case.method == Method::Revise {
        let held = case.held(freed);
        let rerouted = compare(case.snapshot, &plan).rerouted;
        let strays = |agent: usize| rerouted.iter().any(|name| name == case.name(agent));
        if held.into_iter().any(strays) {
            return None;
        }
    }
    Some((plan, costs))
}
