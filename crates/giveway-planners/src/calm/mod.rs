//! Calm plans: among plans of equal cost, one that drives no more than it needs to.
//!
//! A proof of the best costs says nothing of how they are reached: an agent that has
//! time to spare may drive back and forth instead of waiting. [`calm`] improves such a
//! plan by local search: one agent after the other, then small groups, are planned anew
//! among the others by [`Driving`]. No cost of the objective becomes higher. Work is
//! limited in states, not in time, so that the same plan is found on every machine.

mod allowance;
mod driving;
mod group;
mod label;
mod search;
#[cfg(test)]
mod tests;

use std::cmp::Reverse;
use std::collections::BTreeSet;

use giveway_model::{Costs, Objective, sorting::sort_by_key};

use crate::{
    AgentId,
    budget::{Budget, CountedBudget, Stop, Unlimited},
    local::{OtherAgents, Reservations},
    problem::Problem,
    walk::{Walk, arrival, costs},
};
use allowance::Allowance;
pub use driving::Driving;
use search::{Found, Query};

/// States to look at in all: for few agents, for each further one, and at most.
const STATES: u64 = 300_000;
const STATES_PER_AGENT: u64 = 2_000;
const MOST_STATES: u64 = 600_000;
/// States to look at for one agent at once.
const EXPANSION_LIMIT: u32 = 100_000;

/// A plan with the same costs in the objective, or lower ones, that is at least as calm.
/// Only the agents that `may_change` get other walks. A plan for which nothing better is
/// found within the limit of work is returned as it is.
///
/// The walks must be free of collisions.
pub fn calm(
    problem: &Problem,
    walks: &[Walk],
    objective: &Objective,
    may_change: impl Fn(AgentId) -> bool,
) -> Vec<Walk> {
    let agents = problem.agents() as u64;
    let states = (STATES + STATES_PER_AGENT * agents).min(MOST_STATES);
    let unlimited = Unlimited::default();
    let budget = CountedBudget::new(&unlimited, states);
    let mut plan = Plan::new(problem, walks, objective);
    let changeable: Vec<AgentId> = (0..walks.len())
        .filter(|&agent| may_change(agent))
        .collect();
    // An error only says that the work is done.
    let _ = plan.improve(&changeable, &budget);
    let before = costs(problem, walks);
    let after = costs(problem, &plan.walks);
    if plan.is_as_cheap(&before, &after)
        && Driving::of_all(problem, &plan.walks) < Driving::of_all(problem, walks)
    {
        plan.walks
    } else {
        walks.to_vec()
    }
}

/// A plan under improvement.
struct Plan<'p> {
    problem: &'p Problem,
    objective: &'p Objective,
    walks: Vec<Walk>,
    others: Reservations<'p>,
    /// No agent arrives later than this.
    makespan: u32,
    /// Agents for which no calmer walk is known to exist, while those that were in their way
    /// keep their walks.
    settled: Vec<Option<BTreeSet<AgentId>>>,
}

impl<'p> Plan<'p> {
    fn new(problem: &'p Problem, walks: &[Walk], objective: &'p Objective) -> Self {
        Self {
            problem,
            objective,
            walks: walks.to_vec(),
            others: Reservations::of(problem, walks),
            makespan: walks.iter().map(|walk| arrival(walk)).max().unwrap_or(0),
            settled: vec![None; walks.len()],
        }
    }

    /// Whether no cost of the objective is higher.
    fn is_as_cheap(&self, before: &Costs, after: &Costs) -> bool {
        let mut costs = self.objective.costs().iter();
        costs.all(|&cost| after.get(cost) <= before.get(cost))
    }

    /// Plans single agents anew until none of them gets calmer, then groups.
    fn improve(&mut self, agents: &[AgentId], budget: &dyn Budget) -> Result<(), Stop> {
        loop {
            self.improve_each(agents, budget)?;
            if !self.improve_groups(agents, budget)? {
                return Ok(());
            }
        }
    }

    /// Plans one agent after the other, those that drive furthest out of their way first,
    /// until none of them gets calmer.
    fn improve_each(&mut self, agents: &[AgentId], budget: &dyn Budget) -> Result<(), Stop> {
        let mut order = agents.to_vec();
        sort_by_key(&mut order, |&agent| (Reverse(self.excess(agent)), agent));
        loop {
            let mut better = false;
            for &agent in &order {
                better |= self.settled[agent].is_none() && self.improve_one(agent, budget)?;
            }
            if !better {
                return Ok(());
            }
        }
    }

    /// Plans an agent anew among all others; true where it got calmer.
    fn improve_one(&mut self, agent: AgentId, budget: &dyn Budget) -> Result<bool, Stop> {
        let old = self.driving(agent);
        if self.excess(agent) == 0 && (old.waits, old.turns) == (0, 0) {
            return Ok(false);
        }
        let query = Query {
            agent,
            allowance: self.allowance(agent),
            calmer_than: Some(old),
            expansion_limit: EXPANSION_LIMIT,
        };
        self.others.remove(agent, &self.walks[agent]);
        let found = search::plan_one(self.problem, &self.others, query, budget);
        self.others.add(agent, &self.walks[agent]);
        let Found { walk, blockers } = found?;
        let better = walk.is_some();
        if let Some(walk) = walk {
            self.others.remove(agent, &self.walks[agent]);
            self.others.add(agent, &walk);
            self.replace(agent, walk);
        }
        self.settled[agent] = Some(blockers);
        Ok(better)
    }

    /// Gives an agent a walk that is among the others already. Those whose way it was in
    /// may get calmer now.
    fn replace(&mut self, agent: AgentId, walk: Walk) {
        self.walks[agent] = walk;
        for (other, settled) in self.settled.iter_mut().enumerate() {
            if other == agent
                || settled
                    .as_ref()
                    .is_some_and(|blockers| blockers.contains(&agent))
            {
                *settled = None;
            }
        }
    }

    /// The costs that an agent may have: no higher than those of its walk, where they
    /// count.
    fn allowance(&self, agent: AgentId) -> Allowance {
        Allowance::new(self, agent)
    }

    fn driving(&self, agent: AgentId) -> Driving {
        Driving::of(self.problem, &self.walks[agent])
    }

    /// The steps in motion beyond those that an agent alone needs.
    fn excess(&self, agent: AgentId) -> u32 {
        let task = &self.problem.tasks[agent];
        let cost_to_go = &self.problem.cost_to_go[agent];
        // (The steps alone are all in motion: a battery is never fuller after a wait.)
        let least = cost_to_go.from(task.start, task.first_mask(), task.first_level());
        let least = least.map_or(0, |least| least + task.delay());
        self.driving(agent).motion.saturating_sub(least)
    }
}
