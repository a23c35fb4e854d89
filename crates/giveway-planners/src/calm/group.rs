//! Small groups of agents planned anew together, where no single agent gets calmer.
//!
//! An agent that drives out of its way mostly does so for another one: both are taken out
//! of the plan, and planned one after the other in each order.

use super::{
    Driving, EXPANSION_LIMIT, Plan,
    search::{self, Query},
};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    local::{OtherAgents, Reservations},
    walk::{Walk, arrival},
};
use giveway_model::Cost;

/// Up to so many agents, an agent is planned together with each other one, and not only
/// with those in its way.
const FEW: usize = 6;
/// The most agents of a group.
const GROUP: usize = 4;

impl Plan<'_> {
    /// Plans groups around agents that drive out of their way; true as soon as one of them
    /// got calmer.
    pub(super) fn improve_groups(
        &mut self,
        agents: &[AgentId],
        budget: &dyn Budget,
    ) -> Result<bool, Stop> {
        for &agent in agents {
            if self.excess(agent) == 0 {
                continue;
            }
            for group in self.groups(agent, agents, budget)? {
                if self.replan(&group, budget)? {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }

    /// Groups with an agent, in the order in which they are planned.
    fn groups(
        &self,
        agent: AgentId,
        agents: &[AgentId],
        budget: &dyn Budget,
    ) -> Result<Vec<Vec<AgentId>>, Stop> {
        let query = Query {
            agent,
            allowance: self.allowance(agent),
            calmer_than: None,
            expansion_limit: EXPANSION_LIMIT,
        };
        let alone = search::plan_one(
            self.problem,
            &Reservations::new(self.problem),
            query,
            budget,
        )?;
        let met = alone.walk.map(|walk| self.others.met_by(agent, &walk));
        let mut partners: Vec<AgentId> = met.into_iter().flatten().collect();
        if agents.len() <= FEW {
            let more: Vec<AgentId> = agents
                .iter()
                .copied()
                .filter(|other| !partners.contains(other))
                .collect();
            partners.extend(more);
        }
        partners.retain(|other| *other != agent && agents.contains(other));
        let mut groups = Vec::new();
        for &partner in &partners {
            groups.extend([vec![partner, agent], vec![agent, partner]]);
        }
        if partners.len() > 1 {
            partners.truncate(GROUP - 1);
            partners.insert(0, agent);
            groups.extend(if agents.len() <= FEW {
                orders(&partners)
            } else {
                let mut reversed = partners.clone();
                reversed.reverse();
                vec![reversed, partners]
            });
        }
        Ok(groups)
    }

    /// Plans a group anew, one agent after the other; keeps the old walks unless the new
    /// ones are calmer. True where they are.
    fn replan(&mut self, group: &[AgentId], budget: &dyn Budget) -> Result<bool, Stop> {
        let old: Vec<Walk> = group
            .iter()
            .map(|&agent| self.walks[agent].clone())
            .collect();
        for (&agent, walk) in group.iter().zip(&old) {
            self.others.remove(agent, walk);
        }
        let before = Driving::of_all(self.problem, &old);
        let mut new = Vec::new();
        let found = self.plan_group(group, before, &mut new, budget);
        let better = matches!(found, Ok(true));
        for (&agent, walk) in group.iter().zip(&new) {
            self.others.remove(agent, walk);
        }
        for (&agent, walk) in group.iter().zip(if better { new } else { old }) {
            self.others.add(agent, &walk);
            if better {
                self.replace(agent, walk);
            }
        }
        found
    }

    /// The new walks of a group, which are among the others then; false where they are not
    /// calmer together.
    fn plan_group(
        &mut self,
        group: &[AgentId],
        before: Driving,
        new: &mut Vec<Walk>,
        budget: &dyn Budget,
    ) -> Result<bool, Stop> {
        let optimum = |agent: AgentId| self.problem.optima[agent];
        let sum: u32 = group.iter().map(|&agent| arrival(&self.walks[agent])).sum();
        let least: u32 = group.iter().map(|&agent| optimum(agent)).sum();
        let mut spare = sum.saturating_sub(least);
        let shares = self.objective.costs().contains(&Cost::SumOfCosts);
        let allowed = group.iter().map(|&agent| self.allowance(agent).waits);
        let mut waits: Option<u32> = allowed.sum();
        for &agent in group {
            let mut allowance = self.allowance(agent);
            if shares {
                allowance.latest = self.makespan.min(optimum(agent).saturating_add(spare));
            }
            allowance.waits = waits;
            let query = Query {
                agent,
                allowance,
                calmer_than: None,
                expansion_limit: EXPANSION_LIMIT,
            };
            let found = search::plan_one(self.problem, &self.others, query, budget)?;
            let Some(walk) = found.walk else {
                return Ok(false);
            };
            spare = spare.saturating_sub(arrival(&walk).saturating_sub(optimum(agent)));
            let waited = Driving::of(self.problem, &walk).waits;
            waits = waits.map(|waits| waits.saturating_sub(waited));
            self.others.add(agent, &walk);
            new.push(walk);
        }
        Ok(Driving::of_all(self.problem, new) < before)
    }
}

/// All orders of some agents.
fn orders(agents: &[AgentId]) -> Vec<Vec<AgentId>> {
    let Some((&first, rest)) = agents.split_first() else {
        return vec![Vec::new()];
    };
    let mut all = Vec::new();
    for order in orders(rest) {
        for place in 0..=order.len() {
            let mut order = order.clone();
            order.insert(place, first);
            all.push(order);
        }
    }
    all
}
