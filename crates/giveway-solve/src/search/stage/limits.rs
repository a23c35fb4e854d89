//! Limits on costs, and what each agent alone needs of them.

use giveway_model::Cost;

use super::Search;
use crate::{
    budget::{Budget, Stop},
    encode::{collisions::AgentId, limit::SumLimit},
    problem::Problem,
    sat::Lit,
    search::{aim::Bounded, tally::least},
    single::TaskConstraint,
};

/// The proof that no plan keeps a limit, of whatever makespan: the agents' own
/// minima, from exact tables, are above it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LimitTooLow(());

/// An agent of which a question asks for less than it could have alone.
pub(in crate::search) fn asked_below_minimum(
    problem: &Problem,
    budget: &Budget,
) -> Result<Option<(usize, LimitTooLow)>, Stop> {
    for (agent, task) in problem.tasks.iter().enumerate() {
        if let Some(TaskConstraint::AtMost { cost, most }) = task.demand
            && least(problem, agent, cost, budget)? > most
        {
            return Ok(Some((agent, LimitTooLow(()))));
        }
    }
    Ok(None)
}

impl Search<'_, '_, '_> {
    /// The sum of what each agent alone needs at the least.
    pub(crate) fn sum_of_minima(&mut self, cost: Cost) -> Result<u32, Stop> {
        let mut sum = 0;
        for agent in 0..self.problem.agents() {
            sum += match cost {
                Cost::Makespan => 0,
                Cost::SumOfCosts => self.problem.least_cost(agent),
                _ => self.team.least(agent, cost)?,
            };
        }
        Ok(sum)
    }

    /// Makes the limits hold, those on the makespan apart; the proof that no plan
    /// keeps one, where the agents' own minima break it.
    pub(in crate::search) fn keep_limits(
        &mut self,
        bounded: &Bounded,
    ) -> Result<Option<LimitTooLow>, Stop> {
        for (&cost, &most) in &bounded.limits {
            if cost != Cost::Makespan
                && let Some(too_low) = self.limit(cost, most)?
            {
                return Ok(Some(too_low));
            }
        }
        // Whoever enters takes its share of the limits.
        self.enter_insiders()?;
        Ok(None)
    }

    /// Allows no plan whose sum of a cost is above `most`; the proof that there
    /// is none, where the sum of the agents' own minima is above it already.
    fn limit(&mut self, cost: Cost, most: u32) -> Result<Option<LimitTooLow>, Stop> {
        let least = self.sum_of_minima(cost)?;
        let Some(spare) = most.checked_sub(least) else {
            return Ok(Some(LimitTooLow(())));
        };
        self.allowed
            .sums
            .insert(cost, SumLimit::new(spare as usize));
        if cost == Cost::SumOfCosts {
            for agent in 0..self.problem.agents() {
                let most = self.problem.least_cost(agent).saturating_add(spare);
                self.lower_cap(agent, self.problem.time_of(agent, most));
            }
        } else {
            self.stages.begun.push(cost);
        }
        Ok(None)
    }

    /// What an agent costs beyond its minimum, in unary, as far as the limit
    /// needs it.
    pub(super) fn digits(&mut self, agent: AgentId, cost: Cost) -> Result<Vec<Lit>, Stop> {
        let most = self.allowed.sums.get(&cost).map_or(0, SumLimit::most) as u32;
        let mut digits = Vec::new();
        for more in 0..=most {
            let digit = match cost {
                Cost::Makespan => None,
                Cost::SumOfCosts => {
                    let cost = self.problem.least_cost(agent) + more;
                    let time = self.problem.time_of(agent, cost);
                    self.team.by(agent, time).map(|by| !by)
                }
                _ => {
                    let least = self.team.least(agent, cost)?;
                    self.team.more_than(agent, cost, least + more)?
                }
            };
            digits.extend(digit);
        }
        Ok(digits)
    }
}
