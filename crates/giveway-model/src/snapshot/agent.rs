//! One agent of a running plan at one time.

use crate::change::{History, TimedWaypoint, Timeline, Trajectory, Whereabouts};
use crate::check::{costs_until, level_over_time};
use crate::{Agent, Breakdown, Cell, Costs, Path, StartState, sorting};

/// The past of an agent before a time, and its steps in the running plan from then on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RunningAgent {
    /// Whether it was there before that time.
    pub is_old: bool,
    /// The rest of its path, from that time on; empty of an agent that the plan lacks.
    pub path: Path,
    /// The times at which it would charge, counted from that time.
    pub charges: Vec<u32>,
    /// How many wait steps on end it has just made.
    pub waits: u32,
    /// When it fell asleep at its goal, if it sleeps at that time and its path ended there.
    pub(super) asleep_since: Option<u32>,
    /// Its charges, moves and waits so far; those while it rested at its goal apart.
    pub(super) spent: Costs,
}

impl RunningAgent {
    /// The cells of the rest of its path, waits taken out.
    pub fn cells(&self) -> Vec<Cell> {
        let mut cells: Vec<Cell> = self.path.iter().copied().flatten().collect();
        cells.dedup();
        cells
    }

    /// An agent that appears at a time, with its trajectory where the plan has one already.
    pub(super) fn new(
        timeline: &Timeline,
        trajectory: Option<Trajectory<'_>>,
        at: u32,
    ) -> (Agent, StartState, Self) {
        let agent = timeline.agent_now(level_set(timeline, at));
        let state = StartState {
            breakdowns: breakdowns(timeline, at),
            ..StartState::default()
        };
        let (path, charges) = trajectory.map(|it| it.rest(at)).unwrap_or_default();
        let running = Self {
            path,
            charges,
            ..Self::default()
        };
        (agent, state, running)
    }

    /// An agent that was there before; `None` of one that is not there any more.
    pub(super) fn old(
        timeline: &Timeline,
        trajectory: &Trajectory<'_>,
        past: &History,
        at: u32,
    ) -> Option<(Agent, StartState, Self)> {
        let (start, transit_from) = match trajectory.place(at) {
            Whereabouts::At(cell) => (cell, None),
            Whereabouts::Transit { from, to } => (to, Some(from)),
            Whereabouts::Absent => return None,
        };
        let pending = |waypoint: &&TimedWaypoint| {
            let is_new = waypoint.since == Some(at);
            is_new || trajectory.visit(waypoint).is_none_or(|visit| visit > at)
        };
        let level = || Some(u32::try_from(level_over_time(past, trajectory, at)?).unwrap_or(0));
        let mut agent = timeline.agent_now(level_set(timeline, at).or_else(level));
        agent.start = start;
        let has_to_visit = |cell| {
            timeline
                .waypoints()
                .filter(pending)
                .any(|it| it.cell == cell)
        };
        agent.waypoints.retain(|&cell| has_to_visit(cell));
        let slept = trajectory.sleeps(past.times().filter(|&time| timeline.from < time));
        let is_awake = |time: &u32| !slept.iter().any(|(from, to)| (from..to).contains(&time));
        // An agent that goes on later has not arrived, even if it stands at its goal.
        let keeps = past.keeps(trajectory.timeline);
        let asleep_since = (keeps && trajectory.end() < at).then(|| trajectory.end());
        let mut rested_since = asleep_since.or_else(|| trajectory.rests_since(at));
        // It may stay for good where nothing new is to be done.
        let has_new_goal = timeline.goals.last().is_some_and(|(since, _)| *since >= at);
        let has_new_waypoint = timeline.waypoints().any(|it| it.since == Some(at));
        if !keeps || has_new_goal || has_new_waypoint {
            rested_since = None;
        }
        let rested_since = rested_since.unwrap_or(at).min(at);
        let awake = if asleep_since.is_none() { at } else { 0 };
        let waited = |time: &u32| is_awake(time) && trajectory.at(*time) == Some(start);
        let waits = (timeline.from..awake).rev().take_while(waited).count();
        let state = StartState {
            transit_from,
            breakdowns: breakdowns(timeline, at),
            rested: at - rested_since,
            rested_awake: (rested_since..awake).filter(is_awake).count() as u32,
            ..StartState::default()
        };
        let (path, charges) = trajectory.rest(at);
        let running = Self {
            is_old: true,
            path,
            charges,
            waits: waits as u32,
            asleep_since,
            spent: costs_until(past, trajectory, rested_since),
        };
        Some((agent, state, running))
    }
}

/// The level that a battery is set to at a time.
fn level_set(timeline: &Timeline, at: u32) -> Option<u32> {
    let last = timeline.levels.last().filter(|(time, _)| *time == at);
    last.map(|&(_, level)| level)
}

/// The breakdowns that go on at a time; of those that began together, the longest.
fn breakdowns(timeline: &Timeline, at: u32) -> Vec<Breakdown> {
    let ends = timeline.held.iter().filter(|&&(_, to)| to > at);
    let mut ends: Vec<(u32, u32)> = ends.copied().collect();
    sorting::sort_by_key(&mut ends, |&(from, to)| (from, u32::MAX - to));
    ends.dedup_by_key(|&mut (from, _)| from);
    let breakdown = |(from, to)| Breakdown {
        from,
        to,
        held: to - at,
    };
    ends.into_iter().map(breakdown).collect()
}
