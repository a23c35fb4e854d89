//! Conditions, imposed on a problem.
//!
//! Most of a condition becomes part of one agent's task, as an
//! [`Automaton`](crate::single::Automaton) over its mask; a limit on a cost of the
//! whole plan is one of the search; which of two agents comes first at a cell is the
//! one thing between agents. Names and cells are looked up anew in each instance,
//! since explanations ask about edited ones, too, with other agents and other
//! obstacles.

mod precedence;
mod task;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use giveway_model::{Condition, Cost, Instance};

use crate::{
    budget::Budget,
    problem::{HopelessAlone, Problem, ProblemError},
};

pub(crate) use precedence::Precedence;

/// The proof that no plan, of whatever makespan, meets a condition: an agent would have
/// to be where nobody can be, or something would have to cost less than nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unmeetable(());

/// Makes a problem keep to a condition, limits on costs of the whole plan apart.
///
/// # Errors
/// Where the agent alone cannot, or the budget is spent.
pub(crate) fn impose(
    condition: &Condition,
    instance: &Instance,
    problem: &mut Problem,
    budget: &Budget,
) -> Result<(), ProblemError> {
    let number = |name: &str| instance.agents().iter().position(|a| a.name == name);
    let Some(agent) = condition.agent().and_then(number) else {
        return Ok(());
    };
    let impossible = || ProblemError::Alone(agent, HopelessAlone::Condition(Unmeetable(())));
    let mut task = problem.tasks[agent].clone();
    task::require(condition, problem, agent, &mut task).ok_or_else(impossible)?;
    if let Condition::Before { first, second } = condition
        && first.agent != second.agent
        && let Some(other) = number(&second.agent)
        && let Some(there) = problem.terrain.vertex(second.cell)
    {
        let here = problem.terrain.vertex(first.cell).ok_or_else(impossible)?;
        problem.precedences.push(Precedence {
            first: (agent, here),
            second: (other, there),
        });
    }
    Ok(problem.add(agent, task, budget)?)
}

/// Adds the limit that a condition sets a cost of the whole plan to others.
///
/// # Errors
/// Where no plan can keep it: nothing costs less than nothing.
pub(crate) fn limit_costs(
    condition: &Condition,
    limits: &mut BTreeMap<Cost, u32>,
) -> Result<(), Unmeetable> {
    let Condition::Below {
        agent: None,
        cost,
        limit,
    } = condition
    else {
        return Ok(());
    };
    let most = limit.checked_sub(1).ok_or(Unmeetable(()))?;
    let limit = limits.entry(*cost).or_insert(most);
    *limit = most.min(*limit);
    Ok(())
}

/// The conditions one of which holds where this one does: where it is about any agent,
/// one about each of them.
///
/// # Errors
/// Where there is no agent who could meet it.
pub(crate) fn ways(
    condition: Condition,
    instance: &Instance,
) -> Result<Vec<Condition>, Unmeetable> {
    match condition {
        Condition::Visit { agent: None, cell } => {
            let agents = instance.agents().iter();
            let ways: Vec<Condition> = agents
                .map(|agent| Condition::Visit {
                    agent: Some(agent.name.clone()),
                    cell,
                })
                .collect();
            (!ways.is_empty()).then_some(ways).ok_or(Unmeetable(()))
        }
        condition @ (Condition::Never { .. }
        | Condition::Visit { .. }
        | Condition::Move { .. }
        | Condition::Charge { .. }
        | Condition::Before { .. }
        | Condition::Below { .. }) => Ok(vec![condition]),
    }
}
