//! The trace events of a search.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Cost;
use giveway_planners::bottleneck::{Bottleneck, Gate};

use super::Search;
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    search::bound::Bound,
    search::growing::{AssumptionCore, CoreEffort},
    trace::{self, Core, Entrant, Literals, Scope, SearchEvent},
};

impl Search<'_, '_, '_> {
    /// The plans that the last refutation is about, if its core names these agents.
    pub(in crate::search) fn scope(&self, named: &BTreeSet<AgentId>) -> Scope {
        let given = self.claim.optima().clone();
        let at_most = self.claim.excluded_above();
        // The makespan is a limit of each agent; a sum is one of all of them.
        let is_shared = at_most.is_some() || given.keys().any(|&cost| cost != Cost::Makespan);
        let others = is_shared || self.team.insiders().iter().any(|a| !named.contains(a));
        Scope {
            given,
            at_most,
            within: self.deadlines.horizon_in_force(),
            others,
        }
    }

    /// The search for the least of a cost begins: with what each agent needs alone.
    pub(in crate::search) fn tell_phase(&mut self, cost: Cost) -> Result<(), Stop> {
        if !self.budget.is_traced() {
            return Ok(());
        }
        if !self.claim.optima().is_empty() {
            let given = self.claim.optima().clone();
            let budget = &self.budget;
            budget.record(|_| SearchEvent::Phase { cost, given });
        }
        let mut least = Vec::new();
        for agent in 0..self.problem.agents() {
            least.push(self.team.least(agent, cost)?);
        }
        self.budget.record_alone(cost, &least);
        Ok(())
    }

    /// All that earlier cores set free is bounded again.
    pub(in crate::search) fn tell_round(&self, cost: Cost) {
        let budget = &self.budget;
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
        self.budget.record(|names| SearchEvent::Entered {
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
        if !self.budget.is_traced() {
            return;
        }
        let scope = self.scope(&core.agents().iter().copied().collect());
        let effort = core.effort();
        self.budget.record(|names| {
            let limits = core.agents().iter().map(|&agent| {
                let at_most = by.min(self.team.deadline(agent));
                names.limit(agent, self.problem.optima[agent], at_most)
            });
            SearchEvent::Core(Core {
                cost: Cost::Makespan,
                limits: limits.collect(),
                sums: Vec::new(),
                together: None,
                scope,
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
        self.budget.record(|_| SearchEvent::Closed {
            cost,
            scope: Scope {
                given: self.claim.optima().clone(),
                within: self.deadlines.horizon_in_force(),
                ..Scope::default()
            },
            from,
            to,
            took: effort.conflicts,
        });
    }

    /// Counting at a bottleneck shows a bound.
    pub(in crate::search) fn tell_counted(&self, bound: Bound, bottleneck: &Bottleneck) {
        let terrain = &self.problem.terrain;
        self.budget.record(|names| SearchEvent::Counted {
            cost: bound.cost(),
            agents: names.all(bottleneck.agents()),
            at: match bottleneck.gate() {
                Gate::Passage(cells) => {
                    let cells = cells.iter().map(|&v| terrain.cell(v));
                    trace::Bottleneck::Passage(cells.collect())
                }
                &Gate::Zone { rule, most } => trace::Bottleneck::Zone { rule, most },
            },
            at_least: bound.at_least(),
        });
    }

    /// The best plan has the optima of all costs so far.
    pub(in crate::search) fn tell_met(&self) {
        self.budget.record(|_| SearchEvent::Met {
            costs: self.claim.optima().clone(),
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
