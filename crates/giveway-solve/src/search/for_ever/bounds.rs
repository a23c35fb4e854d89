//! How far bounds reach that a search had proved when it ended early.

use std::collections::BTreeMap;

use giveway_model::{Cost, Objective};

use super::{ForEver, Least, Proved};
use crate::{
    problem::Problem,
    search::{horizon::Horizon, minima::LoneBound},
};

/// How far the bounds reach that a search within a horizon proved before it ended
/// early: of each cost of the objective in turn, as far as it came. `lone` are
/// those that each agent alone shows.
pub(crate) fn reach_of_bounds(
    problem: &Problem,
    horizon: Horizon,
    objective: &Objective,
    bounds: &BTreeMap<Cost, u32>,
    lone: &BTreeMap<Cost, LoneBound>,
) -> Proved {
    let mut reason: Option<ForEver<Least>> = None;
    for &cost in objective.costs() {
        let Some(&bound) = bounds.get(&cost) else {
            break;
        };
        // A plan of less time is within the horizon; so are all among which the later
        // costs are bounded.
        if let Some(in_time) = horizon.covers(problem, cost, bound) {
            return Proved::for_ever(ForEver::<Least>::from(in_time));
        }
        let alone = lone.get(&cost).and_then(|lone| lone.shows(bound));
        let at_any = horizon.covers_all().map(ForEver::from);
        reason = alone.map(ForEver::from).or(at_any);
        if reason.is_none() {
            break;
        }
    }
    Proved::new(reason, horizon.latest())
}
