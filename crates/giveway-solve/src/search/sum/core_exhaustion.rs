//! The agents of a small core by themselves, until they hold together.
//!
//! Core exhaustion (Ignatiev, Morgado and Marques-Silva 2019), for agents: a
//! core sets its agents one level higher, and as long as these are a core again,
//! together with what is shared among them, the bound rises. All other agents
//! are free meanwhile, so that what a few agents cost each other is learnt in
//! cores of few literals. Otherwise much of it would come out later in cores
//! that name many agents, each of which would get a larger MDD.

use std::collections::BTreeMap;

use giveway_model::sorting;

use super::{PaidCore, Soft, SumStage};
use crate::{
    budget::Stop, encode::totalizer::totalizer, sat::Lit, search::growing::CoreEffort,
    search::stage::Search,
};

/// Cores of more literals are not gone on with.
const MOST_LITERALS: usize = 8;

impl SumStage {
    /// Goes on with the softs of a core, one level higher, and with the cores
    /// paid from number `first` on, which are among these softs; what is to be
    /// assumed in the end.
    pub(super) fn exhaust(
        &mut self,
        search: &mut Search,
        mut softs: Vec<Soft>,
        first: usize,
    ) -> Result<Vec<Soft>, Stop> {
        if !(2..=MOST_LITERALS).contains(&softs.len()) {
            return Ok(softs);
        }
        while !search.incumbent_meets(self.cost, self.bound) {
            for core in self.cores.split_off(first) {
                softs.push(self.total(search, &core));
            }
            let mut assumed = BTreeMap::new();
            for &soft in &softs {
                if let Some(lit) = self.literal(search, soft)? {
                    assumed.insert(lit, soft);
                }
            }
            // What is shared comes first, as in `in_order`.
            let mut order: Vec<Lit> = assumed.keys().copied().collect();
            sorting::sort_by_key(&mut order, |lit| {
                assumed.get(lit).is_some_and(|s| s.agent().is_some())
            });
            let before = search.allowed.budget.conflicts();
            let core = match search.team.refute(&order)? {
                Some(core) if !core.is_empty() => core,
                _ => return Ok(assumed.into_values().collect()),
            };
            let effort = CoreEffort {
                stated: search.team.stated(),
                literals: core.len(),
                conflicts: search.allowed.budget.conflicts() - before,
            };
            let limits: Vec<Soft> = core
                .iter()
                .filter_map(|lit| assumed.get(lit).copied())
                .collect();
            self.pay(search, &core, &limits, effort);
            let raised = assumed.into_iter().map(|(lit, soft)| {
                let by = u32::from(core.contains(&lit));
                soft.raised(by)
            });
            softs = raised.collect();
        }
        Ok(softs)
    }

    /// Counts the violations of a core, of which the core itself pays for one.
    pub(super) fn total(&mut self, search: &mut Search, core: &PaidCore) -> Soft {
        let outputs = totalizer(&core.violations, search.team.clauses());
        self.lineage.count(core.number);
        self.totalizers.push(outputs);
        Soft::Total {
            totalizer: self.totalizers.len() - 1,
            k: 1,
        }
    }
}
