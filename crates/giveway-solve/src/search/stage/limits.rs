//! Limits on costs, and what each agent alone needs of them.

use giveway_model::Cost;

use super::Search;
use crate::{
    budget::Stop,
    encode::{collisions::AgentId, limit::SumLimit},
    sat::Lit,
    search::{aim::Bounded, bound::Optimum, minima::LimitTooLow},
};

impl Search<'_, '_, '_> {
    /// Makes the limits hold, those on the makespan apart; the proof that no plan
    /// keeps one, where the agents' own minima break it.
    pub(in crate::search) fn keep_limits(
        &mut self,
        bounded: &Bounded,
    ) -> Result<Option<LimitTooLow>, Stop> {
        for (&cost, &most) in &bounded.limits {
            if cost != Cost::Makespan
                && let Err(too_low) = self.limit(cost, most)?
            {
                return Ok(Some(too_low));
            }
        }
        // An agent that enters takes its share of the limits.
        self.enter_insiders()?;
        Ok(None)
    }

    /// Allows no plan whose sum of a cost is above `most`; the proof that there
    /// is none, where the sum of the agents' own minima is above it already.
    fn limit(&mut self, cost: Cost, most: u32) -> Result<Result<(), LimitTooLow>, Stop> {
        let spare = match self.team.lone_bound(cost)?.spare(most) {
            Ok(spare) => spare,
            Err(too_low) => return Ok(Err(too_low)),
        };
        let limit = SumLimit::new((spare / self.unit(cost)) as usize);
        self.sums.push((cost, limit));
        if cost == Cost::SumOfCosts {
            for agent in 0..self.problem.agents() {
                let most = self.problem.least_cost(agent).saturating_add(spare);
                self.lower_cap(agent, self.problem.time_of(agent, most));
            }
        } else {
            self.claim.keep_outside(cost);
        }
        Ok(Ok(()))
    }

    /// Allows no plan with more of a cost than its optimum, which the agents inside have to keep
    /// from now on, too.
    pub(in crate::search) fn limit_from_now(&mut self, optimum: Optimum) -> Result<(), Stop> {
        let number = self.sums.len();
        if self.limit(optimum.cost(), optimum.least())?.is_err() {
            return Err(Stop::Contradiction);
        }
        for agent in self.team.insiders() {
            self.add_to_limit(agent, number)?;
        }
        Ok(())
    }

    /// Allows no plan whose sum of a cost is more than `most` above its bound. The sum
    /// counts what the agents inside have above the bound; the others have their minima
    /// as long as they are outside.
    pub(in crate::search) fn limit_above_bound(&mut self, cost: Cost, sum: Vec<Lit>, most: u32) {
        let limit = SumLimit::of_sum(sum, most as usize, self.team.clauses());
        self.sums.push((cost, limit));
    }

    /// Adds what an agent that enters costs beyond its minimum to one of the limits.
    pub(super) fn add_to_limit(&mut self, agent: AgentId, number: usize) -> Result<(), Stop> {
        let Some((cost, limit)) = self.sums.get(number) else {
            return Ok(());
        };
        let digits = self.digits(agent, *cost, limit.most() as u32)?;
        if let Some((_, limit)) = self.sums.get_mut(number) {
            limit.add(&digits, self.team.clauses())?;
        }
        Ok(())
    }

    /// The amount of which what agents have beyond their minima is a multiple.
    fn unit(&self, cost: Cost) -> u32 {
        match cost {
            Cost::Penalty => self.problem.penalty_unit(),
            Cost::Makespan | Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits => 1,
        }
    }

    /// The cost of an agent beyond its minimum, in unary, as far as a limit of `most` needs it.
    fn digits(&mut self, agent: AgentId, cost: Cost, most: u32) -> Result<Vec<Lit>, Stop> {
        let mut digits = Vec::new();
        let cap = self.cap(agent);
        for more in 0..=most {
            self.budget.tick()?;
            let digit = match cost {
                Cost::Makespan => None,
                Cost::SumOfCosts => {
                    let cost = self.problem.least_cost(agent) + more;
                    let time = self.problem.time_of(agent, cost);
                    // (A cost is no time: who slept has cost nothing since it arrived.)
                    if time >= cap {
                        break;
                    }
                    self.team.by(agent, time).map(|by| !by)
                }
                // No agent has more of a count than steps up to its latest arrival.
                Cost::Charges | Cost::Moves | Cost::Waits if more > cap => break,
                _ => {
                    let least = self.team.least(agent, cost)?;
                    let more = more.saturating_mul(self.unit(cost));
                    self.team
                        .more_than(agent, cost, least.saturating_add(more))?
                }
            };
            digits.extend(digit);
        }
        Ok(digits)
    }
}
