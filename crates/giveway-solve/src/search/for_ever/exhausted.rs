//! Claims from exhausted joint states: they hold at every horizon.

use std::collections::BTreeMap;

use giveway_model::{Cost, sorting};

use super::{ForEver, Least, NoPlan};
use crate::{
    budget::{Budget, Stop},
    joint::{self, AllStates},
    problem::Problem,
    search::{aim::Bounded, incumbent::Incumbent, minima::Minima, prove::SearchEnd},
    trace::FoundBy,
};

/// The least value of a cost at any horizon.
#[derive(Clone, Copy, Debug)]
pub(in crate::search) struct LeastForEver {
    pub(in crate::search) least: u32,
    pub(in crate::search) reason: ForEver<Least>,
}

/// The least charges, moves or waits at any horizon, where these stand first
/// and the joint states can be exhausted: SAT could show it within the horizon
/// only. It becomes a limit, so that a plan is all that is left to find.
pub(in crate::search) fn known_for_ever(
    problem: &Problem,
    bounded: &Bounded,
    incumbent: &Incumbent,
    budget: &Budget,
) -> Result<Option<(Cost, LeastForEver)>, Stop> {
    let cost = incumbent.objective().costs().first().copied();
    let (Some(cost), Some(costs)) = (cost, incumbent.costs()) else {
        return Ok(None);
    };
    let timed = matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    if timed || !bounded.limits.is_empty() {
        return Ok(None);
    }
    let lone = Minima::default().bound(problem, cost, budget)?;
    if costs.get(cost) == lone.at_least() {
        return Ok(None);
    }
    let all: Vec<usize> = (0..problem.agents()).collect();
    match joint::least(problem, &all, cost, budget)? {
        joint::Exhaustion::Best(least, shown) => {
            let reason = shown.into();
            Ok(Some((cost, LeastForEver { least, reason })))
        }
        _ => Ok(None),
    }
}

/// Some agents have no plan among themselves, as their joint states show.
pub(in crate::search) fn exhausted(
    problem: &Problem,
    agents: &[usize],
    budget: &Budget,
) -> Result<Option<ForEver<NoPlan>>, Stop> {
    match joint::any(problem, agents, budget)? {
        joint::Exhaustion::None(shown) => Ok(Some(shown.into())),
        _ => Ok(None),
    }
}

/// The plan with the least makespan, where the joint states can be exhausted: it is
/// offered. What is returned is that there is none, or none within the horizon.
pub(in crate::search) fn soonest(
    problem: &Problem,
    bounded: &Bounded,
    incumbent: &mut Incumbent,
    budget: &Budget,
) -> Result<Option<SearchEnd>, Stop> {
    match joint::soonest(problem, budget)? {
        joint::Exhaustion::None(shown) => Ok(Some(SearchEnd::NoPlan(Some(shown.into())))),
        joint::Exhaustion::Best(soonest, _) => {
            incumbent.offer(problem, &soonest.walks, FoundBy::Exhaustion);
            let is_late = soonest.vector.first() > Some(&bounded.latest());
            Ok(is_late.then_some(SearchEnd::NoPlan(None)))
        }
        joint::Exhaustion::TooMany => Ok(None),
    }
}

/// No plan keeps the limits of charges, moves or waits, as the joint states show.
pub(in crate::search) fn above_limits(
    problem: &Problem,
    bounded: &Bounded,
    budget: &Budget,
) -> Result<Option<ForEver<NoPlan>>, Stop> {
    let all: Vec<usize> = (0..problem.agents()).collect();
    for (&cost, &most) in &bounded.limits {
        let counted = !matches!(cost, Cost::Makespan | Cost::SumOfCosts);
        if counted
            && let joint::Exhaustion::Best(least, shown) =
                joint::least(problem, &all, cost, budget)?
            && least > most
        {
            return Ok(Some(shown.into()));
        }
    }
    Ok(None)
}

/// The optima of all costs under the limits: at any horizon, or within the one that
/// is looked at.
pub(in crate::search) struct Optima {
    pub(in crate::search) bounds: BTreeMap<Cost, u32>,
    pub(in crate::search) reason: Option<AllStates>,
}

/// The optima of all costs, where the joint states can be exhausted. The best plan
/// is the one at hand then, or there is none that keeps the limits.
pub(in crate::search) fn best(
    problem: &Problem,
    bounded: &Bounded,
    incumbent: &mut Incumbent,
    budget: &Budget,
) -> Result<Option<Optima>, Stop> {
    let objective = incumbent.objective().clone();
    // Counting a limited cost multiplies the states, so the first try is without limits.
    let free = BTreeMap::new();
    let mut tried = vec![(&free, None)];
    if !bounded.limits.is_empty() {
        tried.push((&bounded.limits, None));
    }
    let latest = Some(bounded.latest());
    if bounded.limits.get(&Cost::Makespan).copied() != latest {
        tried.push((&bounded.limits, latest));
    }
    for (limits, latest) in tried {
        let (vector, shown) = match joint::best(problem, &objective, (limits, latest), budget)? {
            joint::Exhaustion::TooMany => return Ok(None),
            joint::Exhaustion::None(_) if incumbent.costs().is_some() => return Ok(None),
            joint::Exhaustion::None(shown) => (None, shown),
            joint::Exhaustion::Best(best, shown) => {
                incumbent.offer(problem, &best.walks, FoundBy::Exhaustion);
                (Some(best.vector), shown)
            }
        };
        let at_hand = incumbent.costs().map(|costs| costs.vector(&objective));
        if at_hand == vector {
            let costs = objective.costs().iter().copied();
            let bounds = sorting::map(costs.zip(vector.into_iter().flatten()));
            return Ok(Some(Optima {
                bounds,
                reason: shown,
            }));
        }
    }
    Ok(None)
}
