//! The changes of one time, applied together to the world as a plan has it.

mod constraints;
mod ground;
mod leave;
mod look_over;

use std::collections::BTreeMap;

use super::{
    Change, Epoch, History, MAX_DELAY, MAX_TIME, TimedWaypoint, Timeline, Trajectory, What,
    Whereabouts, refuse,
};
use crate::{Agent, Battery, Cell, Fault, Grid, MAX_AGENTS, MAX_CAPACITY, Plan};

pub(super) use look_over::Taken;

impl History {
    /// Applies the changes of one time, each with its place in the list of
    /// changes. Nothing may have changed at that time or later yet.
    ///
    /// # Errors
    /// Where they contradict the world: every contradiction, and nothing has
    /// changed.
    pub fn apply(
        &mut self,
        at: u32,
        changes: &[(usize, &Change)],
        plan: &Plan,
    ) -> Result<(), Vec<Fault>> {
        let mut world = World {
            at,
            before: self,
            after: self.clone(),
            grid: self.grid(at).clone(),
            trajectories: self.trajectories(plan, at),
            plan,
            faults: Vec::new(),
            obstacles: BTreeMap::new(),
            placed: Vec::new(),
            aimed: Vec::new(),
            ruled: Vec::new(),
        };
        for &(index, change) in changes {
            if at > MAX_TIME {
                world.refuse(index, refuse::too_late(at));
            } else {
                world.edit(index, &change.what);
            }
        }
        world.look_over();
        world.look_over_constraints();
        let World {
            mut after,
            faults,
            grid,
            ..
        } = world;
        if !faults.is_empty() {
            return Err(faults);
        }
        after.epochs.push(Epoch { from: at, grid });
        *self = after;
        Ok(())
    }
}

/// Found, and expected.
pub(super) type Reason = (String, String);

/// The world while changes are applied to it.
struct World<'a> {
    at: u32,
    before: &'a History,
    after: History,
    grid: Grid,
    /// The agents that are there before anything changes.
    trajectories: Vec<Trajectory<'a>>,
    /// The plan around which the world changes.
    plan: &'a Plan,
    faults: Vec<Fault>,
    /// New obstacles, with the changes that put them.
    obstacles: BTreeMap<Cell, usize>,
    /// New agents, with the changes that added them.
    placed: Vec<(usize, String, Cell)>,
    /// Cells that agents must go to, with the changes that said so.
    aimed: Vec<(usize, Cell)>,
    /// New rules by their numbers, with the changes that added them.
    ruled: Vec<(usize, usize)>,
}

impl World<'_> {
    fn refuse(&mut self, index: usize, (found, expected): Reason) {
        let place = format!("changes[{index}]");
        self.faults.push(Fault::at(place, found, expected));
    }

    fn edit(&mut self, index: usize, what: &What) {
        let done = match what {
            What::AddAgent { agent } => self.add(index, agent),
            What::RemoveAgent { agent } => self.remove(agent),
            What::AddObstacle { cell } => self.block(index, *cell),
            What::RemoveObstacle { cell } => self.unblock(*cell),
            What::MoveObstacle { from, to } => {
                self.unblock(*from).and_then(|()| self.block(index, *to))
            }
            What::SetSlow { cells } => self.pave(cells, |charger, _| (charger, true)),
            What::SetNormal { cells } => self.pave(cells, |charger, _| (charger, false)),
            What::AddCharger { cell } => self.charger(*cell, true),
            What::RemoveCharger { cell } => self.charger(*cell, false),
            What::SetGoal { agent, cell } => self.goal(index, agent, *cell),
            What::AddWaypoint { agent, cell } => self.waypoint(index, agent, *cell),
            What::DropWaypoint { agent, cell } => self.drop_waypoint(agent, *cell),
            What::SetBattery { agent, level } => self.level(agent, *level),
            What::DelayAgent { agent, steps } => self.delay(agent, *steps),
            What::StopAgent { agent } => self.stop(agent),
            What::AddConstraint { constraint } => self.add_constraint(index, constraint),
            What::RemoveConstraint { constraint } => self.remove_constraint(constraint),
        };
        if let Err(reason) = done {
            self.refuse(index, reason);
        }
    }

    /// An agent that is there: it has come, was not removed, has not vanished.
    fn timeline(&mut self, name: &str) -> Result<&mut Timeline, Reason> {
        let at = self.at;
        let is_gone = |timeline: &Timeline| {
            let trajectories = self.trajectories.iter();
            let old = self.before.timelines().iter().any(|c| c.name() == name);
            // A plan from which it is removed as it appears has no cell of it.
            let leaves_at_once = timeline.from == at && self.plan.until.get(name) == Some(&at);
            old && !leaves_at_once
                && !trajectories
                    .clone()
                    .any(|trajectory| trajectory.timeline.name() == timeline.name())
        };
        let mut timelines = self.after.timelines.iter();
        let Some(index) = timelines.position(|timeline| timeline.name() == name) else {
            return Err(refuse::unknown(name));
        };
        match self.after.timelines.get(index) {
            Some(timeline) if timeline.stands().is_some() => Err(refuse::stopped(name)),
            Some(timeline) if timeline.until.is_some() => Err(refuse::removed(name)),
            Some(timeline) if is_gone(timeline) => Err(refuse::vanished(name, at)),
            _ => {
                let timeline = self.after.timelines.get_mut(index);
                timeline.ok_or_else(|| refuse::unknown(name))
            }
        }
    }

    fn add(&mut self, index: usize, agent: &Agent) -> Result<(), Reason> {
        if agent.name.is_empty() {
            return Err(refuse::no_name());
        }
        if self.after.timelines.iter().any(|c| c.name() == agent.name) {
            return Err(refuse::used_name(&agent.name));
        }
        if self.after.timelines.len() >= MAX_AGENTS {
            return Err(refuse::too_many());
        }
        for (k, cell) in agent.waypoints.iter().enumerate() {
            if agent.waypoints.iter().take(k).any(|other| other == cell) {
                return Err(refuse::twice(*cell));
            }
        }
        if let Some(Battery { capacity, initial }) = agent.battery
            && (capacity > MAX_CAPACITY || initial > capacity)
        {
            return Err(refuse::capacity(capacity, initial));
        }
        let ends = [Some(agent.start), agent.goal];
        for &cell in ends.iter().flatten().chain(&agent.waypoints) {
            self.ground(cell)?;
            self.aimed.push((index, cell));
        }
        let timeline = Timeline::new(agent.clone(), self.at);
        self.after.timelines.push(timeline);
        self.placed.push((index, agent.name.clone(), agent.start));
        Ok(())
    }

    fn goal(&mut self, index: usize, name: &str, cell: Cell) -> Result<(), Reason> {
        let at = self.at;
        self.ground(cell)?;
        let timeline = self.timeline(name)?;
        if timeline.goal() != Some(cell) {
            timeline.goals.push((at, cell));
        }
        self.aimed.push((index, cell));
        Ok(())
    }

    fn waypoint(&mut self, index: usize, name: &str, cell: Cell) -> Result<(), Reason> {
        let at = self.at;
        self.ground(cell)?;
        let trajectory = self
            .trajectories
            .iter()
            .find(|trajectory| trajectory.timeline.name() == name);
        let trajectory = trajectory.copied();
        // Of one that is removed now, the plan does not tell what it visits now.
        let leaves = self.plan.until.get(name) == Some(&at);
        let timeline = self.timeline(name)?;
        let pending = timeline.waypoints().any(|waypoint| {
            let visit = trajectory.and_then(|trajectory| trajectory.visit(waypoint));
            waypoint.cell == cell && visit.is_none_or(|visit| visit > at)
        });
        if pending && !leaves {
            return Err(refuse::waypoint_again(name, cell));
        }
        timeline.waypoints.push(TimedWaypoint {
            cell,
            since: Some(at),
            dropped: None,
        });
        self.aimed.push((index, cell));
        Ok(())
    }

    fn drop_waypoint(&mut self, name: &str, cell: Cell) -> Result<(), Reason> {
        let at = self.at;
        let timeline = self.timeline(name)?;
        let mut waypoints = timeline.waypoints.iter_mut().rev();
        let found = waypoints.find(|waypoint| waypoint.cell == cell && waypoint.dropped.is_none());
        let waypoint = found.ok_or_else(|| refuse::no_waypoint(name, cell))?;
        waypoint.dropped = Some(at);
        Ok(())
    }

    fn level(&mut self, name: &str, level: u32) -> Result<(), Reason> {
        let at = self.at;
        let timeline = self.timeline(name)?;
        let Some(battery) = timeline.agent.battery else {
            return Err(refuse::unlimited(name));
        };
        if level > battery.capacity {
            return Err(refuse::level(name, level, battery.capacity));
        }
        timeline.levels.push((at, level));
        Ok(())
    }

    fn delay(&mut self, name: &str, steps: u32) -> Result<(), Reason> {
        let at = self.at;
        if steps > MAX_DELAY {
            return Err(refuse::too_long(steps));
        }
        let trajectory = self
            .trajectories
            .iter()
            .find(|trajectory| trajectory.timeline.name() == name);
        let place = trajectory.map(|trajectory| trajectory.place(at));
        let timeline = self.timeline(name)?;
        let from = match place {
            Some(Whereabouts::Transit { .. }) => at + 1,
            _ => at,
        };
        timeline.held.push((from, from + steps));
        Ok(())
    }
}
