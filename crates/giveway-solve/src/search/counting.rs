//! What counting shows at bottlenecks: bounds of costs, and that agents cannot all be in time.
//!
//! The method is `giveway_planners::bottleneck`, whose bounds hold for plans of any makespan.

use giveway_model::Cost;
use giveway_planners::{
    bottleneck::{Bottleneck, Bottlenecks},
    problem::Relaxed,
    rules::SharedKind,
};

use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    problem::Problem,
};

/// The bottlenecks of a problem.
pub(super) struct Counting(Bottlenecks);

/// The bound of a cost that counting shows, whatever the horizon. Only [`Counting`] makes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CountedBound {
    cost: Cost,
    at_least: u32,
}

/// The proof that a bound is one that counting shows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counted(());

/// The proof that agents at a bottleneck cannot all arrive by the times that are demanded of
/// them, keep a limit of their sum of costs, or come to rest in a zone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QueueTooLong(());

impl Counting {
    /// Finds the bottlenecks.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn of(problem: &Problem, budget: &Budget) -> Result<Self, Stop> {
        let fewest = budget.thresholds().fewest_at_gate;
        Ok(Self(Bottlenecks::of(problem, fewest, budget)?))
    }

    /// The largest bound of a cost, where one is above what the agents need alone: of the plans that have
    /// at most a makespan.
    pub(super) fn bound(
        &self,
        problem: &Problem,
        cost: Cost,
        within: Option<u32>,
    ) -> Option<(CountedBound, &Bottleneck)> {
        let counted = self.0.bound(problem, cost, within)?;
        let at_least = counted.at_least;
        Some((CountedBound { cost, at_least }, counted.bottleneck))
    }

    /// The agents at a bottleneck that cannot all arrive by the latest times demanded of them.
    pub(super) fn too_late(
        &self,
        latest: impl Fn(AgentId) -> u32,
    ) -> Option<(Vec<AgentId>, QueueTooLong)> {
        let bottleneck = self.0.too_late(latest)?;
        Some((bottleneck.agents().collect(), QueueTooLong(())))
    }
}

/// Agents that come to rest in a zone in which fewer may be from some time on: wherever they
/// arrive, and whenever.
pub(super) fn too_many_rest(problem: &Problem) -> Option<(Vec<AgentId>, QueueTooLong)> {
    if problem.relaxed != Relaxed::default() {
        return None;
    }
    problem.between.rules.iter().find_map(|rule| {
        let SharedKind::Capacity { area, most, times } = &rule.kind else {
            return None;
        };
        let rests = |agent: &AgentId| {
            let goal = problem.tasks[*agent].goal;
            let is_counted = rule.binds(*agent) && !rule.begins_uncounted(*agent);
            is_counted && problem.rests(*agent) && goal.is_some_and(|goal| area.has(goal))
        };
        let agents: Vec<AgentId> = (0..problem.agents()).filter(rests).collect();
        let is_full = times.to.is_none() && agents.len() > *most as usize;
        is_full.then_some((agents, QueueTooLong(())))
    })
}

impl CountedBound {
    /// The bound.
    pub(super) const fn at_least(self) -> u32 {
        self.at_least
    }

    /// Whether it shows that no plan has as little as a limit of its cost.
    pub(super) fn refutes(self, most: u32) -> Option<QueueTooLong> {
        (self.at_least > most).then_some(QueueTooLong(()))
    }

    /// Whether it shows that no plan has less than this of a cost.
    pub(super) fn shows(self, cost: Cost, bound: u32) -> Option<Counted> {
        (self.cost == cost && bound <= self.at_least).then_some(Counted(()))
    }
}
