//! Where a plan has one agent, over the whole of its time.

use super::{History, TimedWaypoint, Timeline};
use crate::{Cell, Path, Plan};

/// Where an agent is at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whereabouts {
    /// Not there: not yet, no longer, or nowhere in the plan.
    Absent,
    /// At a cell.
    At(Cell),
    /// Half way along a slow move.
    Transit {
        /// The cell that it left.
        from: Cell,
        /// The cell that it enters one step later, its head.
        to: Cell,
    },
}

/// One agent in a plan, in absolute times. The path may break any rule.
#[derive(Clone, Copy, Debug)]
pub struct Trajectory<'a> {
    /// The agent over time.
    pub timeline: &'a Timeline,
    /// Where it is from [`Timeline::from`] on, up to its arrival or removal.
    pub path: &'a [Option<Cell>],
    /// The times at which the plan says that it charges, as listed.
    pub charges: &'a [u32],
    /// The spans of time that the plan has it rest through, before a change woke it.
    slept: &'a [[u32; 2]],
    /// Whether agents with a goal stay at it.
    stays: bool,
    end: u32,
}

impl<'a> Trajectory<'a> {
    /// The trajectory of an agent; `None` where the plan gives it no cell at all.
    pub fn of(history: &'a History, timeline: &'a Timeline, plan: &'a Plan) -> Option<Self> {
        let mut path = plan.path(timeline.name());
        let charges = plan.charges(timeline.name());
        let mut trajectory = Self {
            timeline,
            path,
            charges,
            slept: plan.slept(timeline.name()),
            stays: history.stays(),
            end: 0,
        };
        if let Some(until) = timeline.until {
            let length = until.saturating_sub(timeline.from) as usize;
            trajectory.path = path.get(..length).unwrap_or(path);
            trajectory.end = until.saturating_sub(1);
            return path.iter().any(Option::is_some).then_some(trajectory);
        }
        while let [rest @ .., None] = path {
            path = rest;
        }
        trajectory.path = path;
        let last = path.len().checked_sub(1)?;
        let last = timeline.from.saturating_add(last as u32);
        trajectory.end = last;
        // An agent that vanishes at its goal and is still listed there has not
        // arrived. One that stays has, as soon as it stays for good.
        let past = plan.knows.map_or(0, |knows| knows.min(last));
        let past = if trajectory.keeps() { 0 } else { past };
        trajectory.end = trajectory.arrival_in_path().max(past);
        let length = (trajectory.end - timeline.from) as usize + 1;
        trajectory.path = path.get(..length).unwrap_or(path);
        Some(trajectory)
    }

    /// The last time at which it matters where it is: of an agent that was
    /// removed the time before that, of any other its arrival.
    pub const fn end(&self) -> u32 {
        self.end
    }

    /// Whether it remains where it arrives; one without a goal always does.
    fn keeps(&self) -> bool {
        self.stays || self.timeline.goal().is_none()
    }

    /// Whether it was removed: then it never arrives.
    pub const fn is_removed(&self) -> bool {
        self.timeline.until.is_some()
    }

    /// The cell at a time; `None` in transit and where it is not there.
    pub fn at(&self, time: u32) -> Option<Cell> {
        let index = time.checked_sub(self.timeline.from)? as usize;
        if let Some(entry) = self.path.get(index) {
            return *entry;
        }
        let there = match self.timeline.until {
            Some(until) => time < until,
            None => self.keeps() || time <= self.end,
        };
        self.path.last().copied().flatten().filter(|_| there)
    }

    /// The cells from a time on, and the times at which it charges, counted from then.
    pub fn rest(&self, from: u32) -> (Path, Vec<u32>) {
        let path = (from..=self.end.max(from)).map(|time| self.at(time));
        let charges = self
            .charges
            .iter()
            .filter_map(|time| time.checked_sub(from));
        (path.collect(), charges.collect())
    }

    /// Where it is at a time.
    pub fn place(&self, time: u32) -> Whereabouts {
        if let Some(cell) = self.at(time) {
            return Whereabouts::At(cell);
        }
        let before = time.checked_sub(1).and_then(|time| self.at(time));
        match (before, self.at(time.saturating_add(1))) {
            (Some(from), Some(to)) if self.is_listed(time) => Whereabouts::Transit { from, to },
            _ => Whereabouts::Absent,
        }
    }

    fn is_listed(&self, time: u32) -> bool {
        let index = time.checked_sub(self.timeline.from);
        index.is_some_and(|index| (index as usize) < self.path.len())
    }

    /// The times that it slept through, each from one up to, not including,
    /// another of these times, at which something changed: arrived, it used no
    /// battery and made no waits. That is so where the plan says it, as far as the
    /// agent rests there; where its path ended before; and of one that was removed
    /// at its goal.
    pub fn sleeps(&self, times: impl Iterator<Item = u32>) -> Vec<(u32, u32)> {
        let times: Vec<u32> = times.collect();
        let said = self.slept.iter().filter(|[_, to]| times.contains(to));
        let said = said.filter_map(|&[from, to]| Some((from.max(self.rests_since(to)?), to)));
        let listed = self.timeline.from.saturating_add(self.path.len() as u32);
        let removed = self.timeline.until;
        let unlisted = times.iter().copied();
        let unlisted = unlisted.filter(|&time| removed.is_none() && time >= listed);
        let ends = unlisted.chain(removed);
        let rests = ends.filter_map(|time| Some((self.rests_since(time)?, time)));
        said.chain(rests).filter(|(from, to)| from < to).collect()
    }

    /// Since when it stands at its goal with every waypoint visited and without
    /// charging, before what changes at a time; `None` where it does not.
    pub fn rests_since(&self, time: u32) -> Option<u32> {
        let (goal, goal_since) = self.timeline.goal_before(time);
        // An agent that is removed at that time is gone.
        let gone = self.timeline.until == Some(time);
        let last = time.checked_sub(u32::from(gone))?;
        let rest = self.at(last)?;
        if goal.is_some_and(|goal| goal != rest || !self.stays) {
            return None;
        }
        // Nothing happens after what the path lists.
        let listed = (self.path.len() as u32).saturating_sub(1) + self.timeline.from;
        let mut since = last.min(listed);
        while since > self.timeline.from
            && self.at(since - 1) == Some(rest)
            && !self.charges.contains(&(since - 1))
        {
            since -= 1;
        }
        since = since.max(goal_since.unwrap_or(0));
        let before = |waypoint: &&TimedWaypoint| {
            waypoint.since.is_none_or(|since| since < time)
                && waypoint.dropped.is_none_or(|dropped| dropped >= time)
        };
        for waypoint in self.timeline.waypoints.iter().filter(before) {
            since = since.max(self.visit(waypoint).filter(|&visit| visit <= time)?);
        }
        // A waypoint was part of its task until it was dropped.
        for waypoint in &self.timeline.waypoints {
            if let Some(dropped) = waypoint.dropped.filter(|&dropped| dropped < time)
                && self.visit(waypoint).is_none_or(|visit| visit > dropped)
            {
                since = since.max(dropped);
            }
        }
        Some(since)
    }

    /// When a waypoint is first visited, as the timeline asks for.
    pub fn visit(&self, waypoint: &TimedWaypoint) -> Option<u32> {
        let from = waypoint.since.unwrap_or(0).max(self.timeline.from);
        let mut times = from..=self.end.max(from);
        times.find(|&time| self.at(time) == Some(waypoint.cell))
    }

    /// The first time from which it stands where it ends, that cell being its
    /// goal and every waypoint visited.
    fn arrival_in_path(&self) -> u32 {
        let from = self.timeline.from;
        let last = self.path.last().copied().flatten();
        let goal = self.timeline.goal();
        let mut arrival = self.end;
        if last.is_some() && goal.is_none_or(|goal| last == Some(goal)) {
            while arrival > from && self.at(arrival - 1) == last {
                arrival -= 1;
            }
            let since = self.timeline.goals.last().map_or(from, |&(since, _)| since);
            arrival = arrival.max(since);
        }
        let visits = self.timeline.waypoints();
        let visits = visits.filter_map(|waypoint| {
            let wait = Self {
                end: self.end.max(waypoint.since.unwrap_or(0)),
                ..*self
            };
            wait.visit(waypoint)
        });
        let arrival = visits.fold(arrival, u32::max);
        // A waypoint was part of its task until it was dropped.
        let dropped = self.timeline.waypoints.iter().filter_map(|waypoint| {
            let dropped = waypoint.dropped?;
            let visit = self.visit(waypoint);
            visit.is_none_or(|visit| visit > dropped).then_some(dropped)
        });
        dropped.fold(arrival, u32::max)
    }
}
