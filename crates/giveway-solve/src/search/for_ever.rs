//! What is so whatever the horizon.
//!
//! The search looks at plans up to a horizon. A claim goes beyond it only where
//! one of these arguments carries it: a refutation that no cap of the horizon
//! was part of, a bound on time that every better plan keeps, the agents' own
//! minima, or joint states that are exhausted. Each of them makes a [`ForEver`],
//! and nothing else does, so no claim can be called complete without one.

use std::collections::BTreeMap;

use giveway_model::{Cost, sorting};

use super::{incumbent::Incumbent, lexicographic::Bounded, stage::Search, tally::least};
use crate::{
    budget::{Budget, Stop},
    joint,
    problem::Problem,
};

/// A reason why a claim holds whatever the horizon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ForEver(());

/// How far a claim reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reach {
    /// Whatever the horizon.
    ForEver(ForEver),
    /// Among plans of at most this makespan.
    Within(u32),
}

impl Reach {
    /// Beyond a horizon only with a reason.
    pub(crate) fn new(reason: Option<ForEver>, horizon: u32) -> Self {
        reason.map_or(Self::Within(horizon), Self::ForEver)
    }

    /// Whether it reaches beyond every horizon.
    pub(crate) const fn is_complete(self) -> bool {
        matches!(self, Self::ForEver(_))
    }

    /// The makespan up to which it reaches; `None` for any.
    pub(crate) const fn within(self) -> Option<u32> {
        match self {
            Self::ForEver(_) => None,
            Self::Within(horizon) => Some(horizon),
        }
    }

    /// Up to where both of two claims reach.
    pub(crate) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Within(a), Self::Within(b)) => Self::Within(a.min(b)),
            (Self::ForEver(_), reach) | (reach, Self::ForEver(_)) => reach,
        }
    }

    /// Whether it reaches as far as another.
    pub(crate) fn covers(self, other: Self) -> bool {
        match (self, other) {
            (Self::ForEver(_), _) => true,
            (Self::Within(_), Self::ForEver(_)) => false,
            (Self::Within(a), Self::Within(b)) => a >= b,
        }
    }

    /// Up to where one of two reasons for a claim reaches.
    pub(crate) fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Within(a), Self::Within(b)) => Self::Within(a.max(b)),
            (Self::Within(_), reach) | (reach, Self::Within(_) | Self::ForEver(_)) => reach,
        }
    }
}

impl ForEver {
    /// Both of two claims hold whatever the horizon, where each does.
    pub(super) fn both(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        one.and(other)
    }

    /// An agent that cannot do its task alone, as its exact tables show: they
    /// know no horizon.
    pub(crate) const fn alone() -> Self {
        Self(())
    }

    /// Nothing costs less than nothing.
    pub(crate) const fn less_than_nothing() -> Self {
        Self(())
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

/// Every plan that keeps the limits arrives within the horizon, or has a
/// counterpart that does.
pub(super) fn limits_time(problem: &Problem, bounded: &Bounded) -> Option<ForEver> {
    let limited = bounded.horizon.is_beyond_use() || have_limited_time(problem, bounded);
    limited.then_some(ForEver(()))
}

/// Whether every plan that keeps the limits arrives within the horizon.
pub(super) fn have_limited_time(problem: &Problem, bounded: &Bounded) -> bool {
    let makespan = bounded.limits.get(&Cost::Makespan).copied();
    let sum = bounded.limits.get(&Cost::SumOfCosts);
    let longest = sum.map(|&sum| latest_of_sum(problem, sum));
    let mut latest = makespan.into_iter().chain(longest);
    latest.any(|latest| latest <= bounded.horizon.latest())
}

/// An agent that arrives too late, even alone, for what is asked for.
pub(super) fn too_late(problem: &Problem, bounded: &Bounded, agent: usize) -> Option<ForEver> {
    let alone = problem.optima[agent] > problem.not_after(agent);
    limits_time(problem, bounded).or(alone.then_some(ForEver(())))
}

/// The agents' own minima, from exact tables, exceed a limit.
pub(super) const fn above_minima() -> ForEver {
    ForEver(())
}

/// Later costs among plans that the optimum of this one holds within a time.
pub(super) fn time_is_bounded(cost: Cost) -> Option<ForEver> {
    matches!(cost, Cost::Makespan | Cost::SumOfCosts).then_some(ForEver(()))
}

/// Whether the bound on a cost holds whatever the horizon.
pub(super) fn of_bound(
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
            search.deadlines.free_of_horizon(&[]) || bounded.horizon.latest() >= latest
        }
        _ => least == search.sum_of_minima(cost)? || search.deadlines.free_of_horizon(&[]),
    };
    Ok(holds.then_some(ForEver(())))
}

/// How far a refutation reaches in which no assumed deadline has a part.
pub(super) fn of_refutation(search: &Search) -> Reach {
    let free = search.deadlines.free_of_horizon(&[]);
    Reach::new(free.then_some(ForEver(())), search.latest())
}

/// The least value of a cost at any horizon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    pub(super) least: u32,
    pub(super) reason: ForEver,
}

/// The least charges, moves or waits at any horizon, where these stand first
/// and the joint states can be exhausted: SAT could show it within the horizon
/// only. It becomes a limit, so that a plan is all that is left to find.
pub(super) fn known_for_ever(
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
        joint::Exhausted::Best(least) => {
            let reason = ForEver(());
            Ok(Some((cost, Known { least, reason })))
        }
        _ => Ok(None),
    }
}

/// Some agents have no plan among themselves, as their joint states show.
pub(super) fn exhausted(
    problem: &Problem,
    agents: &[usize],
    budget: &Budget,
) -> Result<Option<ForEver>, Stop> {
    let found = joint::any(problem, agents, budget)?;
    Ok((found == joint::Exhausted::None).then_some(ForEver(())))
}

/// A refutation of every plan, whose core names the caps of these agents:
/// whether there is none at any horizon. It is so by the refutation itself, by
/// the limits, or by exhausting the joint states of the agents that clash.
pub(super) fn impossible(
    search: &Search,
    bounded: &Bounded,
    clash: &[usize],
) -> Result<Option<ForEver>, Stop> {
    let (problem, budget) = (search.problem, &search.budget);
    if search.deadlines.free_of_horizon(clash) {
        return Ok(Some(ForEver(())));
    }
    if let Some(reason) = limits_time(problem, bounded).or(exhausted(problem, clash, budget)?) {
        return Ok(Some(reason));
    }
    above_limits(problem, bounded, budget)
}

/// No plan keeps the limits of charges, moves or waits, as the joint states show.
pub(super) fn above_limits(
    problem: &Problem,
    bounded: &Bounded,
    budget: &Budget,
) -> Result<Option<ForEver>, Stop> {
    let all: Vec<usize> = (0..problem.agents()).collect();
    for (&cost, &most) in &bounded.limits {
        let counted = !matches!(cost, Cost::Makespan | Cost::SumOfCosts);
        if counted
            && let joint::Exhausted::Best(least) = joint::least(problem, &all, cost, budget)?
            && least > most
        {
            return Ok(Some(ForEver(())));
        }
    }
    Ok(None)
}

/// The optima of all costs at any horizon.
pub(super) struct Optima {
    pub(super) bounds: BTreeMap<Cost, u32>,
    pub(super) reason: ForEver,
}

/// The optima of all costs, where the joint states can be
/// exhausted and the best plan is within the horizon: then it is the one at hand.
pub(super) fn best(
    problem: &Problem,
    incumbent: &mut Incumbent,
    budget: &Budget,
) -> Result<Option<Optima>, Stop> {
    let objective = incumbent.objective().clone();
    let joint::Exhausted::Best(best) = joint::best(problem, &objective, budget)? else {
        return Ok(None);
    };
    incumbent.offer(problem, &best.walks);
    let at_hand = incumbent.costs().map(|costs| costs.vector(&objective));
    if at_hand.is_none_or(|vector| vector != best.vector) {
        return Ok(None);
    }
    let costs = objective.costs().iter().copied();
    let bounds = sorting::map(costs.zip(best.vector));
    let reason = ForEver(());
    Ok(Some(Optima { bounds, reason }))
}
