//! How many steps a plan may need, and how many are looked at by default.

use giveway_model::{Cost, Grid};

use super::Problem;
use crate::{bottleneck::Bottlenecks, budget::Unlimited};

/// The least agents of which it is counted what they need at a bottleneck, for the horizon.
const FEWEST_IN_QUEUE: usize = 4;

impl Problem {
    /// The largest of the earliest arrivals and of the ends of breakdowns: others
    /// may have to wait for an agent that has arrived and broken down.
    pub(super) fn longest(&self) -> u32 {
        let held = self.tasks.iter().map(|task| task.earliest_move);
        self.optima.iter().copied().chain(held).max().unwrap_or(0)
    }

    /// A number of steps that no plan needs to exceed: one with more comes to
    /// the same joint state twice, and what lies between can be left out, which
    /// makes no cost higher. `None` where the number is too large to be of use.
    pub fn sufficient_horizon(&self) -> Option<u32> {
        let slow = (0..self.terrain.size() as u32).flat_map(|v| self.terrain.arcs(v));
        let places = self.terrain.size() + slow.filter(|arc| arc.slow).count();
        let mut states: u32 = 1;
        let mut timed = self.between.last_time().unwrap_or(0);
        for task in &self.tasks {
            // On the way; and at the end, one step or more.
            let way = [
                places + 1,
                task.masks(),
                task.levels(),
                task.conditions.counts(),
            ]
            .iter()
            .try_fold(1u32, |product, &factor| {
                product.checked_mul(u32::try_from(factor).ok()?)
            })?;
            let ends = u32::try_from(task.goal.map_or(self.terrain.size(), |_| 1)).ok()?;
            states = states.checked_mul(way.checked_add(ends.checked_mul(2)?)?)?;
            let resting = task.not_resting.iter().map(|&(_, time)| time);
            let times = resting.chain(task.last_time()).chain([task.not_before]);
            timed = times.fold(timed, u32::max);
        }
        // A gap remembers where the agents were, a precedence whether the first has been there.
        states = states.checked_pow(self.between.gap().checked_add(1)?)?;
        states = states.checked_mul(2u32.checked_pow(self.precedences.len() as u32)?)?;
        // The conditions differ at each of these times.
        states.checked_add(timed)?.checked_add(2)
    }

    /// The makespan beyond which nothing is looked for, by default. Where agents under rules need
    /// more at a bottleneck, it is as much later than that.
    pub fn default_horizon(&self, grid: &Grid) -> u32 {
        let around = 4 * (grid.width() + grid.height()) + 10;
        let default = self.longest.saturating_add(around);
        if !self.has_rules_between() {
            return default;
        }
        let queues = Bottlenecks::of(self, FEWEST_IN_QUEUE, &Unlimited::default());
        let queues = queues.unwrap_or_default();
        match queues.bound(self, Cost::Makespan, None) {
            Some(queue) if queue.at_least > default => queue.at_least.saturating_add(around),
            _ => default,
        }
    }
}
