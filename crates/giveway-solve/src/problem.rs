//! An instance as the search sees it: what planners know, and conditions between
//! agents.

use std::collections::BTreeSet;
use std::ops::{Deref, DerefMut};

use giveway_model::{Condition, Instance, sorting::set};
use giveway_planners::problem as planners;

use crate::{
    budget::{Budget, Stop},
    impose::{ImposeError, Unmeetable, impose, with_rules},
    search::free_of_collisions,
    single::{Bounds, NoPlanAlone},
    walk::{Walk, costs_of},
};

pub(crate) use giveway_planners::problem::Relaxed;

/// Everything that is known of an instance before agents meet.
pub(crate) struct Problem {
    planners: planners::Problem,
}

impl Deref for Problem {
    type Target = planners::Problem;

    fn deref(&self) -> &planners::Problem {
        &self.planners
    }
}

impl DerefMut for Problem {
    fn deref_mut(&mut self) -> &mut planners::Problem {
        &mut self.planners
    }
}

/// The proof that an agent has no plan even alone, whatever the horizon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NeverAlone {
    /// It cannot do its task.
    Task(NoPlanAlone),
    /// It cannot meet a condition.
    Condition(Unmeetable),
}

/// Why an instance has no [`Problem`].
pub(crate) enum ProblemError {
    /// This agent cannot do its task, or what a question asks of it, even alone.
    Alone(usize, NeverAlone),
    /// This agent has more waypoints than the exact tables can bear.
    TooManyWaypoints(usize),
    /// The budget was spent.
    Stopped(Stop),
}

impl From<planners::ProblemError> for ProblemError {
    fn from(error: planners::ProblemError) -> Self {
        match error {
            planners::ProblemError::Alone(agent, never) => {
                Self::Alone(agent, NeverAlone::Task(never))
            }
            planners::ProblemError::TooManyWaypoints(agent) => Self::TooManyWaypoints(agent),
            planners::ProblemError::Stopped(stop) => Self::Stopped(stop),
        }
    }
}

impl From<Stop> for ProblemError {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

impl Problem {
    pub(crate) fn new(instance: &Instance, budget: &Budget) -> Result<Self, ProblemError> {
        let planners = planners::Problem::relaxed(instance, Relaxed::default(), budget)?;
        Ok(Self::of(planners))
    }

    const fn of(planners: planners::Problem) -> Self {
        Self { planners }
    }

    /// The same with some rules between agents left out, and with conditions.
    ///
    /// # Errors
    /// As [`Problem::new`], and where a condition cannot be imposed.
    pub(crate) fn relaxed<'a>(
        instance: &Instance,
        relaxed: Relaxed,
        conditions: impl IntoIterator<Item = &'a Condition>,
        budget: &Budget,
    ) -> Result<Self, ImposeError> {
        Self::under(instance, (relaxed, Vec::new()), conditions, budget)
    }

    /// The same with bounds on where the agents may go, in their order, and with conditions.
    ///
    /// # Errors
    /// As [`Problem::new`], and where a condition cannot be imposed.
    pub(crate) fn under<'a>(
        instance: &Instance,
        (relaxed, bounds): (Relaxed, Vec<Bounds>),
        conditions: impl IntoIterator<Item = &'a Condition>,
        budget: &Budget,
    ) -> Result<Self, ImposeError> {
        let conditions: Vec<&Condition> = conditions.into_iter().collect();
        let with_rules = with_rules(instance, conditions.iter().copied());
        let instance = with_rules.as_ref().unwrap_or(instance);
        let planners = planners::Problem::bounded(instance, relaxed, bounds, budget)?;
        let mut problem = Self::of(planners);
        for condition in conditions {
            impose(condition, instance, &mut problem, budget)?;
        }
        Ok(problem)
    }

    /// The same with bounds on where the agents may go, in their order.
    pub(crate) fn bounded(
        instance: &Instance,
        bounds: Vec<Bounds>,
        budget: &Budget,
    ) -> Result<Self, ProblemError> {
        let relaxed = Relaxed::default();
        let planners = planners::Problem::bounded(instance, relaxed, bounds, budget)?;
        Ok(Self::of(planners))
    }

    /// Agents that the SAT solver has to plan, since plans made outside of it
    /// keep to what is asked for by chance only.
    pub(crate) fn insiders(&self) -> BTreeSet<usize> {
        let tasks = self.tasks.iter().enumerate();
        let counted = tasks.filter(|(_, task)| task.conditions.needs_solver());
        let ordered = self.precedences.iter();
        let ordered = ordered.flat_map(|order| [order.first.0, order.second.0]);
        set(counted.map(|(agent, _)| agent).chain(ordered))
    }

    /// Whether there are conditions beside the rules.
    pub(crate) fn has_conditions(&self) -> bool {
        let mut tasks = self.tasks.iter();
        self.has_rules_between() || tasks.any(|task| !task.conditions.is_empty())
    }

    /// Whether walks keep to the conditions beside the rules, as far as
    /// walks made outside the SAT solver may fail to.
    pub(crate) fn keeps(&self, walks: &[Walk]) -> bool {
        let alone = walks.iter().enumerate().all(|(agent, walk)| {
            let charges = costs_of(self, agent, walk).charges;
            self.keeps_alone(agent, walk, charges)
        });
        let in_order = self.precedences.iter().all(|order| order.is_kept(walks));
        alone && in_order && (self.between.is_empty() || free_of_collisions(self, walks))
    }
}
