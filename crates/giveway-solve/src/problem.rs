//! An instance as the search sees it: what planners know, and what a question asks
//! for between agents.

use std::collections::BTreeSet;
use std::ops::{Deref, DerefMut};

use giveway_model::{Instance, sorting::set};
use giveway_planners::problem as planners;

use crate::{
    budget::{Budget, Stop},
    counterfactual::{Counterfactual, Precedence},
    search::ForEver,
    single::{Task, TaskConstraint},
    terrain::Terrain,
    walk::{Walk, costs_of},
};

pub(crate) use giveway_planners::problem::Relaxed;

/// Everything that is known of an instance before agents meet.
pub(crate) struct Problem {
    planners: planners::Problem,
    /// Who must be at a vertex before whom, where a question asks for it.
    pub(crate) precedence: Option<Precedence>,
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

/// Why an instance has no [`Problem`].
pub(crate) enum ProblemError {
    /// This agent cannot do its task, or what a question asks of it, even alone;
    /// and why that holds whatever the horizon.
    Alone(usize, ForEver),
    /// This agent has more waypoints than the exact tables can bear.
    TooManyWaypoints(usize),
    /// The budget was spent.
    Stopped(Stop),
}

impl From<planners::ProblemError> for ProblemError {
    fn from(error: planners::ProblemError) -> Self {
        match error {
            planners::ProblemError::Alone(agent, hopeless) => Self::Alone(agent, hopeless.into()),
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
        Self::relaxed(instance, Relaxed::default(), None, budget)
    }

    /// The same with some rules between agents left out, and with what a
    /// question asks for.
    pub(crate) fn relaxed(
        instance: &Instance,
        relaxed: Relaxed,
        condition: Option<&Counterfactual>,
        budget: &Budget,
    ) -> Result<Self, ProblemError> {
        let mut problem = Self {
            planners: planners::Problem::relaxed(instance, relaxed, budget)?,
            precedence: None,
        };
        if let Some(condition) = condition {
            condition.impose(instance, &mut problem, budget)?;
        }
        Ok(problem)
    }

    /// A problem of tasks over a terrain, none of them asked for more.
    pub(crate) fn of_tasks(
        terrain: Terrain,
        stays: bool,
        tasks: Vec<Task>,
        budget: &Budget,
    ) -> Result<Self, ProblemError> {
        Ok(Self {
            planners: planners::Problem::of_tasks(terrain, stays, tasks, budget)?,
            precedence: None,
        })
    }

    /// Agents that the SAT solver has to plan, since plans made outside of it
    /// keep to what is asked for by chance only.
    pub(crate) fn insiders(&self) -> BTreeSet<usize> {
        let demands = self.tasks.iter().map(|task| task.demand.as_ref());
        let mut agents = set(demands
            .enumerate()
            .filter(|(_, demand)| demand.is_some_and(TaskConstraint::counts))
            .map(|(agent, _)| agent));
        if let Some(Precedence { first, second, .. }) = self.precedence {
            agents.extend([first, second]);
        }
        agents
    }

    /// Whether a question asks for anything beside the rules.
    pub(crate) fn is_asked(&self) -> bool {
        self.precedence.is_some() || self.tasks.iter().any(|task| task.demand.is_some())
    }

    /// Whether walks keep to what is asked for beside the rules, as far as
    /// walks made outside the SAT solver may fail to.
    pub(crate) fn keeps(&self, walks: &[Walk]) -> bool {
        let alone = walks.iter().enumerate().all(|(agent, walk)| {
            let charges = costs_of(self, agent, walk).charges;
            self.keeps_alone(agent, walk, charges)
        });
        alone && self.precedence.is_none_or(|p| p.is_kept(walks))
    }
}
