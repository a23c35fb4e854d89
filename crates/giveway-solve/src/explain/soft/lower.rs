//! One number after the other, as low as can be: the breaches, the deadline, the
//! sum of costs.

use super::SoftRules;
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
            let found = self.best.as_ref().map(|best| best.0);
            self.lower_count(deadline)?;
            let now = self.best.as_ref().map(|best| best.0);
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
        let Some((count, latest, ..)) = self.best else {
            return Ok(());
        };
        let breaches = (self.breaches)(&self.team, self.problem);
        let lits: Vec<Lit> = breaches.iter().map(|&(_, lit)| lit).collect();
        let counted = capped(&lits, count + 1, self.team.clauses())?;
        let mut fixed: Vec<Lit> = counted.get(count).map(|&more| !more).into_iter().collect();
        self.lower_deadline(sooner.map_or(first, |d| d + 1), latest, &fixed)?;
        let Some((_, latest, ..)) = self.best else {
            return Ok(());
        };
        fixed.extend(self.deadlines(latest));
        self.lower_sum(latest, &mut fixed)?;
        self.order_breaches(breaches, fixed)
    }

    /// All agents arrive by a time.
    fn deadlines(&mut self, time: u32) -> Vec<Lit> {
        let agents = 0..self.problem.agents();
        let by = |agent| self.team.by(agent, time);
        agents.filter_map(by).collect()
    }

    /// The fewest breaches at a deadline.
    fn lower_count(&mut self, deadline: u32) -> Result<(), Stop> {
        for agent in 0..self.problem.agents() {
            self.team.grow(agent, deadline)?;
        }
        let most = self.best.as_ref().map_or(MOST_BROKEN, |best| best.0 - 1);
        let breaches = (self.breaches)(&self.team, self.problem);
        let lits: Vec<Lit> = breaches.iter().map(|&(_, lit)| lit).collect();
        let counted = capped(&lits, most + 1, self.team.clauses())?;
        let by = self.deadlines(deadline);
        let mut most = Some(most);
        while let Some(k) = most.filter(|&k| k > 0) {
            let mut assumptions = by.clone();
            assumptions.extend(counted.get(k).map(|&more| !more));
            let Some(found) = self.model(&assumptions)? else {
                break;
            };
            most = found.checked_sub(1);
        }
        Ok(())
    }

    /// The earliest deadline for the fewest breaches.
    fn lower_deadline(&mut self, from: u32, latest: u32, fixed: &[Lit]) -> Result<(), Stop> {
        for deadline in from..latest {
            let mut assumptions = self.deadlines(deadline);
            assumptions.extend(fixed);
            if self.model(&assumptions)?.is_some() {
                return Ok(());
            }
        }
        Ok(())
    }

    /// The least sum of costs with the fewest breaches by a deadline.
    fn lower_sum(&mut self, latest: u32, fixed: &mut Vec<Lit>) -> Result<(), Stop> {
        let mut delays = Vec::new();
        for agent in 0..self.problem.agents() {
            for time in self.problem.optima[agent]..latest {
                delays.extend(self.team.by(agent, time).map(|by| !by));
            }
        }
        let least: u32 = self.problem.optima.iter().sum();
        let outputs = totalizer(&delays, self.team.clauses())?;
        loop {
            let Some(&(_, _, sum, _)) = self.best.as_ref() else {
                return Ok(());
            };
            let delay = (sum - least) as usize;
            let fewer = delay.checked_sub(1).and_then(|d| outputs.get(d));
            let mut assumptions = fixed.clone();
            assumptions.extend(fewer.map(|&more| !more));
            if fewer.is_none() || self.model(&assumptions)?.is_none() {
                fixed.extend(outputs.get(delay).map(|&more| !more));
                return Ok(());
            }
        }
    }
}
