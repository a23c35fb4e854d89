//! The walk of one agent alone that breaks the fewest rules against the plan of all others.

use giveway_model::Plan;

use crate::{
    budget::{Budget, Stop},
    local::{OtherAgents, Query, Reservations, plan_one},
    problem::Problem,
    walk::Walk,
};

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
