//! Constraints in force, and the agents that they bind.

use std::collections::BTreeMap;

use super::{Constraint, ConstraintKind};
use crate::Agent;
use crate::sorting::{map, set};

/// A constraint in force, with the agents that it binds.
#[derive(Clone, Debug)]
pub struct InForce<'a> {
    /// Its number in the scene, from 0.
    pub index: usize,
    /// The constraint.
    pub constraint: &'a Constraint,
    /// The agents that it binds, by their numbers in the instance, ascending. Of a
    /// precedence both.
    pub agents: Vec<usize>,
}

/// Those of some constraints that are in force among these agents, in their order.
pub(crate) fn in_force<'a>(
    constraints: &'a [Constraint],
    agents: &'a [Agent],
) -> impl Iterator<Item = InForce<'a>> {
    let named = agents.iter().enumerate();
    let named = named.filter(|_| !constraints.is_empty());
    let numbers: BTreeMap<&str, usize> =
        map(named.map(|(number, agent)| (agent.name.as_str(), number)));
    let constraints = constraints.iter().enumerate();
    constraints.filter_map(move |(index, it)| {
        let number = |name: &str| numbers.get(name).copied();
        it.in_force_among(index, &number, || (0..agents.len()).collect())
    })
}

impl Constraint {
    /// The constraint as it holds among some agents; `None` where it is off, or none of
    /// those that it binds is there (of a precedence, where either is not).
    pub fn in_force(&self, index: usize, agents: &[Agent]) -> Option<InForce<'_>> {
        self.in_force_among(
            index,
            &|name| agents.iter().position(|it| it.name == name),
            || (0..agents.len()).collect(),
        )
    }

    /// The same among agents that have numbers by their names; `all` are their numbers.
    pub(crate) fn in_force_among(
        &self,
        index: usize,
        number: &dyn Fn(&str) -> Option<usize>,
        all: impl Fn() -> Vec<usize>,
    ) -> Option<InForce<'_>> {
        let bound = match (&self.kind, &self.agents) {
            (ConstraintKind::Sequence { agent, .. }, _) => vec![number(agent)?],
            (ConstraintKind::Before { first, second }, _) => {
                let (first, second) = (number(&first.agent)?, number(&second.agent)?);
                Vec::from_iter(set([first, second]))
            }
            (_, None) => all(),
            (_, Some(names)) => Vec::from_iter(set(names.iter().filter_map(|name| number(name)))),
        };
        let is_in_force = !self.off && !bound.is_empty();
        is_in_force.then_some(InForce {
            index,
            constraint: self,
            agents: bound,
        })
    }
}
