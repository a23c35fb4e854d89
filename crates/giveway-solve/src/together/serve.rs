//! A request about some agents, from the scene to the answer.

use std::rc::Rc;

use giveway_model::{Agent, Fault, Instance, Objective, Scene, Version};

use super::{
    Alone, Region, TogetherAnswer, TogetherRequest,
    keep::{can_keep, is_time},
    meet::Meetings,
    ways::Ways,
};
use crate::{
    Host, Limits, Refusal,
    budget::{Budget, Stop},
    problem::Problem,
    solve::{self, SolveTask},
};

/// More agents are not searched for by themselves: nobody could follow the proof.
const MOST_ALONE: usize = 4;

/// Serves a request about some agents.
///
/// # Errors
/// When the scene is no instance, or the request names no agents, one that is none, or
/// one twice.
pub(crate) fn serve(request: &TogetherRequest, host: &dyn Host) -> Result<TogetherAnswer, Refusal> {
    let refused = |faults| Refusal::Scene { faults };
    let whole = Instance::new(request.scene.clone()).map_err(refused)?;
    let objective = Objective::new(vec![request.cost])
        .map_err(|error| request_fault("cost", error.to_string(), "a cost"))?;
    let mut scene = Scene {
        agents: named(request, &whole)?,
        objective: objective.clone(),
        ..whole.to_scene()
    };
    // Rules hold among these agents, and one about others alone says nothing.
    scene.settle_rules(whole.grid());
    let instance = Instance::new(scene).map_err(refused)?;
    let budget = Budget::new(host, request.limits);
    let (regions, meetings) = ways(request, &instance, &budget);
    let alone =
        (request.agents.len() <= MOST_ALONE).then(|| alone(request, instance, objective, &budget));
    Ok(TogetherAnswer {
        giveway: Version,
        regions,
        passes: meetings.passes,
        meetings: meetings.meetings,
        alone,
    })
}

fn request_fault(at: &str, found: String, expected: &str) -> Refusal {
    Refusal::Request {
        fault: Fault::at(at, found, expected),
    }
}

/// The agents of a request, in its order.
fn named(request: &TogetherRequest, whole: &Instance) -> Result<Vec<Agent>, Refusal> {
    if request.agents.is_empty() {
        return Err(request_fault(
            "agents",
            "none".to_owned(),
            "a robot or more",
        ));
    }
    let mut agents: Vec<Agent> = Vec::new();
    for (i, limit) in request.agents.iter().enumerate() {
        let refuse = |found: String, expected: &str| {
            Err(request_fault(
                &format!("agents[{i}].agent"),
                found,
                expected,
            ))
        };
        let name = &limit.agent;
        let Some(agent) = whole.agents().iter().find(|agent| agent.name == *name) else {
            return refuse(format!("\"{name}\""), "the name of a robot");
        };
        if agents.iter().any(|agent| agent.name == *name) {
            return refuse(format!("\"{name}\" again"), "each robot once");
        }
        agents.push(agent.clone());
    }
    Ok(agents)
}

/// Where each can be, and where they collide.
fn ways(
    request: &TogetherRequest,
    instance: &Instance,
    budget: &Budget,
) -> (Vec<Region>, Meetings) {
    match try_ways(request, instance, budget) {
        Ok(Some(found)) => found,
        _ => (Vec::new(), Meetings::default()),
    }
}

fn try_ways(
    request: &TogetherRequest,
    instance: &Instance,
    budget: &Budget,
) -> Result<Option<(Vec<Region>, Meetings)>, Stop> {
    if !is_time(request.cost) {
        return Ok(None);
    }
    let Ok(problem) = Problem::new(instance, budget) else {
        return Ok(None);
    };
    let default = || problem.default_horizon(instance.grid());
    let horizon = request.within.unwrap_or_else(default);
    let mut all = Vec::new();
    for (agent, limit) in request.agents.iter().enumerate() {
        let by = limit.at_most.min(horizon);
        all.push(Ways::of(&problem, agent, by, budget)?);
    }
    let names = request.agents.iter().map(|limit| limit.agent.as_str());
    let agents: Vec<(&str, &Ways)> = names.zip(&all).collect();
    let terrain = &problem.terrain;
    let regions = agents.iter().map(|(name, ways)| ways.region(name, terrain));
    Ok(Some((regions.collect(), Meetings::of(&agents, terrain))))
}

/// The search for the agents alone, once for any plan that keeps the limits, and once
/// for the best, told as a trace.
fn alone(
    request: &TogetherRequest,
    instance: Instance,
    objective: Objective,
    budget: &Budget,
) -> Alone {
    let part = Rc::new(budget.part(Limits::default()));
    let can_keep = can_keep(request, &instance, &objective, &part);
    budget.absorb(&part);
    let scene = instance.to_scene();
    let task = SolveTask {
        instance,
        objective,
        within: request.within,
        start: None,
        as_found: false,
        budget: part,
    };
    let task = task.traced(budget.part(Limits::default()));
    Alone {
        scene,
        solved: solve::solve(&task).answer,
        refuted: can_keep.map(|can_keep| !can_keep),
    }
}
