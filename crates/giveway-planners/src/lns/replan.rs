//! A plan, a few agents of which are planned anew.

use giveway_model::{Cost, Costs, Objective};

use super::tally::PlanCosts;
use crate::{
    AgentId,
    budget::{Budget, Stop},
    local::{OtherAgents, Query},
    problem::Problem,
    walk::{Walk, arrival, costs_of},
};

/// States to look at for one agent.
const EXPANSION_LIMIT: u32 = 20_000;

/// A plan under improvement.
pub(super) struct Plan<'a, O> {
    pub(super) others: O,
    pub(super) walks: &'a mut [Walk],
    objective: &'a Objective,
    horizon: u32,
    pub(super) tally: PlanCosts,
}

impl<'a, O: OtherAgents> Plan<'a, O> {
    /// A plan, with the walks of all agents as those of others.
    pub(super) fn new(
        others: O,
        walks: &'a mut [Walk],
        objective: &'a Objective,
        horizon: u32,
    ) -> Self {
        let tally = PlanCosts::new(others.problem(), walks);
        Self {
            others,
            walks,
            objective,
            horizon,
            tally,
        }
    }

    pub(super) fn problem(&self) -> &Problem {
        self.others.problem()
    }

    /// How much later an agent arrives than it would alone.
    pub(super) fn delay(&self, agent: AgentId) -> u32 {
        let optimum = self.problem().optima[agent];
        arrival(&self.walks[agent]).saturating_sub(optimum)
    }

    /// The costs of all, in the order of the objective.
    pub(super) fn vector(&self) -> Vec<u32> {
        self.tally.all().vector(self.objective)
    }

    /// The first cost of the objective.
    pub(super) fn first_cost(&self) -> u32 {
        self.vector().first().copied().unwrap_or(0)
    }

    /// Plans each agent anew, until nobody gains by it or the budget is spent; true where the
    /// plan became better.
    pub(super) fn descend(mut self, budget: &dyn Budget) -> bool {
        let first = self.vector();
        loop {
            let before = self.vector();
            for agent in 0..self.walks.len() {
                // Who arrives as early as alone gains nothing.
                if self.delay(agent) > 0 && self.replan(&[agent], Tie::Before, budget).is_err() {
                    return self.vector() < first;
                }
            }
            if self.vector() >= before {
                return before < first;
            }
        }
    }

    /// Plans some agents anew, one after the other; keeps what was where the new
    /// is worse. How much the first cost has become less.
    pub(super) fn replan(
        &mut self,
        group: &[AgentId],
        tie: Tie,
        budget: &dyn Budget,
    ) -> Result<u32, Stop> {
        let before = self.vector();
        let old: Vec<(Walk, Costs)> = group
            .iter()
            .map(|&agent| {
                (
                    std::mem::take(&mut self.walks[agent]),
                    self.tally.own(agent),
                )
            })
            .collect();
        for (&agent, (walk, _)) in group.iter().zip(&old) {
            self.others.remove(agent, walk);
        }
        let room = self.room(&old, &before);
        let planned = self.plan(group, room, budget);
        if let Ok(true) = planned {
            let after = self.vector();
            if after < before || after == before && tie == Tie::New {
                let (before, after) = (before.first(), after.first());
                return Ok(before
                    .zip(after)
                    .map_or(0, |(before, after)| before - after));
            }
        }
        for &agent in group {
            let walk = std::mem::take(&mut self.walks[agent]);
            if !walk.is_empty() {
                self.others.remove(agent, &walk);
            }
        }
        for (&agent, (walk, costs)) in group.iter().zip(old) {
            self.others.add(agent, &walk);
            self.walks[agent] = walk;
            self.tally.set(self.others.problem(), agent, costs);
        }
        planned.map(|_| 0)
    }

    /// The latest arrivals with which the plan is no worse: later ones are not searched for, which would take
    /// the longest.
    fn room(&self, old: &[(Walk, Costs)], before: &[u32]) -> Room {
        let sum = old.iter().map(|(walk, _)| arrival(walk)).sum();
        let first = before.first().copied().unwrap_or(0);
        match self.objective.costs().first() {
            Some(Cost::SumOfCosts) => Room {
                each: self.horizon,
                sum,
            },
            Some(Cost::Makespan) => Room {
                each: self.horizon.min(first),
                sum: u32::MAX,
            },
            _ => Room {
                each: self.horizon,
                sum: u32::MAX,
            },
        }
    }

    /// Plans agents one after the other around all others; false where one finds
    /// no way within the room.
    fn plan(&mut self, group: &[AgentId], room: Room, budget: &dyn Budget) -> Result<bool, Stop> {
        let optima = |plan: &Self, agent: AgentId| plan.problem().optima[agent];
        let least: u32 = group.iter().map(|&agent| optima(self, agent)).sum();
        let mut spare = room.sum.saturating_sub(least);
        for &agent in group {
            let optimum = optima(self, agent);
            let query = Query {
                agent,
                latest: room.each.min(optimum.saturating_add(spare)),
                conflict_penalty: None,
                expansion_limit: EXPANSION_LIMIT,
            };
            let Some((walk, _)) = self.others.plan(query, budget)? else {
                return Ok(false);
            };
            spare = spare.saturating_sub(arrival(&walk).saturating_sub(optimum));
            self.others.add(agent, &walk);
            let problem = self.others.problem();
            self.tally
                .set(problem, agent, costs_of(problem, agent, &walk));
            self.walks[agent] = walk;
        }
        Ok(true)
    }
}

/// Which of two plans of equal costs is kept.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Tie {
    /// The new one: the search goes on from elsewhere.
    New,
    /// The one before.
    Before,
}

#[derive(Clone, Copy)]
struct Room {
    /// The latest arrival of each.
    each: u32,
    /// The most that the sum of their arrivals may be.
    sum: u32,
}
