//! As few entries as can be differ, from above, until one fewer is refuted.

use super::{ClosestPlan, Near, NoneCloser};
use crate::{
    budget::Stop,
    encode::totalizer::merge,
    sat::{Clauses, Lit},
    search::growing::{Growing, Until},
    single::Place,
    walk::{Walk, arrival},
};

/// Entries of all agents inside, beyond which nothing is tried.
const MOST_ENTRIES: usize = 1500;

impl Near<'_, '_> {
    /// As few entries as can be differ; the proof of it, where there is one.
    pub(super) fn few_entries(
        &mut self,
        close: &mut ClosestPlan,
    ) -> Result<Option<NoneCloser>, Stop> {
        let insiders = self.search.team.insiders();
        let latest: Vec<u32> = insiders
            .iter()
            .map(|&agent| {
                self.search
                    .cap(agent)
                    .max(arrival(&self.before[agent].walk))
            })
            .collect();
        let entries: usize = latest.iter().map(|&cap| cap as usize + 1).sum();
        if entries > MOST_ENTRIES {
            return Ok(None);
        }
        let mut best = self.entries(&close.walks);
        let mut sum: Vec<Lit> = Vec::new();
        for (&agent, &latest) in insiders.iter().zip(&latest) {
            let out = self.search.team.clauses();
            let lits: Vec<Lit> = (0..=latest).map(|_| out.fresh()).collect();
            for lit in &lits {
                sum = merge(&sum, &[*lit], best, out)?;
            }
            self.differs.insert(agent, lits);
        }
        self.search
            .team
            .reach(latest.iter().copied().max().unwrap_or(0))?;
        // The sum was cut at the best so far, which is never exceeded again.
        while let Some(&more) = best.checked_sub(1).and_then(|k| sum.get(k)) {
            self.search.team.harden(!more);
            loop {
                self.extend()?;
                match self.search.solve_growing(Vec::new(), Until::EVER)? {
                    Growing::Model => break,
                    Growing::Grown(_) => {}
                    Growing::Core(_) => return Ok(Some(NoneCloser(()))),
                }
            }
            let found = self.read();
            let fewer = self.entries(&found.walks);
            if fewer >= best {
                return Err(Stop::Contradiction);
            }
            best = fewer;
            *close = found;
        }
        Ok(Some(NoneCloser(())))
    }

    /// Entries that differ, arrived agents padded with their goals.
    fn entries(&self, walks: &[Walk]) -> usize {
        let mut count = 0;
        for (agent, (walk, before)) in walks.iter().zip(self.before).enumerate() {
            let task = &self.problem.tasks[agent];
            let at = |walk: &Walk, time: usize| walk.get(time).copied().or(task.end_of(walk));
            let times = 0..walk.len().max(before.walk.len());
            count += times
                .filter(|&time| match (at(walk, time), at(&before.walk, time)) {
                    (Some(now), Some(then)) => !is_same_entry(now, then),
                    (now, then) => now != then,
                })
                .count();
        }
        count
    }
}

/// Whether two places are one entry of a path: in transit is in transit.
pub(super) fn is_same_entry(a: Place, b: Place) -> bool {
    a == b || matches!((a, b), (Place::Along(_), Place::Along(_)))
}
