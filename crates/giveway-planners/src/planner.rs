//! The one door to all planners: what is asked, and how it ended.
//!
//! Each planner promises something else. The types keep the promises apart: only
//! conflict-based search can say that a plan is best or prove a bound, none can
//! say that there is no plan, and what a method cannot do it refuses by name.

mod ability;
mod best;
mod crowds;
mod name;
mod neighbourhoods;
mod ordered;
mod report;
#[cfg(test)]
mod tests;
mod tree;

pub use ability::Inability;
pub use name::{Planner, UnknownPlanner};
pub use neighbourhoods::Improvement;
pub use report::{Halt, Outcome, Report, Trace};
pub use tree::{by_hand, so_far};

use giveway_model::Objective;

use crate::{budget::Budget, prioritised::Order, problem::Problem, walk::Walk};
use best::Best;

/// The request to a planner.
pub struct Asked<'p> {
    /// The instance.
    pub problem: &'p Problem,
    /// The objective by which plans are compared.
    pub objective: &'p Objective,
    /// The makespan that a person allows at most, where it is limited.
    pub within: Option<u32>,
    /// The horizon of methods that need one, where no makespan is given.
    pub default_horizon: u32,
    /// The order of prioritised planning.
    pub order: Order,
    /// Whether a trace is wanted.
    pub traced: bool,
}

impl Asked<'_> {
    /// The horizon of methods that need one.
    fn horizon(&self) -> u32 {
        self.within.unwrap_or(self.default_horizon)
    }
}

/// Plans with a planner; `on_better` gets each plan that is better than those
/// before it, the last of them the plan of the report.
pub fn plan(
    planner: Planner,
    asked: &Asked,
    on_better: &mut dyn FnMut(&[Walk]),
    budget: &dyn Budget,
) -> Report {
    if let Some(lack) = ability::lack(planner, asked.problem) {
        return Report::refused(lack);
    }
    let best = Best::new(asked, on_better);
    match planner {
        Planner::Prioritised => ordered::prioritised(asked, best, budget),
        Planner::Cbs => tree::cbs(asked, best, budget),
        Planner::Pibt => crowds::pibt(asked, best, budget),
        Planner::Lacam => crowds::lacam(asked, best, budget),
        Planner::Lns => neighbourhoods::lns(asked, best, budget),
    }
}
