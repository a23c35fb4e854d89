//! The costs of a plan's agents, with what rounds ask of all of them kept as walks change.

use std::collections::BTreeSet;

use giveway_model::Costs;

use crate::{
    AgentId,
    problem::Problem,
    walk::{Walk, costs_of},
};

/// The costs of each agent, and of all.
pub(super) struct PlanCosts {
    own: Vec<Costs>,
    /// The sums of all.
    sums: Sums,
    /// The arrival of each agent, in time steps.
    arrivals: BTreeSet<(u32, AgentId)>,
    /// The agents that arrive later than they would alone, with how much later.
    delays: BTreeSet<(u32, AgentId)>,
}

/// Costs that are added up over agents; weights of rules may be so large that a sum is beyond what
/// [`Costs`] can say.
#[derive(Default)]
struct Sums {
    sum_of_costs: u64,
    charges: u64,
    moves: u64,
    waits: u64,
    penalty: u64,
}

impl PlanCosts {
    /// Of one walk for each agent.
    pub(super) fn new(problem: &Problem, walks: &[Walk]) -> Self {
        let mut tally = Self {
            own: vec![Costs::default(); walks.len()],
            sums: Sums::default(),
            arrivals: BTreeSet::new(),
            delays: BTreeSet::new(),
        };
        for (agent, walk) in walks.iter().enumerate() {
            tally.arrivals.insert((0, agent));
            tally.set(problem, agent, costs_of(problem, agent, walk));
        }
        tally
    }

    /// The costs of an agent.
    pub(super) fn own(&self, agent: AgentId) -> Costs {
        self.own[agent]
    }

    /// Sets the costs of an agent.
    pub(super) fn set(&mut self, problem: &Problem, agent: AgentId, costs: Costs) {
        let old = std::mem::replace(&mut self.own[agent], costs);
        let delay = |costs: Costs| costs.makespan.saturating_sub(problem.optima[agent]);
        self.arrivals.remove(&(old.makespan, agent));
        self.delays.remove(&(delay(old), agent));
        self.arrivals.insert((costs.makespan, agent));
        if delay(costs) > 0 {
            self.delays.insert((delay(costs), agent));
        }
        let sums = &mut self.sums;
        for (sum, old, new) in [
            (&mut sums.sum_of_costs, old.sum_of_costs, costs.sum_of_costs),
            (&mut sums.charges, old.charges, costs.charges),
            (&mut sums.moves, old.moves, costs.moves),
            (&mut sums.waits, old.waits, costs.waits),
            (&mut sums.penalty, old.penalty, costs.penalty),
        ] {
            *sum = *sum - u64::from(old) + u64::from(new);
        }
    }

    /// The costs of all.
    pub(super) fn all(&self) -> Costs {
        let makespan = self.arrivals.last().map_or(0, |&(arrival, _)| arrival);
        let said = |sum: u64| u32::try_from(sum).unwrap_or(u32::MAX);
        let sums = &self.sums;
        Costs {
            makespan,
            sum_of_costs: said(sums.sum_of_costs),
            charges: said(sums.charges),
            moves: said(sums.moves),
            waits: said(sums.waits),
            penalty: said(sums.penalty),
        }
    }

    /// The agent that arrives last.
    pub(super) fn last(&self) -> Option<AgentId> {
        self.arrivals.last().map(|&(_, agent)| agent)
    }

    /// The delayed agents, the most delayed first.
    pub(super) fn delayed(&self) -> impl Iterator<Item = AgentId> + '_ {
        self.delays.iter().rev().map(|&(_, agent)| agent)
    }
}
