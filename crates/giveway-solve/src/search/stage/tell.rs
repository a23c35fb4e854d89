//! What a search tells of itself, where a trace is asked for.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Cost;

use super::Search;
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    search::growing::{AssumptionCore, CoreEffort},
    trace::{Condition, Core, Entrant, Literals, SearchEvent},
};

impl Search<'_, '_, '_> {
    /// Of which plans it is so what was just refuted, where these agents are named.
    pub(in crate::search) fn condition(&self, named: &BTreeSet<AgentId>) -> Condition {
        let given = self.stages.done.clone();
        let worse = self.stages.worse;
        let at_most = worse.at_most.filter(|_| worse.in_force);
        // The makespan is a limit of each agent; a sum is one of all of them.
        let is_shared = at_most.is_some() || given.keys().any(|&cost| cost != Cost::Makespan);
        let others = is_shared || self.team.insiders().iter().any(|a| !named.contains(a));
        Condition {
            given,
            at_most,
            within: self.allowed.deadlines.horizon_in_force(),
            others,
        }
    }

    /// The search for the least of a cost begins: with what each agent needs alone.
    pub(in crate::search) fn tell_phase(&mut self, cost: Cost) -> Result<(), Stop> {
        if !self.allowed.budget.is_traced() {
            return Ok(());
        }
        if !self.stages.done.is_empty() {
            let given = self.stages.done.clone();
            let budget = &self.allowed.budget;
            budget.record(|_| SearchEvent::Phase { cost, given });
        }
        let mut least = Vec::new();
        for agent in 0..self.problem.agents() {
            least.push(match cost {
                Cost::Makespan => self.problem.optima[agent],
                Cost::SumOfCosts => self.problem.least_cost(agent),
                _ => self.team.least(agent, cost)?,
            });
        }
        self.allowed.budget.record_alone(cost, &least);
        Ok(())
    }

    /// All that earlier cores set free is bounded again.
    pub(in crate::search) fn tell_round(&self, cost: Cost) {
        let budget = &self.allowed.budget;
        budget.record(|_| SearchEvent::Round { cost });
    }

    /// Agents have entered, each with whom it met.
    pub(in crate::search) fn tell_entered(
        &self,
        entered: &[AgentId],
        met: &BTreeMap<AgentId, BTreeSet<AgentId>>,
    ) {
        if entered.is_empty() {
            return;
        }
        self.allowed.budget.record(|names| SearchEvent::Entered {
            agents: entered
                .iter()
                .map(|&agent| Entrant {
                    agent: names.name(agent),
                    with: names.all(met.get(&agent).into_iter().flatten().copied()),
                })
                .collect(),
        });
    }

    /// The agents of a core cannot all arrive by a time.
    pub(in crate::search) fn tell_too_late(&self, core: &AssumptionCore, by: u32) {
        if !self.allowed.budget.is_traced() {
            return;
        }
        let condition = self.condition(&core.agents().iter().copied().collect());
        let effort = core.effort();
        self.allowed.budget.record(|names| {
            let limits = core.agents().iter().map(|&agent| {
                let at_most = by.min(self.team.deadline(agent));
                names.limit(agent, self.problem.optima[agent], at_most)
            });
            SearchEvent::Core(Core {
                cost: Cost::Makespan,
                limits: limits.collect(),
                sums: Vec::new(),
                together: None,
                condition,
                from: by,
                to: by + 1,
                literals: effort.into(),
                took: effort.conflicts,
            })
        });
    }

    /// No plan is better than the best one: the bound rises at once.
    pub(in crate::search) fn tell_closed(
        &self,
        cost: Cost,
        (from, to): (u32, u32),
        effort: CoreEffort,
    ) {
        self.allowed.budget.record(|_| SearchEvent::Closed {
            cost,
            condition: Condition {
                given: self.stages.done.clone(),
                within: self.allowed.deadlines.horizon_in_force(),
                ..Condition::default()
            },
            from,
            to,
            took: effort.conflicts,
        });
    }

    /// The best plan has the optima of all costs so far.
    pub(in crate::search) fn tell_met(&self) {
        self.allowed.budget.record(|_| SearchEvent::Met {
            costs: self.stages.done.clone(),
            within: None,
        });
    }
}

impl From<CoreEffort> for Literals {
    fn from(effort: CoreEffort) -> Self {
        Self {
            before: effort.stated as u32,
            after: effort.literals as u32,
        }
    }
}
