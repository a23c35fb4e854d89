//! The horizon of a search: the one rule, for every question.

use giveway_model::Grid;

use crate::problem::Problem;

/// No search goes beyond this time, so that times can be added.
const LATEST: u32 = 1_000_000_000;

/// The makespan beyond which nothing is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Horizon {
    latest: u32,
    beyond_use: bool,
}

impl Horizon {
    /// What a person set, or else the default of the problem's rules, but at
    /// least `at_least`. Beyond as many steps as there are joint states no plan
    /// is ever needed, so no search goes there.
    pub(crate) fn of(problem: &Problem, grid: &Grid, within: Option<u32>, at_least: u32) -> Self {
        let default = problem.default_horizon(grid);
        let asked = within.unwrap_or(default.max(at_least)).min(LATEST);
        match problem.joint_states() {
            Some(states) if states <= asked => Self {
                latest: states,
                beyond_use: true,
            },
            _ => Self::at(asked),
        }
    }

    /// This makespan.
    pub(crate) const fn at(latest: u32) -> Self {
        Self {
            latest,
            beyond_use: false,
        }
    }

    /// The makespan.
    pub(crate) const fn latest(self) -> u32 {
        self.latest
    }

    /// Whether a plan that ends later can always be made one that ends in time,
    /// of no higher costs.
    pub(crate) const fn is_beyond_use(self) -> bool {
        self.beyond_use
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
