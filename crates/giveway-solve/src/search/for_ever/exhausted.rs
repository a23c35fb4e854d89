//! What exhausting the joint states shows: it knows no horizon.

use std::collections::BTreeMap;

use giveway_model::{Cost, sorting};

use super::ForEver;
use crate::{
    budget::{Budget, Stop},
    joint::{self, AllStates},
    problem::Problem,
    search::{aim::Bounded, incumbent::Incumbent, tally::least},
};

impl From<AllStates> for ForEver {
    fn from(AllStates { .. }: AllStates) -> Self {
        Self(())
    }
}

/// The least value of a cost at any horizon.
#[derive(Clone, Copy, Debug)]
pub(in crate::search) struct Known {
    pub(in crate::search) least: u32,
    pub(in crate::search) reason: ForEver,
}

/// The least charges, moves or waits at any horizon, where these stand first
/// and the joint states can be exhausted: SAT could show it within the horizon
/// only. It becomes a limit, so that a plan is all that is left to find.
pub(in crate::search) fn known_for_ever(
    problem: &Problem,
    bounded: &Bounded,
    incumbent: &Incumbent,
    budget: &Budget,
) -> Result<Option<(Cost, Known)>, Stop> {
    let cost = incumbent.objective().costs().first().copied();
    let (Some(cost), Some(costs)) = (cost, incumbent.costs()) else {
        return Ok(None);
    };
    let timed = matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    if timed || !bounded.limits.is_empty() {
        return Ok(None);
    }
    let mut minima = 0;
    for agent in 0..problem.agents() {
        minima += least(problem, agent, cost, budget)?;
    }
    if costs.get(cost) == minima {
        return Ok(None);
    }
    let all: Vec<usize> = (0..problem.agents()).collect();
    match joint::least(problem, &all, cost, budget)? {
        joint::Exhausted::Best(least, shown) => {
            let reason = shown.into();
            Ok(Some((cost, Known { least, reason })))
        }
        _ => Ok(None),
    }
}

/// Some agents have no plan among themselves, as their joint states show.
pub(in crate::search) fn exhausted(
    problem: &Problem,
    agents: &[usize],
    budget: &Budget,
) -> Result<Option<ForEver>, Stop> {
    match joint::any(problem, agents, budget)? {
        joint::Exhausted::None(shown) => Ok(Some(shown.into())),
        _ => Ok(None),
    }
}

/// No plan keeps the limits of charges, moves or waits, as the joint states show.
pub(in crate::search) fn above_limits(
    problem: &Problem,
    bounded: &Bounded,
    budget: &Budget,
) -> Result<Option<ForEver>, Stop> {
    let all: Vec<usize> = (0..problem.agents()).collect();
    for (&cost, &most) in &bounded.limits {
        let counted = !matches!(cost, Cost::Makespan | Cost::SumOfCosts);
        if counted
            && let joint::Exhausted::Best(least, shown) = joint::least(problem, &all, cost, budget)?
            && least > most
        {
            return Ok(Some(shown.into()));
        }
    }
    Ok(None)
}

/// The optima of all costs at any horizon.
pub(in crate::search) struct Optima {
    pub(in crate::search) bounds: BTreeMap<Cost, u32>,
    pub(in crate::search) reason: ForEver,
}

/// The optima of all costs, where the joint states can be
/// exhausted and the best plan is within the horizon: then it is the one at hand.
pub(in crate::search) fn best(
    problem: &Problem,
    incumbent: &mut Incumbent,
    budget: &Budget,
) -> Result<Option<Optima>, Stop> {
    let objective = incumbent.objective().clone();
    let joint::Exhausted::Best(best, shown) = joint::best(problem, &objective, budget)? else {
        return Ok(None);
    };
    incumbent.offer(problem, &best.walks);
    let at_hand = incumbent.costs().map(|costs| costs.vector(&objective));
    if at_hand.is_none_or(|vector| vector != best.vector) {
        return Ok(None);
    }
    let costs = objective.costs().iter().copied();
    let bounds = sorting::map(costs.zip(best.vector));
    let reason = shown.into();
    Ok(Some(Optima { bounds, reason }))
}
