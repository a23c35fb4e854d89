//! The earlier cores that each core builds on, for the trace.
//!
//! A core speaks of agents that earlier cores have given more already, and of sums
//! over the limits of earlier cores. Those, and what they build on in turn, are its
//! lineage. Their agents have together, beyond the least of each, at least as much as
//! there are cores in the lineage: that is what the cores prove, counted for these
//! agents alone (each core pays for one, and no violation is paid for twice).

use std::collections::{BTreeMap, BTreeSet};

use super::{AtMost, Oll, Soft, SumStage, agent_of};
use crate::{
    encode::collisions::AgentId,
    search::{growing::CoreEffort, stage::Search},
    trace::{Core, EarlierCore, SearchEvent, Together},
};

/// One core, and all that it builds on.
struct Ancestry {
    /// The number of its event.
    event: u64,
    /// Its own number, and those of all cores that it builds on.
    cores: BTreeSet<usize>,
    /// The agents that they name.
    agents: BTreeSet<AgentId>,
}

/// The lineage of all cores of a stage; kept only where a trace is asked for.
#[derive(Default)]
pub(super) struct Lineage {
    cores: Vec<Ancestry>,
    /// The last core that had the limit of an agent.
    of_agent: BTreeMap<AgentId, usize>,
    /// The last core that had a totalizer.
    of_total: BTreeMap<usize, usize>,
}

impl Lineage {
    /// The cores that a limit builds on directly.
    fn parents(&self, limit: &Soft, oll: &Oll<AtMost>) -> Vec<usize> {
        match limit {
            Soft::Level(AtMost { agent, .. }) => {
                self.of_agent.get(agent).copied().into_iter().collect()
            }
            Soft::Total { totalizer, .. } => {
                let last = self.of_total.get(totalizer).copied();
                oll.core_of(*totalizer).into_iter().chain(last).collect()
            }
        }
    }

    /// A core of these limits is added to all that it builds on: how many cores that
    /// are, and their agents.
    fn add(
        &mut self,
        limits: &[Soft],
        oll: &Oll<AtMost>,
        event: u64,
    ) -> (usize, BTreeSet<AgentId>) {
        let number = self.cores.len();
        let mut own = Ancestry {
            event,
            cores: BTreeSet::from([number]),
            agents: limits.iter().filter_map(agent_of).collect(),
        };
        for limit in limits {
            for parent in self.parents(limit, oll) {
                if let Some(parent) = self.cores.get(parent) {
                    own.cores.extend(&parent.cores);
                    own.agents.extend(&parent.agents);
                }
            }
        }
        for limit in limits {
            match *limit {
                Soft::Level(AtMost { agent, .. }) => self.of_agent.insert(agent, number),
                Soft::Total { totalizer, .. } => self.of_total.insert(totalizer, number),
            };
        }
        let told = (own.cores.len(), own.agents.clone());
        self.cores.push(own);
        told
    }
}

impl SumStage<'_> {
    /// Tells of a core that has just raised the bound.
    pub(super) fn tell_core(&mut self, search: &mut Search, limits: &[Soft], effort: CoreEffort) {
        let budget = std::rc::Rc::clone(&search.budget);
        let Some(event) = budget.next_event() else {
            return;
        };
        let (paid, all) = self.lineage.add(limits, &self.oll, event);
        let least = |agent: AgentId| search.team.known_least(agent, self.cost);
        let sums: Vec<EarlierCore> = limits
            .iter()
            .filter_map(|limit| match *limit {
                Soft::Level(_) => None,
                Soft::Total { totalizer, k } => Some(EarlierCore {
                    event: self.lineage.cores.get(self.oll.core_of(totalizer)?)?.event,
                    at_most: k as u32,
                }),
            })
            .collect();
        let own: BTreeMap<AgentId, u32> = limits
            .iter()
            .filter_map(|limit| limit.level())
            .map(|AtMost { agent, most, .. }| (agent, most))
            .collect();
        let named: BTreeSet<AgentId> = if sums.is_empty() {
            own.keys().copied().collect()
        } else {
            all.clone()
        };
        let scope = search.scope(&named);
        let to = self.bound.by_cores();
        budget.record(|names| {
            let limits = own.iter();
            SearchEvent::Core(Core {
                cost: self.cost,
                limits: limits
                    .map(|(&agent, &most)| names.limit(agent, least(agent), most))
                    .collect(),
                sums,
                together: Some(Together {
                    agents: all
                        .iter()
                        .map(|&agent| names.least(agent, least(agent)))
                        .collect(),
                    more: paid as u32,
                }),
                scope,
                from: to - 1,
                to,
                literals: effort.into(),
                took: effort.conflicts,
            })
        });
    }
}
