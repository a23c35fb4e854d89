//! An instance as the search sees it: a graph, tasks, exact distances.

use std::collections::BTreeSet;

use giveway_model::{Costs, Grid, Instance};

use crate::{
    budget::{Budget, Stop},
    counterfactual::{Counterfactual, Precedence},
    search::ForEver,
    single::{CostToGo, MAX_WAYPOINTS, Metric, Task, TaskConstraint, earliest},
    terrain::Terrain,
    walk::{Walk, costs_of},
};
use giveway_model::sorting::set;

/// Rules between agents that do not count, by the agents' numbers: what an
/// explanation leaves out to see whether a plan exists without it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Relaxed {
    /// Pairs that ignore each other, the lower number first.
    pub(crate) ignored: BTreeSet<(usize, usize)>,
    /// Agents that are gone on arrival, where the others stay.
    pub(crate) gone: BTreeSet<usize>,
}

impl Relaxed {
    /// Whether two agents ignore each other.
    pub(crate) fn ignores(&self, a: usize, b: usize) -> bool {
        self.ignored.contains(&(a.min(b), a.max(b)))
    }
}

/// Everything that is known of an instance before agents meet.
pub(crate) struct Problem {
    pub(crate) terrain: Terrain,
    /// Whether arrived agents stay at their goals, but for those that the
    /// relaxation lets go.
    pub(crate) stays: bool,
    pub(crate) relaxed: Relaxed,
    pub(crate) tasks: Vec<Task>,
    /// The time that each agent alone still needs, from anywhere.
    pub(crate) cost_to_go: Vec<CostToGo>,
    /// The earliest arrival of each agent alone.
    pub(crate) optima: Vec<u32>,
    /// The largest of these, where nothing is demanded beside the tasks.
    longest: u32,
    /// Who must be at a vertex before whom, where a question asks for it.
    pub(crate) precedence: Option<Precedence>,
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
        let terrain = Terrain::new(instance.grid());
        let mut problem = Self {
            terrain,
            stays: instance.stays(),
            relaxed,
            tasks: Vec::new(),
            cost_to_go: Vec::new(),
            optima: Vec::new(),
            longest: 0,
            precedence: None,
        };
        for (i, agent) in instance.agents().iter().enumerate() {
            if agent.waypoints.len() > MAX_WAYPOINTS {
                return Err(ProblemError::TooManyWaypoints(i));
            }
            let task = Task::new(agent, instance.rules(), &problem.terrain)
                .map_err(|hopeless| ProblemError::Alone(i, hopeless.into()))?;
            problem.add(i, task, budget)?;
        }
        problem.longest = problem.optima.iter().copied().max().unwrap_or(0);
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
        let mut problem = Self {
            terrain,
            stays,
            relaxed: Relaxed::default(),
            tasks: Vec::new(),
            cost_to_go: Vec::new(),
            optima: Vec::new(),
            longest: 0,
            precedence: None,
        };
        for (i, task) in tasks.into_iter().enumerate() {
            problem.add(i, task, budget)?;
        }
        problem.longest = problem.optima.iter().copied().max().unwrap_or(0);
        Ok(problem)
    }

    /// An agent's least part of the sum of costs, alone.
    pub(crate) fn least_cost(&self, agent: usize) -> u32 {
        match self.optima[agent] {
            0 => 0,
            optimum => optimum.saturating_add(self.tasks[agent].woken),
        }
    }

    /// The latest arrival of an agent at which its part of the sum of costs is
    /// no more than this.
    pub(crate) fn time_of(&self, agent: usize, cost: u32) -> u32 {
        cost.saturating_sub(self.tasks[agent].woken)
    }

    /// Adds an agent, or gives it another task.
    pub(crate) fn add(
        &mut self,
        agent: usize,
        task: Task,
        budget: &Budget,
    ) -> Result<(), ProblemError> {
        if task.waypoints.len() >= MAX_WAYPOINTS + usize::from(task.demand.is_none()) {
            return Err(ProblemError::TooManyWaypoints(agent));
        }
        let cost_to_go = CostToGo::new(&task, &self.terrain, Metric::Time, budget)?;
        let optimum = earliest(&task, &self.terrain, &cost_to_go, budget)?;
        let optimum = optimum.map_err(|hopeless| ProblemError::Alone(agent, hopeless.into()))?;
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
    pub(crate) fn agents(&self) -> usize {
        self.tasks.len()
    }

    /// Whether an agent stays at its goal and blocks it.
    pub(crate) fn rests(&self, agent: usize) -> bool {
        self.stays && !self.relaxed.gone.contains(&agent)
    }

    /// Whether two agents must not collide.
    pub(crate) fn collide(&self, a: usize, b: usize) -> bool {
        a != b && !self.relaxed.ignores(a, b)
    }

    /// The latest arrival of an agent that its demand allows.
    pub(crate) fn not_after(&self, agent: usize) -> u32 {
        self.tasks[agent].not_after()
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

    /// The same for one agent, with so many charges.
    pub(crate) fn keeps_alone(&self, agent: usize, walk: &Walk, charges: u32) -> bool {
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
    pub(crate) fn joint_states(&self) -> Option<u32> {
        let slow = (0..self.terrain.len() as u32).flat_map(|v| self.terrain.arcs(v));
        let places = self.terrain.len() + slow.filter(|arc| arc.slow).count();
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
    pub(crate) fn default_horizon(&self, grid: &Grid) -> u32 {
        self.longest + 4 * (grid.width() + grid.height()) + 10
    }
}
