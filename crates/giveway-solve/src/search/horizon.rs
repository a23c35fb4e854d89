//! The horizon of a search: the one rule, for every question; and which plans are
//! certain to arrive within it.

use std::collections::BTreeMap;

use giveway_model::{Cost, Grid};

use crate::problem::Problem;

/// No search goes beyond this time, so that times can be added.
const LATEST: u32 = 1_000_000_000;

/// The makespan beyond which nothing is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Horizon {
    latest: u32,
    covers_every_plan: bool,
}

/// The proof that all plans that count arrive within a horizon, or have a counterpart of
/// no higher costs that does. Only [`Horizon`] makes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AllInTime(());

impl Horizon {
    /// The horizon that a person set, or else the default of the problem's rules, but at least `at_least`. No
    /// plan ever needs more steps than there are joint states, so no search goes beyond that.
    pub(crate) fn of(problem: &Problem, grid: &Grid, within: Option<u32>, at_least: u32) -> Self {
        let default = problem.default_horizon(grid);
        let asked = within.unwrap_or(default.max(at_least)).min(LATEST);
        match problem.sufficient_horizon() {
            Some(states) if states <= asked => Self {
                latest: states,
                covers_every_plan: true,
            },
            _ => Self::at(asked),
        }
    }

    /// This makespan.
    pub(crate) const fn at(latest: u32) -> Self {
        Self {
            latest,
            covers_every_plan: false,
        }
    }

    /// The makespan.
    pub(crate) const fn latest(self) -> u32 {
        self.latest
    }

    /// Whether a plan that ends later can always be made one that ends in time,
    /// of no higher costs.
    pub(crate) const fn is_beyond_use(self) -> bool {
        self.covers_every_plan
    }

    /// All plans, where later ones are of no use.
    pub(crate) fn covers_all(self) -> Option<AllInTime> {
        self.covers_every_plan.then_some(AllInTime(()))
    }

    /// The plans that have at most this of a cost. (A plan of few charges, moves or
    /// waits may take any time.)
    pub(crate) fn covers(self, problem: &Problem, cost: Cost, most: u32) -> Option<AllInTime> {
        let latest = match cost {
            Cost::Makespan => most,
            Cost::SumOfCosts => latest_of_sum(problem, most),
            Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => return None,
        };
        (latest <= self.latest).then_some(AllInTime(()))
    }

    /// The plans that keep all of these limits.
    pub(crate) fn covers_limits(
        self,
        problem: &Problem,
        limits: &BTreeMap<Cost, u32>,
    ) -> Option<AllInTime> {
        let mut limits = limits.iter();
        limits.find_map(|(&cost, &most)| self.covers(problem, cost, most))
    }

    /// The same, but no later than this.
    pub(crate) fn up_to(self, latest: u32) -> Self {
        if self.latest <= latest {
            self
        } else {
            Self::at(latest)
        }
    }
}

/// No plan with this sum of costs has a later makespan.
fn latest_of_sum(problem: &Problem, sum: u32) -> u32 {
    let total = problem
        .optima
        .iter()
        .fold(0u32, |a, &b| a.saturating_add(b));
    let longest = problem.optima.iter().copied().max().unwrap_or(0);
    sum.saturating_sub(total).saturating_add(longest)
}
