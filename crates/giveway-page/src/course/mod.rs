//! The course of a plan around which the world changed: what changed when, what
//! was adopted then, and the world of each time.

use std::rc::Rc;

use giveway_model::change::{Changes, History, Timeline};
use giveway_model::{Agent, Costs, Fault, Instance, Plan, Scene};
use giveway_solve::change::Method;

use crate::Draft;

/// How the world changed while a plan ran, and how the plan went on.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// All that changed.
    pub changes: Changes,
    /// How the plan went on after each time, ascending.
    pub steps: Vec<Adopted>,
    /// The world over time, the first from time 0.
    pub worlds: Vec<World>,
    pub(crate) history: History,
}

/// How a plan went on after the changes of a time. What is not known is `None`:
/// a link tells it of this browser's own plans only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Adopted {
    /// The time.
    pub at: u32,
    /// The method.
    pub method: Option<Method>,
    /// The other methods that found the same plan.
    pub also: [Option<Method>; 2],
    /// The costs of the plan before.
    pub before: Option<Costs>,
    /// The costs of the plan from then on.
    pub after: Option<Costs>,
}

/// The world from a time on, as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// The first time at which it is so.
    pub from: u32,
    /// Its map, and all agents that there ever are, so that each has one index at
    /// all times; goals and waypoints are those of this time.
    pub draft: Rc<Draft>,
    /// Whether each agent is there: it has come, and was not removed.
    pub is_there: Vec<bool>,
}

impl Course {
    /// The course of a plan.
    ///
    /// # Errors
    /// The faults of the first changes that contradict the world as the plan has
    /// it.
    pub(crate) fn new(
        instance: &Instance,
        scene: &Scene,
        changes: Changes,
        steps: Vec<Adopted>,
        plan: &Plan,
    ) -> Result<Self, Vec<Fault>> {
        let history = History::of(instance, &changes, plan)?;
        let mut worlds = vec![World::of(&history, scene, 0)];
        let later = history.times().filter(|&time| time > 0);
        worlds.extend(later.map(|time| World::of(&history, scene, time)));
        Ok(Self {
            changes,
            steps,
            worlds,
            history,
        })
    }

    /// The world at a time.
    pub fn world(&self, time: u32) -> Option<&World> {
        let mut worlds = self.worlds.iter().rev();
        worlds
            .find(|world| world.from <= time)
            .or(self.worlds.first())
    }

    /// The times at which something changed, ascending.
    pub fn times(&self) -> Vec<u32> {
        self.history.times().collect()
    }
}

impl World {
    /// The world of a history from a time on.
    pub(crate) fn of(history: &History, scene: &Scene, from: u32) -> Self {
        let timelines = history.timelines();
        let grid = history.grid(from).clone();
        let agents = timelines.iter().map(|timeline| agent_at(timeline, from));
        let scene = Scene {
            map: grid.rows(),
            agents: agents.collect(),
            ..scene.clone()
        };
        let is_there = |timeline: &Timeline| {
            timeline.from <= from && timeline.until.is_none_or(|until| from < until)
        };
        Self {
            from,
            draft: Rc::new(Draft::shown(scene, grid)),
            is_there: timelines.iter().map(is_there).collect(),
        }
    }
}

/// An agent with the task that it has at a time.
fn agent_at(timeline: &Timeline, time: u32) -> Agent {
    let mut goals = timeline.goals.iter().rev();
    let goal = goals.find(|(since, _)| *since <= time);
    let waypoints = timeline.waypoints.iter().filter(|waypoint| {
        waypoint.since.is_none_or(|since| since <= time)
            && waypoint.dropped.is_none_or(|dropped| time < dropped)
    });
    Agent {
        goal: goal.map_or(timeline.agent.goal, |&(_, goal)| Some(goal)),
        waypoints: waypoints.map(|waypoint| waypoint.cell).collect(),
        ..timeline.agent.clone()
    }
}
