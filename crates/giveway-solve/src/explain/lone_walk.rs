//! The walk of one agent alone that breaks the fewest rules against the plan of all others.

use std::rc::Rc;

use giveway_model::{Condition, Instance, Plan};

use crate::{
    budget::{Budget, Stop},
    impose::ImposeError,
    local::{OtherAgents, Query, Reservations, plan_one},
    problem::{Problem, ProblemError, Relaxed},
    single::Bounds,
    terrain::{Terrain, Vertex},
    walk::Walk,
};

/// The problem with all agents but one, by its index, bound to their paths in a plan. Their exact
/// tables, which take most of the time on a large floor, are then as small as the paths. Where an
/// agent cannot be bound, no agent is. `None` where the agent itself has no walk.
pub(crate) fn problem_of_one(
    instance: &Instance,
    plan: &Plan,
    (agent, condition): (usize, Option<&Condition>),
    budget: &Budget,
) -> Option<Problem> {
    let terrain = Terrain::new(instance.grid());
    let along = |name: &str| {
        let cells = plan.path(name).iter().flatten();
        let mut path: Vec<Vertex> = cells.filter_map(|&cell| terrain.vertex(cell)).collect();
        path.dedup();
        Bounds::Along(Rc::new(path))
    };
    let agents = instance.agents().iter().enumerate();
    let bounds = agents.map(|(index, it)| {
        if index == agent {
            Bounds::Free
        } else {
            along(&it.name)
        }
    });
    let held = (Relaxed::default(), bounds.collect());
    match Problem::under(instance, held, condition, budget) {
        Ok(problem) => Some(problem),
        Err(ImposeError::Problem(ProblemError::Alone(other, _))) if other != agent => {
            Problem::relaxed(instance, Relaxed::default(), condition, budget).ok()
        }
        Err(_) => None,
    }
}

/// Of the earliest walks of an agent alone that arrive by a time, one that breaks the fewest
/// rules against the walks of the others as they are; `None` where there is no such walk.
/// `walks` are those of all agents.
pub(crate) fn lone_walk(
    problem: &Problem,
    walks: &[Walk],
    (agent, latest): (usize, u32),
    budget: &Budget,
) -> Result<Option<Walk>, Stop> {
    let mut others = Reservations::new(problem);
    for (i, walk) in walks.iter().enumerate().filter(|&(i, _)| i != agent) {
        others.add(i, walk);
    }
    let query = Query {
        agent,
        latest,
        conflict_penalty: Some(0),
        expansion_limit: u32::MAX,
    };
    let found = plan_one(problem, &others, query, budget)?;
    Ok(found.map(|(walk, _)| walk))
}

/// A plan with the way of one agent taken from another.
pub(crate) fn replaced(plan: &Plan, agent: &str, other: &Plan) -> Plan {
    let mut plan = plan.clone();
    plan.paths
        .insert(agent.to_owned(), other.path(agent).to_vec());
    let charges = other.charges(agent).to_vec();
    if charges.is_empty() {
        plan.charges.remove(agent);
    } else {
        plan.charges.insert(agent.to_owned(), charges);
    }
    plan
}
