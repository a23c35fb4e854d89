//! The last few bounds at once: a plan better than the best one, or none.
//!
//! The cores of the last bounds are the largest, and take most of the time. Where
//! local search has found a plan close to the bound, all that is still assumed is
//! counted in one sum, which has to be less than what the best plan pays above the
//! bound. A refutation closes the gap at once; a model is a better plan, and the sum
//! becomes smaller (model-improving search; Eén and Sörensson 2006). Where a further cost
//! follows, the sum stays limited for the agents that enter later, too.

use giveway_model::Cost;

use super::SumStage;
use crate::{
    budget::Stop,
    encode::totalizer::capped,
    sat::Lit,
    search::{
        growing::{Growing, Until},
        stage::{End, Search},
    },
};

impl SumStage<'_> {
    /// Closes the gap, if it is small and local search finds nothing better: how
    /// the stage ends; `None` where it goes on by cores.
    pub(super) fn close(&mut self, search: &mut Search) -> Result<Option<End>, Stop> {
        if self.cost != Cost::SumOfCosts || self.known || !self.light {
            return Ok(None);
        }
        let gap = search
            .best(self.cost)
            .map(|best| best.saturating_sub(self.bound.by_cores()));
        let most = search.budget.thresholds().closed_gap;
        if !gap.is_some_and(|gap| (1..=most).contains(&gap)) || !search.is_polished() {
            return Ok(None);
        }
        self.begin_phase(search)?;
        self.harden_by_gap(search);
        let Some(best) = search.best(self.cost) else {
            return Ok(None);
        };
        let gap = best.saturating_sub(self.bound.by_cores());
        // Where a further cost is minimised, plans as good as the best count, too.
        let levels = gap + u32::from(!self.last);
        let mut paid = Vec::new();
        for soft in self.oll.assumed.values() {
            for soft in (0..levels).filter_map(|level| soft.raised(level)) {
                let lit = self.oll.literal(search, soft)?;
                paid.extend(lit.map(|lit| !lit));
            }
        }
        let sum = capped(&paid, levels as usize, search.team.clauses())?;
        loop {
            let Some(best) = search.best(self.cost) else {
                return Ok(None);
            };
            let gap = best.saturating_sub(self.bound.by_cores());
            let less = gap.checked_sub(1).and_then(|k| sum.get(k as usize));
            let assumptions: Vec<Lit> = less.map(|&lit| !lit).into_iter().collect();
            if gap == 0 {
                return Ok(None);
            }
            match search.solve_growing(assumptions, Until::EVER)? {
                Growing::Grown(_) => {}
                Growing::Model => {
                    let entered = search.settle()?;
                    if !entered.is_empty() {
                        for agent in entered {
                            self.adopt(search, agent)?;
                        }
                        return Ok(None);
                    }
                    if search.best(self.cost).is_none_or(|better| better >= best) {
                        return Err(Stop::Contradiction);
                    }
                    self.harden_by_gap(search);
                }
                Growing::Core(core) => {
                    search.tell_closed(self.cost, (self.bound.by_cores(), best), core.effort());
                    if !self.last {
                        search.limit_above_bound(self.cost, sum, gap);
                    }
                    self.bound.raise_to(best, core.lits());
                    search.report_bound(*self.bound);
                    return self.met(search).map(Some);
                }
            }
        }
    }
}
