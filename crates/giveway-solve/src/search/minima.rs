//! The least of each cost that each agent needs alone.

use std::collections::BTreeMap;

use giveway_model::Cost;

use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    problem::Problem,
    single::{CostToGo, Metric},
};

/// The least that an agent alone can have of a cost, from exact tables: so it holds at
/// any horizon. A table is made once.
#[derive(Default)]
pub(crate) struct Minima(BTreeMap<(AgentId, Cost), u32>);

/// The bound from the minima of all agents: no plan of any makespan has less of a cost. Only [`Minima`] makes
/// it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LoneBound(u32);

/// The proof that a bound is one that the agents need alone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NeededAlone(());

/// The proof that no plan keeps a limit, of whatever makespan: what agents need alone is
/// above it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LimitTooLow(());

impl Minima {
    /// The least of one agent.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn of(
        &mut self,
        problem: &Problem,
        agent: AgentId,
        cost: Cost,
        budget: &Budget,
    ) -> Result<u32, Stop> {
        if let Some(least) = self.known(problem, agent, cost) {
            return Ok(least);
        }
        let task = &problem.tasks[agent];
        let metric = match cost {
            Cost::Charges => task.reserve.is_some().then_some(Metric::Charges),
            Cost::Moves => Some(Metric::Moves),
            Cost::Waits | Cost::Makespan | Cost::SumOfCosts | Cost::Penalty => None,
        };
        let least = match metric {
            None => 0,
            Some(metric) => CostToGo::new(task, &problem.terrain, metric, budget)?
                .from(task.start, task.first_mask(), task.first_level())
                .unwrap_or(0),
        };
        self.0.insert((agent, cost), least);
        Ok(least)
    }

    /// The same as a bound on what this agent has in any plan.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn of_one(
        &mut self,
        problem: &Problem,
        agent: AgentId,
        cost: Cost,
        budget: &Budget,
    ) -> Result<LoneBound, Stop> {
        self.of(problem, agent, cost, budget).map(LoneBound)
    }

    /// The least of one agent, where it takes no table, or the table was made before.
    pub(crate) fn known(&self, problem: &Problem, agent: AgentId, cost: Cost) -> Option<u32> {
        match cost {
            Cost::Makespan => Some(problem.optima[agent]),
            Cost::SumOfCosts => Some(problem.least_cost(agent)),
            // A lower bound: zones to be avoided may be on each way.
            Cost::Penalty => Some(problem.tasks[agent].penalty_of_time(0, problem.optima[agent])),
            Cost::Charges | Cost::Moves | Cost::Waits => self.0.get(&(agent, cost)).copied(),
        }
    }

    /// The bound of all agents together: of the makespan the largest minimum, of other costs the sum.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn bound(
        &mut self,
        problem: &Problem,
        cost: Cost,
        budget: &Budget,
    ) -> Result<LoneBound, Stop> {
        let mut bound: u32 = 0;
        for agent in 0..problem.agents() {
            let least = self.of(problem, agent, cost, budget)?;
            bound = match cost {
                Cost::Makespan => bound.max(least),
                Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => {
                    bound.saturating_add(least)
                }
            };
        }
        Ok(LoneBound(bound))
    }
}

impl LoneBound {
    /// The bound.
    pub(crate) const fn at_least(self) -> u32 {
        self.0
    }

    /// Whether it shows that no plan has less than this.
    pub(crate) fn shows(self, bound: u32) -> Option<NeededAlone> {
        (bound <= self.0).then_some(NeededAlone(()))
    }

    /// The slack of a limit beyond the bound.
    ///
    /// # Errors
    /// When the limit is below it.
    pub(crate) fn spare(self, limit: u32) -> Result<u32, LimitTooLow> {
        limit.checked_sub(self.0).ok_or(LimitTooLow(()))
    }
}
