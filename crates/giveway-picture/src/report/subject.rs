//! A plan with the world in which it runs.

use giveway_model::change::{Changes, History, Trajectory};
use giveway_model::{Agent, Cell, Costs, Fault, Grid, Instance, Plan, Units, check};

/// A plan with the world in which it runs, which may change meanwhile.
#[derive(Clone, Debug)]
pub struct Subject<'a> {
    pub(super) instance: &'a Instance,
    pub(super) plan: &'a Plan,
    pub(super) changes: Option<&'a Changes>,
    pub(super) robots: Vec<Robot>,
    pub(super) costs: Option<Costs>,
}

/// A robot of the plan.
#[derive(Clone, Debug)]
pub(super) struct Robot {
    /// With the goal and the waypoints that it has in the end.
    pub(super) agent: Agent,
    pub(super) arrives: Option<u32>,
    pub(super) removed: Option<u32>,
    /// The level of its battery at each time from its beginning; empty without one.
    pub(super) levels: Vec<i64>,
    /// When it breaks down, from and until.
    pub(super) held: Vec<(u32, u32)>,
}

impl<'a> Subject<'a> {
    /// A plan around which nothing changes, or the given changes happen.
    ///
    /// # Errors
    /// The faults of changes that contradict the world as the plan has it.
    pub fn new(
        instance: &'a Instance,
        plan: &'a Plan,
        changes: Option<&'a Changes>,
    ) -> Result<Self, Vec<Fault>> {
        let (robots, costs) = match changes {
            None => (alone(instance, plan), check::costs(instance, plan)),
            Some(changes) => {
                let history = History::of(instance, changes, plan)?;
                let costs = check::costs_over_time(&history, plan);
                (over_time(&history, plan), costs)
            }
        };
        Ok(Self {
            instance,
            plan,
            changes,
            robots,
            costs,
        })
    }

    /// What cells and steps are in the world.
    pub(super) fn units(&self) -> Option<Units> {
        self.instance.to_scene().units
    }

    /// The map as it is at first.
    pub(super) const fn grid(&self) -> &Grid {
        self.instance.grid()
    }

    /// The cells of a robot by time, without those in transit.
    pub(super) fn stops(&self, robot: &Robot) -> impl Iterator<Item = (u32, Cell)> {
        let name = robot.agent.name.as_str();
        let cells = self.plan.path(name).iter();
        let cells = cells.zip(self.begins(robot)..);
        cells.filter_map(|(cell, time)| cell.map(|cell| (time, cell)))
    }

    /// When a robot begins.
    pub(super) fn begins(&self, robot: &Robot) -> u32 {
        let from = self.plan.from.get(&robot.agent.name);
        from.copied().unwrap_or(0)
    }

    /// Its stops up to its arrival, or to its end.
    pub(super) fn way(&self, robot: &Robot) -> Vec<(u32, Cell)> {
        let end = robot.arrives.or(robot.removed).unwrap_or(u32::MAX);
        self.stops(robot).take_while(|&(at, _)| at <= end).collect()
    }
}

fn alone(instance: &Instance, plan: &Plan) -> Vec<Robot> {
    let arrivals = check::arrivals(instance, plan);
    let robot = |(index, agent): (usize, &Agent)| Robot {
        agent: agent.clone(),
        arrives: arrivals.get(index).copied().flatten(),
        removed: None,
        levels: match agent.battery {
            Some(_) => check::levels(instance, index, plan),
            None => Vec::new(),
        },
        held: Vec::new(),
    };
    instance.agents().iter().enumerate().map(robot).collect()
}

fn over_time(history: &History, plan: &Plan) -> Vec<Robot> {
    let timelines = history.timelines().iter();
    let robots = timelines.map(|timeline| {
        let trajectory = Trajectory::of(history, timeline, plan);
        let is_there = |trajectory: &&Trajectory<'_>| !trajectory.is_removed();
        let levels = |own: &Trajectory<'_>| check::levels_over_time(history, own);
        let levels = trajectory.as_ref().map_or_else(Vec::new, levels);
        let has_battery = timeline.agent.battery.is_some();
        Robot {
            agent: Agent {
                goal: timeline.goal(),
                waypoints: timeline.waypoints().map(|waypoint| waypoint.cell).collect(),
                ..timeline.agent.clone()
            },
            arrives: trajectory.as_ref().filter(is_there).map(Trajectory::end),
            removed: timeline.until,
            levels: if has_battery { levels } else { Vec::new() },
            held: timeline.held.clone(),
        }
    });
    robots.collect()
}
