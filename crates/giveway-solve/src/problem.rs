//! An instance as the search sees it: a graph, tasks, exact distances.

use std::collections::BTreeSet;

use giveway_model::{Grid, Instance};

use crate::{
    meter::{Meter, Stop},
    single::{MAX_WAYPOINTS, Metric, Task, ToGo},
    terrain::Terrain,
};

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
    pub(crate) to_go: Vec<ToGo>,
    /// The earliest arrival of each agent alone.
    pub(crate) optima: Vec<u32>,
}

/// Why an instance has no [`Problem`].
pub(crate) enum Setback {
    /// This agent cannot do its task even alone.
    Alone(usize),
    /// This agent has more waypoints than the exact tables can bear.
    TooManyWaypoints(usize),
    /// The budget was spent.
    Stopped(Stop),
}

impl From<Stop> for Setback {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

impl Problem {
    pub(crate) fn new(instance: &Instance, meter: &Meter) -> Result<Self, Setback> {
        Self::relaxed(instance, Relaxed::default(), meter)
    }

    /// The same with some rules between agents left out.
    pub(crate) fn relaxed(
        instance: &Instance,
        relaxed: Relaxed,
        meter: &Meter,
    ) -> Result<Self, Setback> {
        let terrain = Terrain::new(instance.grid());
        let mut problem = Self {
            terrain,
            stays: instance.stays(),
            relaxed,
            tasks: Vec::new(),
            to_go: Vec::new(),
            optima: Vec::new(),
        };
        for (i, agent) in instance.agents().iter().enumerate() {
            if agent.waypoints.len() > MAX_WAYPOINTS {
                return Err(Setback::TooManyWaypoints(i));
            }
            let task =
                Task::new(agent, instance.rules(), &problem.terrain).ok_or(Setback::Alone(i))?;
            let to_go = ToGo::new(&task, &problem.terrain, Metric::Time, meter)?;
            let optimum = to_go
                .from(task.start, task.first_mask(), task.first_level())
                .ok_or(Setback::Alone(i))?;
            problem.tasks.push(task);
            problem.to_go.push(to_go);
            problem.optima.push(optimum);
        }
        Ok(problem)
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

    /// The makespan beyond which nothing is looked for, by default.
    pub(crate) fn default_horizon(&self, grid: &Grid) -> u32 {
        let longest = self.optima.iter().copied().max().unwrap_or(0);
        longest + 4 * (grid.width() + grid.height()) + 10
    }
}
