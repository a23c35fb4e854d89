//! Whether some agents alone can keep their limits: the search asked for any plan that
//! does.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Instance, Objective, check::check};

use super::TogetherRequest;
use crate::{
    Status,
    budget::Budget,
    judged::Judged,
    problem::{Problem, ProblemError},
    search::{Aim, Bounded, Horizon, Proved, find},
    walk::to_plan,
};

/// Whether the limit of a cost is a time to arrive by.
pub(super) const fn is_time(cost: Cost) -> bool {
    matches!(cost, Cost::Makespan | Cost::SumOfCosts)
}

/// Whether the agents of an instance, in the order of the request, can keep their
/// limits; `None` where that was not settled.
pub(super) fn can_keep(
    request: &TogetherRequest,
    instance: &Instance,
    objective: &Objective,
    budget: &Rc<Budget>,
) -> Option<bool> {
    let problem = match limited(request, instance, budget) {
        Ok(problem) => problem,
        Err(ProblemError::Alone(..)) => return Some(false),
        Err(_) => return None,
    };
    let bounded = Bounded {
        horizon: horizon(request, &problem, instance),
        limits: sum(request),
    };
    let aim = Aim::Any;
    let verdict = find(&problem, objective, &bounded, &aim, budget);
    let claim = (verdict.reach, verdict.stop);
    let judged = Judged::new(verdict.best, &aim, claim, |(walks, costs)| {
        let names: Vec<String> = instance.agents().iter().map(|a| a.name.clone()).collect();
        let plan = to_plan(&problem, &names, &walks);
        let report = check(instance, &plan);
        let passes = report.is_valid() && report.costs == Some(costs) && problem.keeps(&walks);
        passes.then_some((plan, costs))
    });
    match judged.status {
        Status::Optimal | Status::Feasible => Some(true),
        // An agent that keeps limits of time arrives up to the horizon.
        Status::Impossible if is_time(request.cost) || request.within.is_some() => Some(false),
        Status::Impossible => judged
            .reach
            .is_some_and(Proved::is_complete)
            .then_some(false),
        Status::Unknown => None,
    }
}

/// The problem with the limit of each agent in its task.
fn limited(
    request: &TogetherRequest,
    instance: &Instance,
    budget: &Budget,
) -> Result<Problem, ProblemError> {
    let mut problem = Problem::new(instance, budget)?;
    for (agent, limit) in request.agents.iter().enumerate() {
        let mut task = problem.tasks[agent].clone();
        task.conditions.limit(request.cost, limit.at_most);
        problem.add(agent, task, budget)?;
    }
    Ok(problem)
}

/// The horizon that the limits need, or what was set.
fn horizon(request: &TogetherRequest, problem: &Problem, instance: &Instance) -> Horizon {
    let last = request.agents.iter().map(|limit| limit.at_most).max();
    let last = last.filter(|_| is_time(request.cost));
    let within = request.within.into_iter().chain(last).min();
    Horizon::of(problem, instance.grid(), within, 0)
}

/// The most that all of them may have together.
fn sum(request: &TogetherRequest) -> BTreeMap<Cost, u32> {
    let mut limits = BTreeMap::new();
    if let Some(more) = request.more.filter(|_| request.cost != Cost::Makespan) {
        let least = request.agents.iter().map(|limit| limit.least);
        let most = least.fold(more, u32::saturating_add);
        limits.insert(request.cost, most);
    }
    limits
}
