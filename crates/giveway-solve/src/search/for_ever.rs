//! What is so whatever the horizon.
//!
//! The search looks at plans up to a horizon. A claim goes beyond it only where
//! one of these arguments carries it: a refutation that no cap of the horizon
//! was part of, a bound on time that every better plan keeps, the agents' own
//! minima, or joint states that are exhausted. Each of them makes a [`ForEver`]
//! out of a value that only the place can make which proves it: an agent alone
//! ([`Hopeless`]), a question ([`Unmeetable`]), a limit ([`LimitTooLow`]), the
//! joint states ([`AllStates`](crate::joint::AllStates)), or a call of the SAT
//! solver ([`AssumptionCore`], [`NoneCloser`]). So no claim can be called complete
//! without one.

mod bounds;
mod exhausted;
mod optima;
mod reach;

use giveway_model::{Cost, Costs, Objective, sorting::map};

use super::{
    aim::Bounded,
    closest::NoneCloser,
    growing::AssumptionCore,
    horizon::Horizon,
    stage::{LimitTooLow, Search},
};
use crate::{budget::Stop, counterfactual::Unmeetable, problem::Problem, single::Hopeless};

pub(crate) use bounds::{lone_bound, reach_of_bounds};
pub(super) use exhausted::{Known, above_limits, best, exhausted, known_for_ever, soonest};
pub(super) use optima::OfOptima;
pub(crate) use reach::Reach;

/// A reason why a claim holds whatever the horizon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ForEver(());

impl From<Hopeless> for ForEver {
    fn from(_: Hopeless) -> Self {
        Self(())
    }
}

impl From<Unmeetable> for ForEver {
    fn from(_: Unmeetable) -> Self {
        Self(())
    }
}

impl From<LimitTooLow> for ForEver {
    fn from(_: LimitTooLow) -> Self {
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
fn limits_time(problem: &Problem, bounded: &Bounded) -> Option<ForEver> {
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

/// How far it reaches what is shown of all plans that are as good as the best one, up
/// to a horizon: as far as the claim that it is the best, where none of them takes
/// longer than the horizon.
pub(crate) fn reach_of_best_plans(
    problem: &Problem,
    (objective, best): (&Objective, &Costs),
    horizon: u32,
    optimum: Reach,
) -> Reach {
    let limits = objective.costs().iter().map(|&cost| (cost, best.get(cost)));
    let bounded = Bounded {
        horizon: Horizon::at(horizon),
        limits: map(limits),
    };
    let limited = have_limited_time(problem, &bounded).then_some(ForEver(()));
    Reach::new(limited, horizon).and(optimum)
}

/// An agent that arrives too late, even alone, for what is asked for; and whether
/// it does at any horizon.
pub(super) fn too_late(problem: &Problem, bounded: &Bounded) -> Option<(usize, Option<ForEver>)> {
    let horizon = bounded.latest();
    let latest = |agent: usize| horizon.min(problem.not_after(agent));
    let agent = (0..problem.agents()).find(|&agent| problem.optima[agent] > latest(agent))?;
    let alone = problem.optima[agent] > problem.not_after(agent);
    let reason = limits_time(problem, bounded).or(alone.then_some(ForEver(())));
    Some((agent, reason))
}

/// How far it reaches that no plan is closer to a given one. No assumed deadline
/// has a part in it.
pub(super) fn none_closer(search: &Search, _: NoneCloser) -> Reach {
    let free = search.allowed.deadlines.free_of_horizon(&[]);
    Reach::new(free.then_some(ForEver(())), search.latest())
}

/// A refutation of every plan, whose core names the caps of these agents:
/// whether there is none at any horizon. It is so by the refutation itself, by
/// the limits, or by exhausting the joint states of the agents that clash.
pub(super) fn impossible(
    search: &Search,
    bounded: &Bounded,
    core: &AssumptionCore,
) -> Result<Option<ForEver>, Stop> {
    let (problem, budget) = (search.problem, &search.allowed.budget);
    let clash = core.agents();
    if search.allowed.deadlines.free_of_horizon(clash) {
        return Ok(Some(ForEver(())));
    }
    if let Some(reason) = limits_time(problem, bounded).or(exhausted(problem, clash, budget)?) {
        return Ok(Some(reason));
    }
    above_limits(problem, bounded, budget)
}
