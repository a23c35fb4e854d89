//! An instance as planners see it: a graph, tasks, exact distances.

mod horizon;
mod walks;

use std::collections::BTreeSet;

use giveway_model::Instance;

use crate::{
    budget::{Budget, Stop},
    rules::{Between, OwnRules, Precedence},
    single::{Bounds, CostToGo, MAX_WAYPOINTS, Metric, NoPlanAlone, Task, earliest},
    terrain::Terrain,
};

/// Rules between agents that do not count, by the agents' numbers: what an
/// explanation leaves out to see whether a plan exists without it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Relaxed {
    /// Pairs that ignore each other, the lower number first.
    pub ignored: BTreeSet<(usize, usize)>,
    /// Agents that are gone on arrival, where they would stay.
    pub gone: BTreeSet<usize>,
}

impl Relaxed {
    /// Whether two agents ignore each other.
    pub fn ignores(&self, a: usize, b: usize) -> bool {
        self.ignored.contains(&(a.min(b), a.max(b)))
    }
}

/// Everything that is known of an instance before agents meet.
pub struct Problem {
    /// The map as a graph.
    pub terrain: Terrain,
    /// Whether arrived agents stay at their goals, but for those that the
    /// relaxation lets go; [`Problem::rests`] tells it of an agent.
    pub stays: bool,
    /// Rules between agents that do not count.
    pub relaxed: Relaxed,
    /// The task of each agent.
    pub tasks: Vec<Task>,
    /// The time that each agent alone still needs, from anywhere.
    pub cost_to_go: Vec<CostToGo>,
    /// The earliest arrival of each agent alone; a lower bound of it where conditions are about
    /// very late times (see [`earliest`]).
    pub optima: Vec<u32>,
    /// Whether rules of the scene's own are in force, or obstacles move.
    pub is_constrained: bool,
    /// Rules of the scene's own between agents.
    pub between: Between,
    /// Which agents must be at a vertex before others.
    pub precedences: Vec<Precedence>,
    /// The largest of the optima and of the ends of breakdowns, without
    /// conditions; and the last time that a rule of the scene's own names.
    longest: u32,
}

/// Why an instance has no [`Problem`].
pub enum ProblemError {
    /// This agent cannot do its task, or what a question asks of it, even alone.
    Alone(usize, NoPlanAlone),
    /// This agent has more waypoints than the exact tables can bear.
    TooManyWaypoints(usize),
    /// The budget was spent.
    Stopped(Stop),
}

impl From<Stop> for ProblemError {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

impl Problem {
    /// The problem of an instance.
    ///
    /// # Errors
    /// Where an agent alone decides it, or the budget is spent.
    pub fn new(instance: &Instance, budget: &dyn Budget) -> Result<Self, ProblemError> {
        Self::relaxed(instance, Relaxed::default(), budget)
    }

    /// The same with some rules between agents left out.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn relaxed(
        instance: &Instance,
        relaxed: Relaxed,
        budget: &dyn Budget,
    ) -> Result<Self, ProblemError> {
        Self::bounded(instance, relaxed, Vec::new(), budget)
    }

    /// The same with bounds on where the agents may go, in their order; without a bound
    /// an agent may go anywhere.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn bounded(
        instance: &Instance,
        relaxed: Relaxed,
        bounds: Vec<Bounds>,
        budget: &dyn Budget,
    ) -> Result<Self, ProblemError> {
        let mut bounds = bounds.into_iter();
        let mut problem = Self {
            terrain: Terrain::new(instance.grid()),
            stays: instance.stays(),
            relaxed,
            tasks: Vec::new(),
            cost_to_go: Vec::new(),
            optima: Vec::new(),
            is_constrained: instance.is_constrained() || instance.has_moving_obstacles(),
            between: Between::default(),
            precedences: Vec::new(),
            longest: 0,
        };
        let rules = OwnRules::new(instance, &problem.terrain);
        problem.between = rules.between();
        problem.precedences = rules.precedences(&problem.terrain);
        for (i, agent) in instance.agents().iter().enumerate() {
            let bounds = bounds.next().unwrap_or_default();
            let is_along = matches!(bounds, Bounds::Along(_));
            if agent.waypoints.len() > MAX_WAYPOINTS && !is_along {
                return Err(ProblemError::TooManyWaypoints(i));
            }
            let state = instance.start_state(&agent.name);
            let mut task =
                Task::resumed(agent, state, bounds, instance.rules(), &mut problem.terrain)
                    .map_err(|no_plan| ProblemError::Alone(i, no_plan))?;
            rules
                .impose(i, &mut task, &problem.terrain)
                .map_err(|no_plan| ProblemError::Alone(i, no_plan))?;
            problem.add(i, task, budget)?;
        }
        problem.longest = problem.longest().saturating_add(rules.last_time());
        Ok(problem)
    }

    /// An agent's least part of the sum of costs, alone.
    pub fn least_cost(&self, agent: usize) -> u32 {
        match self.optima[agent] {
            0 => 0,
            optimum => optimum.saturating_add(self.tasks[agent].cost_if_it_leaves_goal),
        }
    }

    /// The latest arrival of an agent at which its part of the sum of costs is
    /// no more than this.
    pub fn time_of(&self, agent: usize, cost: u32) -> u32 {
        cost.saturating_sub(self.tasks[agent].cost_if_it_leaves_goal)
    }

    /// Adds an agent, or gives it another task.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn add(
        &mut self,
        agent: usize,
        task: Task,
        budget: &dyn Budget,
    ) -> Result<(), ProblemError> {
        if task.bits() > MAX_WAYPOINTS || !task.conditions.fits_into_masks() {
            return Err(ProblemError::TooManyWaypoints(agent));
        }
        let cost_to_go = CostToGo::new(&task, &self.terrain, Metric::Time, budget)?;
        let optimum = earliest(&task, &self.terrain, &cost_to_go, budget)?;
        let optimum = optimum.map_err(|no_plan| ProblemError::Alone(agent, no_plan))?;
        if agent < self.tasks.len() {
            self.tasks[agent] = task;
            self.cost_to_go[agent] = cost_to_go;
            self.optima[agent] = optimum;
        } else {
            self.tasks.push(task);
            self.cost_to_go.push(cost_to_go);
            self.optima.push(optimum);
        }
        Ok(())
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.tasks.len()
    }

    /// Whether an agent stays where it arrives and blocks that vertex; one without a
    /// goal does so also where the others vanish.
    pub fn rests(&self, agent: usize) -> bool {
        let keeps = self.stays || self.tasks[agent].goal.is_none();
        keeps && !self.relaxed.gone.contains(&agent)
    }

    /// Whether two agents must not collide.
    pub fn collide(&self, a: usize, b: usize) -> bool {
        a != b && !self.relaxed.ignores(a, b)
    }

    /// The latest arrival of an agent that its conditions allow.
    pub fn not_after(&self, agent: usize) -> u32 {
        self.tasks[agent].not_after()
    }

    /// The largest number of which each weight of a penalty is a multiple; 1 where there is
    /// none.
    pub fn penalty_unit(&self) -> u32 {
        let weights = self.tasks.iter().flat_map(Task::weights);
        weights.fold(0, greatest_common_divisor).max(1)
    }

    /// Whether there are rules between agents beside that they must not collide.
    pub fn has_rules_between(&self) -> bool {
        !self.between.is_empty() || !self.precedences.is_empty()
    }

    /// Whether such a rule binds an agent.
    pub fn has_rules_between_with(&self, agent: usize) -> bool {
        let orders = &mut self.precedences.iter();
        self.between.rules.iter().any(|rule| rule.binds(agent))
            || orders.any(|order| order.first.0 == agent || order.second.0 == agent)
    }
}

const fn greatest_common_divisor(mut a: u32, mut b: u32) -> u32 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
