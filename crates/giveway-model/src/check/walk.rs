//! One agent's path, cut at its arrival.

use crate::agent::ends_with_rest;
use crate::{Agent, Cell, Instance, Plan};

/// The path of an agent up to its arrival, where it has one.
///
/// It has at least one entry, and the last is a cell. The path may break any
/// rule otherwise: it may begin in transit or end elsewhere than at the goal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Walk<'a> {
    /// The agent's index in the instance.
    pub(crate) index: usize,
    /// The agent.
    pub(crate) agent: &'a Agent,
    /// Where it is at each time up to its arrival.
    pub(crate) path: &'a [Option<Cell>],
    /// The times at which the plan says that it charges, as listed.
    pub(crate) charges: &'a [u32],
}

impl<'a> Walk<'a> {
    /// The walk of an agent; `None` where the plan gives it no cell at all.
    pub(crate) fn of(instance: &'a Instance, index: usize, plan: &'a Plan) -> Option<Self> {
        let agent = instance.agents().get(index)?;
        let path = cut(plan.path(&agent.name), agent.goal);
        (!path.is_empty()).then(|| Self {
            index,
            agent,
            path,
            charges: plan.charges(&agent.name),
        })
    }

    /// The walk of an agent by its name.
    pub(crate) fn named(instance: &'a Instance, name: &str, plan: &'a Plan) -> Option<Self> {
        let index = instance.agents().iter().position(|a| a.name == name)?;
        Self::of(instance, index, plan)
    }

    /// The walks of all agents that have one.
    pub(crate) fn all(instance: &'a Instance, plan: &'a Plan) -> Vec<Self> {
        (0..instance.agents().len())
            .filter_map(|index| Self::of(instance, index, plan))
            .collect()
    }

    /// The arrival: the time of the last entry.
    pub(crate) const fn arrival(&self) -> usize {
        self.path.len().saturating_sub(1)
    }

    /// Where the agent is at a time up to its arrival; `None` in transit.
    pub(crate) fn at(&self, time: usize) -> Option<Cell> {
        self.path.get(time).copied().flatten()
    }

    /// The cell of the last entry.
    pub(crate) fn end(&self) -> Option<Cell> {
        self.at(self.arrival())
    }
}

/// Cuts what follows the arrival: `null` at the end, which is a fault told
/// elsewhere, and repeats of the cell where it rests.
fn cut(mut path: &[Option<Cell>], goal: Option<Cell>) -> &[Option<Cell>] {
    while let [rest @ .., None] = path {
        path = rest;
    }
    while let [rest @ .., _] = path
        && ends_with_rest(path, goal)
    {
        path = rest;
    }
    path
}
