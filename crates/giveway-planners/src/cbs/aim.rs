//! The cost that CBS makes least, and the claims that it alone can prove about it.
//!
//! The claims have no public constructor: nothing but the constraint tree of
//! this folder can say that a plan is best, or that none costs less.

use giveway_model::{Cost, Objective};

use crate::{AgentId, problem::Problem};

/// A cost that conflict-based search can make least.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CbsCost {
    /// The latest arrival.
    Makespan,
    /// The sum of arrivals.
    SumOfCosts,
}

impl CbsCost {
    /// The first cost of an objective, where it is one of these.
    ///
    /// # Errors
    /// That cost, where it is another.
    pub fn of(objective: &Objective) -> Result<Self, Cost> {
        match objective.costs().first() {
            None | Some(Cost::Makespan) => Ok(Self::Makespan),
            Some(Cost::SumOfCosts) => Ok(Self::SumOfCosts),
            Some(&other) => Err(other),
        }
    }

    /// The cost.
    pub const fn cost(self) -> Cost {
        match self {
            Self::Makespan => Cost::Makespan,
            Self::SumOfCosts => Cost::SumOfCosts,
        }
    }

    /// The cost of arrivals at these times, one for each agent.
    pub(super) fn of_arrivals(self, problem: &Problem, arrivals: impl Iterator<Item = u32>) -> u32 {
        match self {
            Self::Makespan => arrivals.max().unwrap_or(0),
            Self::SumOfCosts => arrivals
                .enumerate()
                .map(|(agent, arrival)| own_cost(problem, agent, arrival))
                .sum(),
        }
    }

    /// The least that a plan can cost in which some agent arrives after the
    /// horizon, where none was looked for.
    fn beyond(self, problem: &Problem, horizon: u32) -> u32 {
        let late = horizon.saturating_add(1);
        match self {
            Self::Makespan => late,
            Self::SumOfCosts => {
                let agents = 0..problem.agents();
                let least = |agent| problem.least_cost(agent);
                let sum: u32 = agents.clone().map(least).sum();
                let costs = agents.map(|agent| {
                    let others = sum - least(agent);
                    others.saturating_add(own_cost(problem, agent, late))
                });
                costs.min().unwrap_or(u32::MAX)
            }
        }
    }
}

/// The share of an agent's arrival in the sum of costs.
fn own_cost(problem: &Problem, agent: AgentId, arrival: u32) -> u32 {
    match arrival {
        0 => 0,
        arrival => arrival.saturating_add(problem.tasks[agent].cost_if_it_leaves_goal),
    }
}

/// No plan costs less, whatever its makespan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LowerBound {
    cost: Cost,
    at_least: u32,
}

impl LowerBound {
    /// From the least cost of what is open in the constraint tree.
    pub(super) fn new(problem: &Problem, aim: CbsCost, open: Option<u32>, horizon: u32) -> Self {
        let beyond = aim.beyond(problem, horizon);
        Self {
            cost: aim.cost(),
            at_least: open.map_or(beyond, |open| open.min(beyond)),
        }
    }

    /// The cost that is bounded.
    pub const fn cost(self) -> Cost {
        self.cost
    }

    /// Its least value.
    pub const fn at_least(self) -> u32 {
        self.at_least
    }
}

/// No plan costs less than the one that was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Proved {
    bound: LowerBound,
    least: u32,
    horizon: u32,
}

impl Proved {
    /// The plan is the first of the open list without a conflict.
    pub(super) fn new(problem: &Problem, aim: CbsCost, least: u32, horizon: u32) -> Self {
        Self {
            bound: LowerBound::new(problem, aim, Some(least), horizon),
            least,
            horizon,
        }
    }

    /// The bound at every horizon; less than the plan's cost only where [`Proved::within`] says so.
    pub const fn bound(self) -> LowerBound {
        self.bound
    }

    /// The makespan up to which no plan costs less; `None` where none does at all.
    pub fn within(self) -> Option<u32> {
        (self.bound.at_least < self.least).then_some(self.horizon)
    }
}
