//! The agents of a small core by themselves, until they hold together.
//!
//! Core exhaustion (Ignatiev, Morgado and Marques-Silva 2019), for agents: a
//! core sets its agents one level higher, and as long as these are a core again,
//! together with what is shared among them, the bound rises. All other agents
//! are free meanwhile, so that what a few agents cost each other is learnt in
//! cores of few literals. Otherwise much of it would come out later in cores
//! that name many agents, each of which would get a larger MDD.

use std::collections::BTreeMap;

use giveway_model::sorting::{self, sort};

use super::{Soft, SumStage, agent_of};
use crate::{
    budget::Stop, encode::collisions::AgentId, sat::Lit, search::growing::CoreEffort,
    search::stage::Search,
};

impl SumStage<'_> {
    /// Goes on with the softs of a core, one level higher, and with the cores
    /// paid from number `first` on, which are among these softs; what is to be
    /// assumed in the end.
    pub(super) fn exhaust_core(
        &mut self,
        search: &mut Search,
        mut softs: Vec<Soft>,
        first: usize,
    ) -> Result<Vec<Soft>, Stop> {
        let most = search.budget.thresholds().exhausted_core;
        if !(2..=most).contains(&softs.len()) {
            return Ok(softs);
        }
        while self.bound.met(search).is_none() {
            softs.extend(self.oll.count_from(search, first)?);
            let mut assumed = BTreeMap::new();
            for &soft in &softs {
                if let Some(lit) = self.oll.literal(search, soft)? {
                    assumed.insert(lit, soft);
                }
            }
            // Shared softs come first, as in `in_order`.
            let mut order: Vec<Lit> = assumed.keys().copied().collect();
            sorting::sort_by_key(&mut order, |lit| {
                assumed.get(lit).and_then(agent_of).is_some()
            });
            let before = search.budget.conflicts();
            let core = match search.team.refute(&order)? {
                Some(core) if !core.is_empty() => core,
                _ => return Ok(assumed.into_values().collect()),
            };
            let effort = CoreEffort {
                stated: search.team.stated(),
                literals: core.len(),
                conflicts: search.budget.conflicts() - before,
            };
            let limits: Vec<Soft> = core
                .iter()
                .filter_map(|lit| assumed.get(lit).copied())
                .collect();
            self.raise_lower_bound(search, (&core, &core), &limits, effort);
            let raised = assumed.into_iter().filter_map(|(lit, soft)| {
                let by = u32::from(core.contains(&lit));
                soft.raised(by)
            });
            softs = raised.collect();
        }
        Ok(softs)
    }

    /// Learns the cores of the same agents at higher levels, where there are
    /// any; by how many levels. Tried only for agents that have been a core
    /// before, and twice as far each time that it succeeds.
    pub(super) fn stretch(&mut self, search: &mut Search, softs: &[Soft]) -> Result<u32, Stop> {
        let most = search.budget.thresholds().stretched_core;
        let agents: Option<Vec<AgentId>> = softs.iter().map(agent_of).collect();
        let Some(mut agents) = agents.filter(|agents| agents.len() <= most) else {
            return Ok(0);
        };
        sort(&mut agents);
        let seen = self.seen.entry(agents).or_insert(0);
        *seen += 1;
        let (mut step, mut learnt) = (*seen - 1, 0);
        while step > 0 {
            let mut levels = Vec::new();
            for level in learnt + 1..=learnt + step {
                let mut core = Vec::new();
                for soft in softs.iter().filter_map(|soft| soft.raised(level)) {
                    core.extend(self.oll.literal(search, soft)?);
                }
                if core.len() < softs.len() {
                    return Ok(learnt); // a level at its cap cannot be violated
                }
                levels.push(core);
            }
            let highest = levels.last().map_or(&[][..], Vec::as_slice);
            let before = search.budget.conflicts();
            let Some(shown) = search.team.refute(highest)? else {
                return Ok(learnt);
            };
            let mut effort = CoreEffort {
                stated: softs.len(),
                literals: softs.len(),
                conflicts: search.budget.conflicts() - before,
            };
            // Lower levels exclude each other all the more.
            for (level, core) in (learnt + 1..).zip(&levels) {
                let limits = softs.iter().filter_map(|soft| soft.raised(level));
                self.raise_lower_bound(
                    search,
                    (core, &shown),
                    &limits.collect::<Vec<Soft>>(),
                    effort,
                );
                effort.conflicts = 0;
            }
            learnt += step;
            step *= 2;
        }
        Ok(learnt)
    }
}
