//! Whether the optima of several costs, each given those before it, are optima
//! whatever the horizon.

use giveway_model::Cost;

use super::{ForEver, latest_of_sum, limits_time};
use crate::{
    budget::Stop,
    problem::Problem,
    search::{aim::Bounded, stage::Search},
};

/// What is known of the stages that have ended.
pub(in crate::search) struct OfOptima {
    /// Why no plan counts that is later than the horizon. Once the makespan or
    /// the sum of costs is bounded, none does.
    time_is_bounded: Option<ForEver>,
    /// Why all optima so far hold at any horizon; `None` where one may not, or
    /// there is none yet.
    all: Option<ForEver>,
    any: bool,
}

impl OfOptima {
    /// No stage has ended yet.
    pub(in crate::search) fn new(problem: &Problem, bounded: &Bounded) -> Self {
        Self {
            time_is_bounded: limits_time(problem, bounded),
            all: None,
            any: false,
        }
    }

    /// A stage has ended with the least value of a cost, which may be `known` to
    /// be the least at any horizon.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(in crate::search) fn and(
        &mut self,
        search: &mut Search,
        (cost, least): (Cost, u32),
        known: Option<ForEver>,
        bounded: &Bounded,
    ) -> Result<(), Stop> {
        let reason = match self.time_is_bounded.or(known) {
            None => of_bound(search, cost, least, bounded)?,
            known => known,
        };
        self.all = if self.any {
            self.all.and(reason)
        } else {
            reason
        };
        self.any = true;
        // Among plans with this optimum none is later.
        let timed = matches!(cost, Cost::Makespan | Cost::SumOfCosts);
        self.time_is_bounded = self.time_is_bounded.or(timed.then_some(ForEver(())));
        Ok(())
    }

    /// Why all of them hold at any horizon.
    pub(in crate::search) const fn reason(&self) -> Option<ForEver> {
        self.all
    }
}

/// Whether the bound on a cost holds whatever the horizon.
fn of_bound(
    search: &mut Search,
    cost: Cost,
    least: u32,
    bounded: &Bounded,
) -> Result<Option<ForEver>, Stop> {
    let holds = match cost {
        // A plan of a lesser makespan would be within the horizon.
        Cost::Makespan => true,
        Cost::SumOfCosts => {
            let latest = latest_of_sum(search.problem, least);
            search.allowed.deadlines.free_of_horizon(&[]) || bounded.horizon.latest() >= latest
        }
        _ => least == search.sum_of_minima(cost)? || search.allowed.deadlines.free_of_horizon(&[]),
    };
    Ok(holds.then_some(ForEver(())))
}
