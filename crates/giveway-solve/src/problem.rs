//! An instance as the search sees it: a graph, tasks, exact distances.

use giveway_model::Instance;

use crate::{
    meter::{Meter, Stop},
    single::{MAX_WAYPOINTS, Metric, Task, ToGo},
    terrain::Terrain,
};

/// Everything that is known of an instance before agents meet.
pub(crate) struct Problem {
    pub(crate) terrain: Terrain,
    /// Whether arrived agents stay at their goals.
    pub(crate) stays: bool,
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
        let terrain = Terrain::new(instance.grid());
        let mut problem = Self {
            terrain,
            stays: instance.stays(),
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
}
