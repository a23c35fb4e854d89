//! The agents that go on from a time on, as an instance has them.

use giveway_model::tr;
use giveway_model::{
    Agent, Battery, Cell, Costs, Plan,
    change::{History, Timeline, Trajectory, Whereabouts},
    check::{costs_until, level_over_time},
    sorting,
};

use super::{past::Share, rest::refused};
use crate::Refusal;

/// An agent that goes on.
pub(super) struct Member<'a> {
    /// As it is now.
    pub(super) agent: Agent,
    pub(super) share: Share,
    /// Its trajectory; `None` of one that appears just now in a plan that lacks it.
    pub(super) trajectory: Option<Trajectory<'a>>,
}

/// A course at the time from which its rest begins.
pub(super) struct Resting<'a> {
    pub(super) history: &'a History,
    pub(super) changed: u32,
    pub(super) since: u32,
    pub(super) plan: &'a Plan,
}

impl<'a> Resting<'a> {
    pub(super) fn members(&self) -> Result<Vec<Member<'a>>, Refusal> {
        let trajectories = self.history.trajectories(self.plan, self.since);
        let timelines = self.history.timelines().iter();
        let there =
            timelines.filter(|timeline| timeline.until.is_none() && timeline.from <= self.since);
        let mut members = Vec::new();
        for timeline in there {
            let trajectory = trajectories
                .iter()
                .find(|trajectory| trajectory.timeline.name() == timeline.name());
            match trajectory {
                Some(trajectory) => members.extend(self.member(timeline, *trajectory)?),
                None if timeline.from == self.changed
                    && self.plan.path(timeline.name()).is_empty() =>
                {
                    members.push(self.newcomer(timeline));
                }
                None => {}
            }
        }
        Ok(members)
    }

    /// An agent that appears just now, and of which the plan knows nothing.
    fn newcomer(&self, timeline: &Timeline) -> Member<'a> {
        let set = timeline.levels.last().map(|&(_, level)| level);
        Member {
            agent: self.history.agent_now(timeline, set),
            share: Share {
                base: self.since,
                idle: 0,
                spent: Costs::default(),
            },
            trajectory: None,
        }
    }

    fn member(
        &self,
        timeline: &Timeline,
        trajectory: Trajectory<'a>,
    ) -> Result<Option<Member<'a>>, Refusal> {
        let since = self.since;
        let Whereabouts::At(here) = trajectory.place(since) else {
            return Ok(None);
        };
        let mut waypoints: Vec<Cell> = timeline
            .waypoints()
            .filter(|waypoint| trajectory.visit(waypoint).is_none_or(|visit| visit > since))
            .map(|waypoint| waypoint.cell)
            .collect();
        sorting::sort(&mut waypoints);
        waypoints.dedup();
        let done = here == timeline.goal() && waypoints.iter().all(|&cell| cell == here);
        let base = if done {
            self.arrival(timeline, &trajectory)
        } else {
            since
        };
        // Up to the last change it slept; from then on it would have waited.
        let idle = since - base.max(self.changed).min(since);
        let mut agent = self.history.agent_now(timeline, None);
        agent.start = here;
        agent.waypoints = waypoints;
        if let Some(battery) = timeline.agent.battery {
            let level = level_over_time(self.history, &trajectory, since).unwrap_or(0)
                - i64::from(idle_beyond(&trajectory, since, idle));
            let floor = i64::from(self.history.rules().battery_floor);
            let level = u32::try_from(level)
                .ok()
                .filter(|_| !done || level >= floor);
            let Some(initial) = level else {
                return Err(refused(tr!(
                    "The battery of {name} is empty at time {since}. Questions about the time after \
                     that cannot be answered.",
                    name = timeline.name(),
                    since
                )));
            };
            agent.battery = Some(Battery { initial, ..battery });
        }
        let spent = costs_until(self.history, &trajectory, since - idle);
        Ok(Some(Member {
            agent,
            share: Share { base, idle, spent },
            trajectory: Some(trajectory),
        }))
    }

    /// When an agent has arrived that stays from now on. One that was under way
    /// at the last change, and happened to stand at its goal, arrives no sooner
    /// than that.
    fn arrival(&self, timeline: &Timeline, trajectory: &Trajectory<'_>) -> u32 {
        let times = self.history.times();
        let slept =
            trajectory.sleeps(times.filter(|&time| timeline.from < time && time <= self.changed));
        let at_change = slept.iter().filter(|&&(_, to)| to == self.changed);
        let asleep = at_change.map(|&(from, _)| from).min();
        let mut plan = self.plan.clone();
        if let Some(path) = plan.paths.get_mut(timeline.name()) {
            let last = asleep.unwrap_or(self.since);
            path.truncate((last - timeline.from.min(last)) as usize + 1);
        }
        plan.knows = Some(self.changed);
        let trajectory = Trajectory::of(self.history, timeline, &plan);
        trajectory.map_or(self.since, |trajectory| trajectory.end().min(self.since))
    }
}

/// Idle steps that the levels of the plan asked about do not count, since in it
/// the agent has arrived for good.
fn idle_beyond(trajectory: &Trajectory<'_>, since: u32, idle: u32) -> u32 {
    if trajectory.end() < since { idle } else { 0 }
}
