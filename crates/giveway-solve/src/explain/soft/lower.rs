//! One number after the other, as low as can be: the breaches, the deadline, the
//! sum of costs.
//!
//! By linear SAT-UNSAT search (model-improving search; Le Berre and Parrain 2010, after Eén
//! and Sörensson 2006): there are few breaches, and each model judged is a better plan at hand
//! when the budget ends, which core-guided search would have at its end only.

use super::{Lowered, SoftRules};
use crate::{
    budget::Stop,
    encode::totalizer::{capped, totalizer},
    sat::Lit,
};

/// The most broken rules that are counted: more explain nothing.
const MOST_BROKEN: usize = 12;

impl SoftRules<'_, '_, '_> {
    /// Lowers one thing after the other; an error leaves the best so far.
    pub(super) fn lower_all(&mut self, first: u32) -> Result<(), Stop> {
        for agent in 0..self.problem.agents() {
            self.team.enter(agent)?;
        }
        // Deadlines with twice the delay each time.
        let (mut before, mut deadline) = (None, first);
        let mut sooner = None;
        loop {
            let found = self.lowered().map(|best| best.count);
            self.lower_count(deadline)?;
            let now = self.lowered().map(|best| best.count);
            if now != found {
                sooner = before;
            }
            if now == Some(1) || deadline == self.horizon {
                break;
            }
            before = Some(deadline);
            let delay = (deadline - first).max(1);
            deadline = (deadline + delay).min(self.horizon);
        }
        let Some(Lowered {
            count, makespan, ..
        }) = self.lowered()
        else {
            return Ok(());
        };
        let breaches = (self.breaches)(&self.team, self.problem);
        let lits: Vec<Lit> = breaches.iter().map(|&(_, lit)| lit).collect();
        let counted = capped(&lits, count + 1, self.team.clauses())?;
        let mut fixed: Vec<Lit> = counted.get(count).map(|&more| !more).into_iter().collect();
        let from = sooner.map_or(first, |deadline| deadline + 1);
        let sooner: Vec<Vec<Lit>> = (from..makespan).map(|time| self.deadlines(time)).collect();
        self.lower(from as usize, &sooner, &fixed, |it| it.makespan as usize)?;
        self.lower_sum(&mut fixed)?;
        self.order_breaches(breaches, fixed)
    }

    /// Lowers a number by linear SAT-UNSAT search: each model says what the next one has to be
    /// below, until there is none. The assumptions of each level say that the number is at most
    /// so much, from its `least` on.
    fn lower(
        &mut self,
        least: usize,
        levels: &[Vec<Lit>],
        fixed: &[Lit],
        number: impl Fn(Lowered) -> usize,
    ) -> Result<(), Stop> {
        let mut below = levels;
        while let Some((level, lower)) = below.split_last() {
            let Some(found) = self.model(&[level, fixed].concat())? else {
                break;
            };
            let further = number(found).saturating_sub(least);
            below = lower.get(..further).unwrap_or(lower);
        }
        Ok(())
    }

    /// The counts of the best plan so far.
    fn lowered(&self) -> Option<Lowered> {
        self.best.as_ref().map(|&(best, _)| best)
    }

    /// All agents arrive by a time.
    fn deadlines(&mut self, time: u32) -> Vec<Lit> {
        let agents = 0..self.problem.agents();
        let by = |agent| self.team.by(agent, time);
        agents.filter_map(by).collect()
    }

    /// The fewest breaches at a deadline; there is at least one.
    fn lower_count(&mut self, deadline: u32) -> Result<(), Stop> {
        for agent in 0..self.problem.agents() {
            self.team.grow(agent, deadline)?;
        }
        let most = self
            .lowered()
            .map_or(MOST_BROKEN, |best| best.count.saturating_sub(1));
        let breaches = (self.breaches)(&self.team, self.problem);
        let lits: Vec<Lit> = breaches.iter().map(|&(_, lit)| lit).collect();
        let counted = capped(&lits, most + 1, self.team.clauses())?;
        let at_most = |k: usize| counted.get(k).map(|&more| !more).into_iter().collect();
        let levels: Vec<Vec<Lit>> = (1..=most).map(at_most).collect();
        let by = self.deadlines(deadline);
        self.lower(1, &levels, &by, |it| it.count)
    }

    /// The least sum of costs with the fewest breaches by the earliest deadline, both of which
    /// are fixed with it.
    fn lower_sum(&mut self, fixed: &mut Vec<Lit>) -> Result<(), Stop> {
        let Some(Lowered { makespan, sum, .. }) = self.lowered() else {
            return Ok(());
        };
        fixed.extend(self.deadlines(makespan));
        let mut delays = Vec::new();
        for agent in 0..self.problem.agents() {
            for time in self.problem.optima[agent]..makespan {
                delays.extend(self.team.by(agent, time).map(|by| !by));
            }
        }
        let outputs = totalizer(&delays, self.team.clauses())?;
        let least: u32 = self.problem.optima.iter().sum();
        let delay = |sum: u32| (sum - least) as usize;
        let fewer = outputs.iter().take(delay(sum));
        let levels: Vec<Vec<Lit>> = fewer.map(|&more| vec![!more]).collect();
        self.lower(least as usize, &levels, fixed, |it| it.sum as usize)?;
        let sum = self.lowered().map_or(sum, |best| best.sum);
        fixed.extend(outputs.get(delay(sum)).map(|&more| !more));
        Ok(())
    }
}
