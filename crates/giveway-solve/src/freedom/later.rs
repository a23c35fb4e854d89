//! How much later agents can arrive in best plans.

use super::{Later, every::Every};
use crate::budget::Stop;

/// How much later than in this plan each agent arrives in some best plan.
pub(super) struct Latest {
    /// By agent: whether it is proved that it can be no later than in the plans found.
    proved: Vec<bool>,
}

impl Latest {
    /// Nothing is proved yet.
    pub(super) fn new(every: &Every) -> Self {
        Self {
            proved: every.own().iter().map(|_| false).collect(),
        }
    }

    /// Settles all of it.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn settle(&mut self, every: &mut Every) -> Result<(), Stop> {
        for (agent, proved) in self.proved.iter_mut().enumerate() {
            loop {
                let latest = latest(every, agent);
                if latest >= every.formula.cap(agent) {
                    break;
                }
                let later = !every.formula.by(agent, latest);
                if !every.find(&[later])? {
                    break;
                }
            }
            *proved = true;
        }
        Ok(())
    }

    /// The later arrivals, agent by agent, as far as they are known.
    pub(super) fn told(&self, every: &Every) -> Vec<Later> {
        let each = every.own().iter().zip(&self.proved).enumerate();
        each.map(|(agent, (way, &proved))| {
            let later = latest(every, agent).saturating_sub(way.arrival());
            if proved {
                Later::Exactly(later)
            } else {
                Later::AtLeast(later)
            }
        })
        .collect()
    }
}

/// The latest arrival of an agent in the plans that were found.
fn latest(every: &Every, agent: usize) -> u32 {
    let ways = every.found().iter().filter_map(|plan| plan.get(agent));
    ways.map(super::formula::Way::arrival).max().unwrap_or(0)
}
