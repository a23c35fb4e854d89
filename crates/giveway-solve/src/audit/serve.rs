//! An audit request, from the scene to the answer.

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance, check::check};

use super::{AuditAnswer, AuditRequest, conclude::conclude};
use crate::{
    Host, Progress, Refusal, SolveAnswer, Status, assumed,
    problem::Problem,
    search::{Bounded, Horizon, LoneBound, Minima, reach_of_bounds},
    solve::{self, SolveTask},
};

/// Serves an audit request.
///
/// # Errors
/// When the scene is no instance.
pub(crate) fn serve(request: &AuditRequest, host: &dyn Host) -> Result<AuditAnswer, Refusal> {
    let instance =
        Instance::new(request.scene.clone()).map_err(|faults| Refusal::Scene { faults })?;
    let report = check(&instance, &request.plan);
    let objective = request.objective.clone();
    let audited = instance.clone();
    let mut task = SolveTask::new(audited, objective, request.within, request.limits, host);
    let own = report.costs.filter(|_| report.is_valid());
    if own.is_some() {
        task.start = Some(request.plan.clone());
    }
    let at_least = own.map_or(0, |costs| costs.makespan);
    let mut search = best(&task, at_least);
    let beside = (own.as_ref(), &task.objective);
    assumed::weaken_beside(&instance, beside, &mut search);
    Ok(conclude(task.objective, report, search))
}

/// The best plan, as far as it is found, among those that take no longer than the
/// horizon or than the audited plan.
fn best(task: &SolveTask, at_least: u32) -> SolveAnswer {
    let problem = match Problem::new(&task.instance, &task.budget) {
        Ok(problem) => problem,
        Err(error) => return solve::without_search(task, &error).answer,
    };
    let within = task.within.map(|within| within.max(at_least));
    let horizon = Horizon::of(&problem, task.instance.grid(), within, at_least);
    let lone = lone_bounds(task, &problem);
    let bounded = Bounded {
        horizon,
        limits: BTreeMap::new(),
    };
    let verdict = solve::best(task, &problem, &bounded);
    let mut answer = solve::answer(task, &problem, verdict).answer;
    if matches!(answer.status, Status::Feasible | Status::Unknown) {
        // It ended early: what it proved up to then, and how far that reaches.
        for (&cost, bound) in &lone {
            let known = answer.bounds.entry(cost).or_default();
            *known = bound.at_least().max(*known);
        }
        let reach = reach_of_bounds(&problem, horizon, &task.objective, &answer.bounds, &lone);
        answer.reach = reach.into();
    }
    answer
}

/// The least that each agent needs alone, reported to the host at once: of the first cost, and of those that
/// follow without further work.
fn lone_bounds(task: &SolveTask, problem: &Problem) -> BTreeMap<Cost, LoneBound> {
    let mut bounds = BTreeMap::new();
    for (i, &cost) in task.objective.costs().iter().enumerate() {
        if i > 0 && !matches!(cost, Cost::Makespan | Cost::SumOfCosts) {
            continue;
        }
        let Ok(bound) = Minima::default().bound(problem, cost, &task.budget) else {
            break; // the budget is spent, for the search, too
        };
        let at_least = bound.at_least();
        task.budget.report(&Progress::Bound { cost, at_least });
        bounds.insert(cost, bound);
    }
    bounds
}
