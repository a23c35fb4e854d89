//! Hardening: the best plan so far excludes levels that no better plan can have.
//!
//! Each level above an assumption costs one more than the bound, so a plan that
//! is to be better keeps all levels within the gap between bound and best plan
//! (hardening; Ansótegui, Bonet and Levy 2013). Made clauses, they keep MDDs
//! small; and at a gap of one nothing is left to be assumed.

use giveway_model::Cost;

use super::{AtMost, Soft, SumStage};
use crate::search::stage::Search;

impl SumStage<'_> {
    /// Excludes levels that only plans worse than the best one have, or, where
    /// no further cost is minimised, plans that are not better.
    pub(super) fn harden_by_gap(&mut self, search: &mut Search) {
        if self.cost != Cost::SumOfCosts || self.known {
            return; // MDDs are limited by no other cost
        }
        let Some(best) = search.best(self.cost) else {
            return;
        };
        let bound = self.bound.by_cores();
        if self.hardened == Some((best, bound)) {
            return;
        }
        self.hardened = Some((best, bound));
        let gap = best.saturating_sub(bound);
        let slack = gap.saturating_sub(u32::from(self.last));
        search
            .claim
            .exclude_above(best.saturating_sub(u32::from(self.last)));
        for agent in 0..search.problem.agents() {
            if !search.team.is_inside(agent) {
                let most = search.problem.least_cost(agent).saturating_add(slack);
                search.lower_cap_by_best(agent, search.problem.time_of(agent, most));
            }
        }
        for soft in self.oll.assumed.values().chain(&self.oll.waiting) {
            match soft.raised(slack) {
                // (A cost is no time: who was cost_if_it_leaves_goal has cost some already.)
                Some(Soft::Level(AtMost { agent, most, .. })) => {
                    search.lower_cap_by_best(agent, search.problem.time_of(agent, most));
                }
                Some(Soft::Total { totalizer, k }) => {
                    if let Some(more) = self.oll.more_than(totalizer, k) {
                        search.harden_for_better(!more);
                    }
                }
                None => {}
            }
        }
        // A unit clause need not be assumed.
        self.oll.assumed.retain(|_, soft| {
            let at_most = soft.level();
            at_most.is_none_or(|AtMost { agent, most, .. }| {
                search.problem.time_of(agent, most) < search.cap(agent)
            })
        });
    }
}
