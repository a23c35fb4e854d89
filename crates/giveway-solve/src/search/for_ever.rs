//! Claims that hold whatever the horizon.
//!
//! The search looks at plans up to a horizon. A claim goes beyond it only where
//! one of these arguments carries it: a refutation that no cap of the horizon
//! was part of ([`NoHorizon`](super::deadlines::NoHorizon)), a bound on time that every
//! better plan keeps ([`AllInTime`]), what agents need
//! alone ([`NeededAlone`](super::minima::NeededAlone), [`LimitTooLow`]), or joint
//! states that are exhausted ([`AllStates`](crate::joint::AllStates)). Each is a
//! value that only its proof makes; [`ForEver`] is made of these ([`token`]).

mod bounds;
mod exhausted;
mod optima;
mod proved;
mod token;

use giveway_model::{Cost, Costs, Objective, sorting::map};

use super::{
    aim::Bounded,
    closest::NoneCloser,
    counting::{Counting, too_many_rest},
    growing::AssumptionCore,
    horizon::{AllInTime, Horizon},
    minima::{LimitTooLow, Minima},
    stage::Search,
};
use crate::{
    budget::{Budget, Stop},
    problem::Problem,
};

pub(crate) use bounds::reach_of_bounds;
pub(super) use exhausted::{LeastForEver, above_limits, best, exhausted, known_for_ever, soonest};
pub(super) use optima::OfOptima;
pub(crate) use proved::Proved;
pub(super) use token::Least;
pub(crate) use token::{ForEver, NoPlan};

/// Every plan that keeps the limits arrives within the horizon, or has a
/// counterpart that does.
fn limits_time(problem: &Problem, bounded: &Bounded) -> Option<AllInTime> {
    let Bounded { horizon, limits } = bounded;
    let by_limits = || horizon.covers_limits(problem, limits);
    horizon.covers_all().or_else(by_limits)
}

/// How far it reaches what is shown of all plans that are as good as the best one, up
/// to a horizon: as far as the claim that it is the best, where none of them takes
/// longer than the horizon.
pub(crate) fn reach_of_best_plans(
    problem: &Problem,
    (objective, best): (&Objective, &Costs),
    horizon: u32,
    optimum: Proved,
) -> Proved {
    let costs = objective.costs().iter();
    let limits = map(costs.map(|&cost| (cost, best.get(cost))));
    let in_time = Horizon::at(horizon).covers_limits(problem, &limits);
    Proved::new(in_time.map(ForEver::<Least>::from), horizon).and(optimum)
}

/// An agent, and why it arrives too late at any horizon, if it does.
type TooLate = (usize, Option<ForEver<NoPlan>>);

/// An agent that arrives too late, even alone, for what is asked for; and whether
/// it does at any horizon.
pub(super) fn too_late(
    problem: &Problem,
    bounded: &Bounded,
    budget: &Budget,
) -> Result<Option<TooLate>, Stop> {
    let horizon = bounded.latest();
    let latest = |agent: usize| horizon.min(problem.not_after(agent));
    let mut agents = 0..problem.agents();
    let Some(agent) = agents.find(|&agent| problem.optima[agent] > latest(agent)) else {
        return Ok(None);
    };
    let optimum = Minima::default().of_one(problem, agent, Cost::Makespan, budget)?;
    let alone = optimum.spare(problem.not_after(agent)).err();
    let in_time = limits_time(problem, bounded).map(ForEver::from);
    let reason = in_time.or(alone.map(ForEver::from));
    Ok(Some((agent, reason)))
}

/// An agent that must have less of a cost than it could have alone.
pub(super) fn asked_below_minimum(
    problem: &Problem,
    budget: &Budget,
) -> Result<Option<(usize, LimitTooLow)>, Stop> {
    for (agent, task) in problem.tasks.iter().enumerate() {
        for (cost, most) in task.conditions.counted_limits() {
            let least = Minima::default().of_one(problem, agent, cost, budget)?;
            if let Err(too_low) = least.spare(most) {
                return Ok(Some((agent, too_low)));
            }
        }
    }
    Ok(None)
}

/// Agents that cannot all arrive in time, and why not at any horizon, if so.
type QueuesTooLate = (Vec<usize>, Option<ForEver<NoPlan>>);

/// Agents at a bottleneck that cannot all arrive in time, as counting shows; and whether they
/// cannot at any horizon.
pub(super) fn queue_too_long(
    problem: &Problem,
    bounded: &Bounded,
    budget: &Budget,
) -> Result<Option<QueuesTooLate>, Stop> {
    let mut agents = 0..problem.agents();
    let is_limited =
        !bounded.limits.is_empty() || agents.any(|agent| problem.not_after(agent) < u32::MAX);
    if !(is_limited || problem.has_rules_between()) {
        return Ok(None);
    }
    if let Some((agents, shown)) = too_many_rest(problem) {
        return Ok(Some((agents, Some(shown.into()))));
    }
    let counting = Counting::of(problem, budget)?;
    let limit = bounded.limits.get(&Cost::Makespan).copied();
    let demanded = |agent| problem.not_after(agent).min(limit.unwrap_or(u32::MAX));
    if let Some((agents, shown)) = counting.too_late(demanded) {
        return Ok(Some((agents, Some(shown.into()))));
    }
    let most = bounded.limits.get(&Cost::SumOfCosts).copied();
    if let Some((counted, bottleneck)) = counting.bound(problem, Cost::SumOfCosts, limit)
        && let Some(shown) = most.and_then(|most| counted.refutes(most))
    {
        return Ok(Some((bottleneck.agents().collect(), Some(shown.into()))));
    }
    let latest = bounded.latest();
    let late = counting.too_late(|agent| demanded(agent).min(latest));
    Ok(late.map(|(agents, _)| (agents, limits_time(problem, bounded).map(ForEver::from))))
}

/// How far it reaches that no plan is closer to a given one. No assumed deadline
/// has a part in it.
pub(super) fn none_closer(search: &Search, shown: NoneCloser) -> Proved {
    let free = search.deadlines.free_of_horizon(&[]);
    let reason = free.map(|free| ForEver::refuted(&shown, free));
    Proved::new(reason, search.latest())
}

/// A refutation of every plan, whose core names the caps of these agents:
/// whether there is none at any horizon. It is so by the refutation itself, by
/// the limits, or by exhausting the joint states of the agents that clash.
pub(super) fn impossible(
    search: &Search,
    bounded: &Bounded,
    core: &AssumptionCore,
) -> Result<Option<ForEver<NoPlan>>, Stop> {
    let (problem, budget) = (search.problem, &search.budget);
    let clash = core.agents();
    if let Some(free) = search.deadlines.free_of_horizon(clash) {
        return Ok(Some(ForEver::refuted(core, free)));
    }
    let in_time = limits_time(problem, bounded).map(ForEver::from);
    if let Some(reason) = in_time.or(exhausted(problem, clash, budget)?) {
        return Ok(Some(reason));
    }
    above_limits(problem, bounded, budget)
}
