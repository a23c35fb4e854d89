//! An instance as planners see it: a graph, tasks, exact distances.

use std::collections::BTreeSet;

use giveway_model::{Costs, Grid, Instance};

use crate::{
    budget::{Budget, Stop},
    single::{CostToGo, Hopeless, MAX_WAYPOINTS, Metric, Task, TaskConstraint, earliest},
    terrain::Terrain,
    walk::{Walk, costs_of},
};

/// Rules between agents that do not count, by the agents' numbers: what an
/// explanation leaves out to see whether a plan exists without it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Relaxed {
    /// Pairs that ignore each other, the lower number first.
    pub ignored: BTreeSet<(usize, usize)>,
    /// Agents that are gone on arrival, where the others stay.
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
    /// relaxation lets go.
    pub stays: bool,
    /// Rules between agents that do not count.
    pub relaxed: Relaxed,
    /// What each agent has to do.
    pub tasks: Vec<Task>,
    /// The time that each agent alone still needs, from anywhere.
    pub cost_to_go: Vec<CostToGo>,
    /// The earliest arrival of each agent alone.
    pub optima: Vec<u32>,
    /// The largest of these and of the ends of breakdowns, where nothing is
    /// demanded beside the tasks.
    longest: u32,
}

/// Why an instance has no [`Problem`].
pub enum ProblemError {
    /// This agent cannot do its task, or what a question asks of it, even alone.
    Alone(usize, Hopeless),
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
        let mut problem = Self {
            terrain: Terrain::new(instance.grid()),
            stays: instance.stays(),
            relaxed,
            tasks: Vec::new(),
            cost_to_go: Vec::new(),
            optima: Vec::new(),
            longest: 0,
        };
        for (i, agent) in instance.agents().iter().enumerate() {
            if agent.waypoints.len() > MAX_WAYPOINTS {
                return Err(ProblemError::TooManyWaypoints(i));
            }
            let mut task = Task::new(agent, instance.rules(), &problem.terrain)
                .map_err(|hopeless| ProblemError::Alone(i, hopeless))?;
            task.held = instance.held(&agent.name);
            problem.add(i, task, budget)?;
        }
        problem.longest = problem.longest();
        Ok(problem)
    }

    /// A problem of tasks over a terrain, none of them asked for more.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn of_tasks(
        terrain: Terrain,
        stays: bool,
        tasks: Vec<Task>,
        budget: &dyn Budget,
    ) -> Result<Self, ProblemError> {
        let mut problem = Self {
            terrain,
            stays,
            relaxed: Relaxed::default(),
            tasks: Vec::new(),
            cost_to_go: Vec::new(),
            optima: Vec::new(),
            longest: 0,
        };
        for (i, task) in tasks.into_iter().enumerate() {
            problem.add(i, task, budget)?;
        }
        problem.longest = problem.longest();
        Ok(problem)
    }

    /// The largest of the earliest arrivals and of the ends of breakdowns: others
    /// may have to wait for an agent that has arrived and broken down.
    fn longest(&self) -> u32 {
        let held = self.tasks.iter().map(|task| task.held);
        self.optima.iter().copied().chain(held).max().unwrap_or(0)
    }

    /// An agent's least part of the sum of costs, alone.
    pub fn least_cost(&self, agent: usize) -> u32 {
        match self.optima[agent] {
            0 => 0,
            optimum => optimum.saturating_add(self.tasks[agent].woken),
        }
    }

    /// The latest arrival of an agent at which its part of the sum of costs is
    /// no more than this.
    pub fn time_of(&self, agent: usize, cost: u32) -> u32 {
        cost.saturating_sub(self.tasks[agent].woken)
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
        if task.waypoints.len() >= MAX_WAYPOINTS + usize::from(task.demand.is_none()) {
            return Err(ProblemError::TooManyWaypoints(agent));
        }
        let cost_to_go = CostToGo::new(&task, &self.terrain, Metric::Time, budget)?;
        let optimum = earliest(&task, &self.terrain, &cost_to_go, budget)?;
        let optimum = optimum.map_err(|hopeless| ProblemError::Alone(agent, hopeless))?;
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

    /// Whether an agent stays at its goal and blocks it.
    pub fn rests(&self, agent: usize) -> bool {
        self.stays && !self.relaxed.gone.contains(&agent)
    }

    /// Whether two agents must not collide.
    pub fn collide(&self, a: usize, b: usize) -> bool {
        a != b && !self.relaxed.ignores(a, b)
    }

    /// The latest arrival of an agent that its demand allows.
    pub fn not_after(&self, agent: usize) -> u32 {
        self.tasks[agent].not_after()
    }

    /// Whether a walk of an agent, with so many charges, keeps to what is asked for
    /// beside its task, as far as walks made outside the SAT solver may fail to.
    pub fn keeps_alone(&self, agent: usize, walk: &Walk, charges: u32) -> bool {
        let own = || Costs {
            charges,
            ..costs_of(self, agent, walk)
        };
        match &self.tasks[agent].demand {
            Some(TaskConstraint::AtMost { cost, most }) => own().get(*cost) <= *most,
            Some(TaskConstraint::ArriveBy(time)) => own().makespan <= *time,
            Some(demand) => demand.keeps_waits(walk),
            None => true,
        }
    }

    /// A number of steps that no plan needs to exceed: one with more comes to
    /// the same joint state twice, and what lies between can be left out, which
    /// makes no cost higher. `None` where the number is too large to be of use.
    pub fn joint_states(&self) -> Option<u32> {
        let slow = (0..self.terrain.size() as u32).flat_map(|v| self.terrain.arcs(v));
        let places = self.terrain.size() + slow.filter(|arc| arc.slow).count();
        let mut states: u32 = 1;
        let mut timed = 0;
        for task in &self.tasks {
            // On the way; and at the end, one step or more.
            let way = [places + 1, task.masks(), task.levels(), task.counted()]
                .iter()
                .try_fold(1u32, |product, &factor| {
                    product.checked_mul(u32::try_from(factor).ok()?)
                })?;
            states = states.checked_mul(way.checked_add(2)?)?;
            timed = timed
                .max(task.not_before)
                .max(task.last_time().unwrap_or(0));
        }
        // What is demanded of times is not the same at each of them.
        states.checked_add(timed)?.checked_add(2)
    }

    /// The makespan beyond which nothing is looked for, by default.
    pub fn default_horizon(&self, grid: &Grid) -> u32 {
        self.longest + 4 * (grid.width() + grid.height()) + 10
    }
}
