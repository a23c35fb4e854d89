//! The timeline of an agent: its task, and the changes to it over time.

use crate::{Agent, Battery, Cell, Ground, Path, sorting};

/// A waypoint of an agent, for as long as it is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimedWaypoint {
    /// The waypoint.
    pub cell: Cell,
    /// From when on it must be visited; `None`: from the agent's beginning.
    pub since: Option<u32>,
    /// The time from which it need not be visited any more.
    pub dropped: Option<u32>,
}

/// Where an agent stands that broke down for good.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped {
    /// The cell, which is an obstacle for as long as it stands there.
    pub cell: Cell,
    /// What that cell was before.
    pub ground: Ground,
    /// The time from which it stands there no more, where it was taken away.
    pub until: Option<u32>,
}

/// An agent over time. Where several things are of one time, the last counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Timeline {
    /// The agent as it began; its goal and waypoints may have changed since.
    pub agent: Agent,
    /// The time at which it appeared.
    pub from: u32,
    /// The time from which it is gone, where it was removed, or broke down for good.
    pub until: Option<u32>,
    /// Where it stands since then, where it broke down for good.
    pub stopped: Option<Stopped>,
    /// Other goals than the agent's first, each with its time; ascending.
    pub goals: Vec<(u32, Cell)>,
    /// All waypoints that it ever had.
    pub waypoints: Vec<TimedWaypoint>,
    /// Levels that its battery was set to, by time; ascending.
    pub levels: Vec<(u32, u32)>,
    /// Times at which it may not begin a move: from the first up to, not
    /// including, the second.
    pub held: Vec<(u32, u32)>,
}

impl Timeline {
    pub(super) fn new(agent: Agent, from: u32) -> Self {
        let waypoint = |&cell: &Cell| TimedWaypoint {
            cell,
            since: None,
            dropped: None,
        };
        Self {
            from,
            until: None,
            stopped: None,
            goals: Vec::new(),
            waypoints: agent.waypoints.iter().map(waypoint).collect(),
            levels: Vec::new(),
            held: Vec::new(),
            agent,
        }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.agent.name
    }

    /// Where it stands now as an obstacle; `None` where it did not break down for good, or was
    /// taken away since.
    pub fn stands(&self) -> Option<Stopped> {
        self.stopped.filter(|stopped| stopped.until.is_none())
    }

    /// What a plan lists of it, where it broke down for good: up to the time from which it stands,
    /// as the plan has it there. One that rested is listed up to that time, too. `None` where it
    /// did not break down.
    pub fn stood(&self, path: &[Option<Cell>]) -> Option<Path> {
        let until = self.until.filter(|_| self.stopped.is_some())?;
        let index = until.saturating_sub(self.from) as usize;
        let in_transit = path.get(index).is_some_and(Option::is_none);
        let length = index + 1 + usize::from(in_transit);
        let last = path.last().copied().flatten();
        let mut listed: Path = path.iter().take(length).copied().collect();
        listed.resize(length, last);
        Some(listed)
    }

    /// Its goal now, after all changes; `None` where it may rest at any cell.
    pub fn goal(&self) -> Option<Cell> {
        let changed = self.goals.last();
        changed.map_or(self.agent.goal, |&(_, goal)| Some(goal))
    }

    /// The agent as it is after all changes, with each waypoint once, at its first start;
    /// its battery begins at a level, where one is given.
    pub fn agent_now(&self, level: Option<u32>) -> Agent {
        let waypoints = sorting::set(self.waypoints().map(|waypoint| waypoint.cell));
        Agent {
            goal: self.goal(),
            waypoints: waypoints.into_iter().collect(),
            battery: self.agent.battery.map(|battery| Battery {
                initial: level.unwrap_or(battery.initial),
                ..battery
            }),
            ..self.agent.clone()
        }
    }

    /// Its goal before the changes of a time, and since when that is its goal,
    /// where it was another before.
    pub(super) fn goal_before(&self, time: u32) -> (Option<Cell>, Option<u32>) {
        let earlier = self.goals.iter().rev().find(|(since, _)| *since < time);
        earlier.map_or((self.agent.goal, None), |&(since, goal)| {
            (Some(goal), Some(since))
        })
    }

    /// The waypoints that it has to visit, after all changes.
    pub fn waypoints(&self) -> impl Iterator<Item = &TimedWaypoint> {
        self.waypoints
            .iter()
            .filter(|waypoint| waypoint.dropped.is_none())
    }

    /// Whether a breakdown keeps it from beginning a move at a time.
    pub fn is_held(&self, time: u32) -> bool {
        let mut held = self.held.iter();
        held.any(|&(from, to)| from <= time && time < to)
    }
}
