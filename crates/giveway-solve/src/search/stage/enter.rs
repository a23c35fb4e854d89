//! Agents enter the SAT solver.

use giveway_model::Cost;

use super::Search;
use crate::{budget::Stop, encode::collisions::AgentId, trace::FoundBy};

impl Search<'_, '_, '_> {
    /// Takes an agent inside, with all that holds for good.
    pub(crate) fn enter(&mut self, agent: AgentId) -> Result<(), Stop> {
        if self.team.is_inside(agent) {
            return Ok(());
        }
        self.team.enter(agent)?;
        self.harden_cap(agent);
        let problem = self.problem;
        for (cost, most) in problem.tasks[agent].conditions.counted_limits() {
            // No agent is asked for less than it could have alone.
            if let Some(more) = self.team.more_than(agent, cost, most)? {
                self.team.harden(!more);
            }
        }
        for number in 0..self.sums.len() {
            self.add_to_limit(agent, number)?;
        }
        for cost in self.claim.minima_inside() {
            let least = self.team.least(agent, cost)?;
            if let Some(more) = self.team.more_than(agent, cost, least)? {
                self.team.harden(!more);
            }
        }
        Ok(())
    }

    /// Takes agents inside whose conditions only the SAT solver can keep.
    pub(crate) fn enter_insiders(&mut self) -> Result<(), Stop> {
        for agent in self.problem.insiders() {
            self.enter(agent)?;
        }
        Ok(())
    }

    /// Reads the model and plans the outside agents around it; the agents that
    /// had to enter, none where the walks are a plan.
    pub(crate) fn settle(&mut self) -> Result<Vec<AgentId>, Stop> {
        self.team.read();
        let met = self.team.collide()?;
        let mut entering: Vec<AgentId> = met.keys().copied().collect();
        for &cost in &self.claim.minima_outside() {
            for agent in self.above_minimum(cost)? {
                if !entering.contains(&agent) {
                    entering.push(agent);
                }
            }
        }
        for &agent in &entering {
            self.enter(agent)?;
        }
        self.tell_entered(&entering, &met);
        if entering.is_empty() {
            let walks = self.team.walks.clone();
            self.incumbent.offer(self.problem, &walks, FoundBy::Solver);
        }
        Ok(entering)
    }

    /// Outside agents whose walks cost more than their own minimum.
    pub(crate) fn above_minimum(&mut self, cost: Cost) -> Result<Vec<AgentId>, Stop> {
        let mut above = Vec::new();
        if matches!(cost, Cost::Makespan | Cost::SumOfCosts) {
            return Ok(above);
        }
        for agent in 0..self.problem.agents() {
            if !self.team.is_inside(agent) {
                let least = self.team.least(agent, cost)?;
                let walk = std::slice::from_ref(&self.team.walks[agent]);
                if crate::walk::costs_of(self.problem, agent, &walk[0]).get(cost) > least {
                    above.push(agent);
                }
            }
        }
        Ok(above)
    }
}
