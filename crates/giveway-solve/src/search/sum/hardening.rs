//! What the best plan so far tells: levels that no better plan can have.
//!
//! Each level above an assumption costs one more than the bound, so a plan that
//! is to be better keeps all levels within the gap between bound and best plan
//! (hardening; Ansótegui, Bonet and Levy 2013). Made clauses, they keep MDDs
//! small; and at a gap of one nothing is left to be assumed.

use giveway_model::Cost;

use super::{Soft, SumStage};
use crate::search::stage::Search;

impl SumStage {
    /// Excludes levels that only plans worse than the best one have, or, where
    /// no further cost is minimised, plans that are not better.
    pub(super) fn harden_by_gap(&mut self, search: &mut Search) {
        if self.cost != Cost::SumOfCosts || self.known {
            return; // MDDs are limited by no other cost
        }
        let Some(best) = search.best(self.cost) else {
            return;
        };
        if self.hardened == Some((best, self.bound)) {
            return;
        }
        self.hardened = Some((best, self.bound));
        let gap = best.saturating_sub(self.bound);
        let slack = gap.saturating_sub(u32::from(self.last));
        search.exclude_worse(best.saturating_sub(u32::from(self.last)));
        for agent in 0..search.problem.agents() {
            if !search.team.is_inside(agent) {
                let most = search.problem.least_cost(agent).saturating_add(slack);
                search.lower_cap_by_best(agent, search.problem.time_of(agent, most));
            }
        }
        for soft in self.softs.values().chain(&self.waiting) {
            match soft.raised(slack) {
                // (A cost is no time: who was woken has cost some already.)
                Soft::Agent(agent, most) => {
                    search.lower_cap_by_best(agent, search.problem.time_of(agent, most));
                }
                Soft::Total { totalizer, k } => {
                    if let Some(&more) = self.totalizers[totalizer].get(k) {
                        search.harden_for_better(!more);
                    }
                }
            }
        }
        // What holds for good need not be assumed.
        let holds = |soft: &Soft| match *soft {
            Soft::Agent(agent, most) => search.problem.time_of(agent, most) >= search.cap(agent),
            Soft::Total { .. } => false,
        };
        self.softs.retain(|_, soft| !holds(soft));
    }
}
