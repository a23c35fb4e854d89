//! Another best plan, as different from this one as can be.

use super::{Farthest, Known, every::Every, formula::Way};
use crate::{
    budget::Stop,
    encode::totalizer::totalizer,
    sat::{Clauses, Lit},
};

/// Entries that may differ, beyond which it is not proved that none is farther.
const MOST_ENTRIES: usize = 600;

/// The farthest plan, as far as it is known.
pub(super) struct Distance {
    /// Whether it is proved that none is farther than those that were found.
    most: Known,
}

impl Distance {
    /// Of all best plans, where they were all found.
    pub(super) const fn new(all_found: bool) -> Self {
        Self {
            most: if all_found { Known::Yes } else { Known::Open },
        }
    }

    /// Settles it: half of what is possible still is tried, or excluded, each time.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn settle(&mut self, every: &mut Every) -> Result<(), Stop> {
        if self.most.is_proved() {
            return Ok(());
        }
        let own = every.own().to_vec();
        if every.others().is_empty() {
            let another = every.other_than(&own);
            let is_found = every.find(&[another])?;
            every.formula.retire(another);
            if !is_found {
                self.most = Known::Yes;
                return Ok(());
            }
        }
        // Agents that rest anywhere differ for as long as one counts: no number of
        // entries is the most.
        if every.problem.tasks.iter().any(|task| task.goal.is_none()) {
            return Ok(());
        }
        let same: Vec<Lit> = every.marks(&own);
        if same.len() > MOST_ENTRIES {
            return Ok(());
        }
        // "More than k entries are the same", so that at least n - k differ.
        let sum = totalizer(&same, every.formula.clauses())?;
        let mut most = same.len() as u32;
        loop {
            let best = farthest(every).map_or(0, |(_, differs)| differs);
            if best >= most {
                break;
            }
            let aim = best + (most - best).div_ceil(2);
            let allowed = same.len() as u32 - aim;
            let Some(&more) = sum.get(allowed as usize) else {
                break;
            };
            if !every.find(&[!more])? {
                most = aim - 1;
                every.formula.clauses().clause(&[more]);
            }
        }
        self.most = Known::Yes;
        Ok(())
    }

    /// The farthest plan, as far as it is known.
    pub(super) fn told(&self, every: &Every) -> Farthest {
        match farthest(every) {
            Some((ways, differs)) => Farthest::Found {
                plan: Box::new(every.plan(ways)),
                differs,
                most: self.most,
            },
            None if self.most.is_proved() => Farthest::Only,
            None => Farthest::Unknown,
        }
    }
}

/// The farthest of the plans that were found, and in how much it differs.
fn farthest<'e>(every: &'e Every) -> Option<(&'e [Way], u32)> {
    let mut farthest: Option<(&[Way], u32)> = None;
    for plan in every.others() {
        let differs = differs(every, plan);
        if farthest.is_none_or(|(_, most)| differs > most) {
            farthest = Some((plan, differs));
        }
    }
    farthest
}

/// In how many entries and charges a plan differs from the one that is asked about.
fn differs(every: &Every, plan: &[Way]) -> u32 {
    let mut count = 0;
    for (agent, (way, own)) in plan.iter().zip(every.own()).enumerate() {
        let at = |way: &Way, time| every.place(agent, way, time);
        let times = 0..=way.arrival().max(own.arrival());
        count += times.filter(|&t| at(way, t) != at(own, t)).count();
        let alone = |a: &Way, b: &Way| {
            let charges = a.charges.iter();
            charges.filter(|time| !b.charges.contains(time)).count()
        };
        count += alone(way, own) + alone(own, way);
    }
    count as u32
}
