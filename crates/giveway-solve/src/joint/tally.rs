//! The costs that a search of joint states counts.

use std::collections::BTreeMap;

use giveway_model::Cost;

/// The objective and the limits together have no more costs than this.
const MOST_COSTS: usize = 12;

/// Paid so far, or still to be paid: the costs of the objective in their order, then those that
/// are limited, the rest 0. Tallies are compared in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Tally([u32; MOST_COSTS]);

/// The costs that are counted.
pub(super) struct TalliedCosts {
    costs: Vec<Cost>,
    /// The number of those of the objective, which come first.
    objective: usize,
    /// The most that all agents together may have of the others.
    limits: Vec<u32>,
}

impl TalliedCosts {
    pub(super) fn new(objective: &[Cost], limits: &BTreeMap<Cost, u32>) -> Self {
        Self {
            costs: objective.iter().chain(limits.keys()).copied().collect(),
            objective: objective.len(),
            limits: limits.values().copied().collect(),
        }
    }

    /// Whether a cost is counted.
    pub(super) fn has(&self, cost: Cost) -> bool {
        self.costs.contains(&cost)
    }

    /// A value for each cost.
    pub(super) fn tally(&self, of: impl Fn(Cost) -> u32) -> Tally {
        let mut tally = Tally::default();
        for (value, &cost) in tally.0.iter_mut().zip(&self.costs) {
            *value = of(cost);
        }
        tally
    }

    /// The costs to go of all agents from those of each: the makespan is that of the last, the others are
    /// sums.
    pub(super) fn join(&self, one: Tally, other: Tally) -> Tally {
        let mut all = one.and(other);
        for (i, &cost) in self.costs.iter().enumerate() {
            if cost == Cost::Makespan {
                all.0[i] = one.0[i].max(other.0[i]);
            }
        }
        all
    }

    /// The costs of the objective.
    pub(super) fn vector(&self, tally: Tally) -> Vec<u32> {
        tally.0[..self.objective].to_vec()
    }

    /// The costs that are limited.
    pub(super) fn limited<'a>(&self, tally: &'a Tally) -> &'a [u32] {
        &tally.0[self.objective..self.costs.len()]
    }

    /// The number of costs that are limited.
    pub(super) const fn limits(&self) -> usize {
        self.limits.len()
    }

    /// Whether no more is paid of a cost than its limit allows.
    pub(super) fn keeps_limits(&self, tally: Tally) -> bool {
        let mut limited = self.limited(&tally).iter().zip(&self.limits);
        limited.all(|(paid, most)| paid <= most)
    }
}

impl Tally {
    /// The sum, cost by cost.
    pub(super) fn and(mut self, more: Self) -> Self {
        for (paid, more) in self.0.iter_mut().zip(more.0) {
            *paid = paid.saturating_add(more);
        }
        self
    }
}
