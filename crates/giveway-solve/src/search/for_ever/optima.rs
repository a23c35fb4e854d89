//! Whether the optima of several costs, each given those before it, are optima
//! whatever the horizon.

use giveway_model::Cost;

use super::{ForEver, Least, limits_time};
use crate::{
    budget::Stop,
    problem::Problem,
    search::{aim::Bounded, bound::Optimum, stage::Search},
};

/// The optima of the stages that have ended.
pub(in crate::search) struct OfOptima {
    /// Why no plan counts that is later than the horizon. Once the makespan or
    /// the sum of costs is bounded, none does.
    time_is_bounded: Option<ForEver<Least>>,
    /// Why all optima so far hold at any horizon; `None` where one may not, or
    /// there is none yet.
    all: Option<ForEver<Least>>,
    any: bool,
}

impl OfOptima {
    /// No stage has ended yet.
    pub(in crate::search) fn new(problem: &Problem, bounded: &Bounded) -> Self {
        Self {
            time_is_bounded: limits_time(problem, bounded).map(ForEver::from),
            all: None,
            any: false,
        }
    }

    /// A stage has ended with the optimum of a cost, which may be `known` to be one at
    /// any horizon.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(in crate::search) fn and(
        &mut self,
        search: &mut Search,
        optimum: Optimum,
        known: Option<ForEver<Least>>,
        bounded: &Bounded,
    ) -> Result<(), Stop> {
        let reason = match self.time_is_bounded.or(known) {
            None => of_optimum(search, optimum, bounded)?,
            known => known,
        };
        self.all = if self.any {
            self.all.and(reason)
        } else {
            reason
        };
        self.any = true;
        // Among plans with this optimum none is later, if it is one at any horizon.
        let timed = matches!(optimum.cost(), Cost::Makespan | Cost::SumOfCosts);
        self.time_is_bounded = self.time_is_bounded.or(reason.filter(|_| timed));
        Ok(())
    }

    /// Why all of them hold at any horizon.
    pub(in crate::search) const fn reason(&self) -> Option<ForEver<Least>> {
        self.all
    }
}

/// Whether the optimum of a cost is one whatever the horizon.
fn of_optimum(
    search: &mut Search,
    optimum: Optimum,
    bounded: &Bounded,
) -> Result<Option<ForEver<Least>>, Stop> {
    let (cost, least) = (optimum.cost(), optimum.least());
    let in_time = bounded.horizon.covers(search.problem, cost, least);
    if let Some(in_time) = in_time {
        return Ok(Some(in_time.into()));
    }
    if let Some(free) = search.deadlines.free_of_horizon(&[]) {
        return Ok(Some(ForEver::refuted(&optimum, free)));
    }
    let alone = search.team.lone_bound(cost)?.shows(least);
    Ok(alone.map(ForEver::from))
}
