//! Conditions, imposed on a problem.
//!
//! Most of a condition becomes part of one agent's task, as an
//! [`Automaton`](crate::single::Automaton) over its mask; a limit on a cost of the
//! whole plan is one of the search; which of two agents comes first at a cell is the
//! one thing between agents. Names and cells are looked up anew in each instance,
//! since explanations ask about edited ones, too, with other agents and other
//! obstacles.

mod task;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use giveway_model::{Condition, Cost, Instance};

use crate::{
    budget::Budget,
    encode::collisions::AgentId,
    problem::{NeverAlone, Problem, ProblemError},
};

pub(crate) use giveway_planners::rules::Precedence;

/// The proof that no plan, of whatever makespan, meets a condition: an agent would have
/// to be where nobody can be, or something would have to cost less than nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unmeetable(());

/// Why a condition cannot be imposed.
pub(crate) enum ImposeError {
    /// The instance has no agent of that name.
    NoAgent,
    /// The agent alone cannot meet it, or there is no problem at all.
    Problem(ProblemError),
}

impl<E: Into<ProblemError>> From<E> for ImposeError {
    fn from(error: E) -> Self {
        Self::Problem(error.into())
    }
}

/// The agent whose task a condition becomes part of; `None` where it limits a cost of
/// the whole plan, or is a rule, which becomes one of the instance's own ([`with_rules`]).
///
/// # Errors
/// [`ImposeError::NoAgent`] where the instance has no such agent, or any agent would do:
/// see [`ways`].
pub(crate) fn bearer(
    condition: &Condition,
    instance: &Instance,
) -> Result<Option<AgentId>, ImposeError> {
    let name = match condition {
        Condition::Below { agent: None, .. } | Condition::Keeps(_) => return Ok(None),
        Condition::Visit { agent: None, .. } => return Err(ImposeError::NoAgent),
        Condition::Never { agent, .. }
        | Condition::Visit {
            agent: Some(agent), ..
        }
        | Condition::Move { agent, .. }
        | Condition::Charge { agent, .. }
        | Condition::Below {
            agent: Some(agent), ..
        } => agent,
        // The second need not be there.
        Condition::Before { first, .. } => &first.agent,
    };
    let agent = number(instance, name).ok_or(ImposeError::NoAgent)?;
    Ok(Some(agent))
}

fn number(instance: &Instance, name: &str) -> Option<AgentId> {
    let mut agents = instance.agents().iter();
    agents.position(|agent| agent.name == name)
}

/// Makes a problem keep to a condition, limits on costs of the whole plan apart.
///
/// # Errors
/// Where the agent alone cannot or does not exist, or the budget is spent.
pub(crate) fn impose(
    condition: &Condition,
    instance: &Instance,
    problem: &mut Problem,
    budget: &Budget,
) -> Result<(), ImposeError> {
    let Some(agent) = bearer(condition, instance)? else {
        return Ok(()); // see `limit_costs`
    };
    let mut task = problem.tasks[agent].clone();
    let precedence = task::require(condition, instance, problem, agent, &mut task)
        .map_err(|error| ProblemError::Alone(agent, NeverAlone::Condition(error)))?;
    problem.precedences.extend(precedence);
    Ok(problem.add(agent, task, budget)?)
}

/// The instance with the rules that are conditions; `None` where no condition is a rule.
pub(crate) fn with_rules<'a>(
    instance: &Instance,
    conditions: impl IntoIterator<Item = &'a Condition>,
) -> Option<Instance> {
    let rules = conditions
        .into_iter()
        .filter_map(|condition| match condition {
            Condition::Keeps(rule) => Some(rule),
            Condition::Never { .. }
            | Condition::Visit { .. }
            | Condition::Move { .. }
            | Condition::Charge { .. }
            | Condition::Before { .. }
            | Condition::Below { .. } => None,
        });
    let mut with: Option<Instance> = None;
    for rule in rules {
        let before = with.take().unwrap_or_else(|| instance.clone());
        with = Some(before.with_rule(rule));
    }
    with
}

/// Adds the limit that a condition sets a cost of the whole plan to others.
///
/// # Errors
/// Where no plan can keep it: nothing costs less than nothing.
pub(crate) fn limit_costs(
    condition: &Condition,
    limits: &mut BTreeMap<Cost, u32>,
) -> Result<(), Unmeetable> {
    match condition {
        Condition::Below {
            agent: None,
            cost,
            limit,
        } => {
            let most = limit.checked_sub(1).ok_or(Unmeetable(()))?;
            let limit = limits.entry(*cost).or_insert(most);
            *limit = most.min(*limit);
        }
        Condition::Below { agent: Some(_), .. }
        | Condition::Never { .. }
        | Condition::Visit { .. }
        | Condition::Move { .. }
        | Condition::Charge { .. }
        | Condition::Before { .. }
        | Condition::Keeps(_) => {}
    }
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
        | Condition::Below { .. }
        | Condition::Keeps(_)) => Ok(vec![condition]),
    }
}
