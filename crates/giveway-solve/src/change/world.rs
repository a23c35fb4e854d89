//! The world at the time of a change, as the search sees it: agents half way
//! through their tasks, times counted from then.

use std::ops::Range;

use giveway_model::{
    Cell, Plan,
    change::{History, TimedWaypoint, Timeline, Trajectory, Whereabouts},
    check::level_over_time,
    sorting,
};

use crate::{
    search::Before,
    single::{Bounds, Hopeless, MAX_WAYPOINTS, Place, Reserve, Task, has_to_be_at},
    terrain::{Terrain, Vertex},
    walk::Walk,
};

/// An agent that goes on, or begins.
pub(super) struct Member {
    pub(super) name: String,
    /// Whether it has been there before.
    pub(super) is_old: bool,
    /// Where it is now; where it is half way, the cell that it enters next.
    pub(super) here: Cell,
    /// The cell that it leaves, where it is half way.
    pub(super) tail: Option<Cell>,
    pub(super) goal: Cell,
    /// The waypoints that it has still to visit.
    pub(super) waypoints: Vec<Cell>,
    /// Its level now and its capacity.
    battery: Option<(u32, u32)>,
    held: u32,
    /// How long it has been at its goal, where it may stay there for good: then
    /// it arrived when it came.
    pub(super) rested: u32,
    /// Of these steps those that are waits if it goes on: all, unless it had
    /// arrived and slept.
    stood: u32,
    /// When it arrived, before the change; `None` where it was under way.
    pub(super) arrived: Option<u32>,
    /// The cells of the rest of its old path, waits taken out.
    pub(super) rest: Vec<Cell>,
    /// The entries of the rest of its old path.
    entries: Vec<Option<Cell>>,
    charges: Vec<u32>,
}

/// The world from the time of a change on.
pub(super) struct World<'a> {
    pub(super) at: u32,
    /// What was before, and with the changes.
    pub(super) before: &'a History,
    pub(super) after: &'a History,
    pub(super) plan: &'a Plan,
    pub(super) members: Vec<Member>,
}

impl<'a> World<'a> {
    /// The world of a plan at a time; `before` has not the changes of that
    /// time, `after` has.
    pub(super) fn new(at: u32, before: &'a History, after: &'a History, plan: &'a Plan) -> Self {
        let trajectories = before.trajectories(plan, at);
        let mut members = Vec::new();
        for (index, timeline) in after.timelines().iter().enumerate() {
            if timeline.until.is_some() {
                continue;
            }
            let old = trajectories
                .iter()
                .find(|trajectory| trajectory.timeline.name() == timeline.name());
            if let Some(trajectory) = old {
                members.extend(Member::old(timeline, trajectory, before, at));
            } else if before.timelines().len() <= index {
                members.push(Member::new(timeline, at));
            }
        }
        Self {
            at,
            before,
            after,
            plan,
            members,
        }
    }

    /// The map of now.
    pub(super) fn terrain(&self) -> Terrain {
        Terrain::new(self.after.grid(self.at))
    }

    /// The task of an agent within bounds.
    ///
    /// # Errors
    /// Where it can do nothing.
    pub(super) fn task(
        &self,
        member: &Member,
        bounds: Bounds,
        terrain: &mut Terrain,
    ) -> Result<Task, Hopeless> {
        let floor = self.after.rules().battery_floor;
        // Who is held to a path that leads on has to go on.
        let may_stay = !matches!(&bounds, Bounds::Along(path) if path.len() > 1);
        let mut bounds = bounds;
        let mut waypoints: Vec<Vertex> = Vec::new();
        let mut reserve = None;
        if let Some((level, capacity)) = member.battery {
            match Reserve::above(floor, capacity, level) {
                Ok(above) => reserve = Some(above),
                // Who has arrived needs no battery, as long as it stays.
                Err(_) if may_stay && member.rested > 0 => {
                    bounds = Bounds::Along(vec![has_to_be_at(member.here, terrain)?].into());
                }
                Err(hopeless) => return Err(hopeless),
            }
        }
        if !matches!(bounds, Bounds::Along(_)) {
            let cells = member.waypoints.iter().take(MAX_WAYPOINTS + 1);
            waypoints = cells
                .map(|&cell| has_to_be_at(cell, terrain))
                .collect::<Result<_, _>>()?;
        }
        let start = has_to_be_at(member.here, terrain)?;
        let transit = member.tail.map(|tail| {
            let from = terrain.vertex(tail);
            terrain.transit(from, start)
        });
        Ok(Task {
            start,
            goal: has_to_be_at(member.goal, terrain)?,
            waypoints,
            reserve,
            demand: None,
            not_before: 0,
            bounds,
            transit,
            held: member.held,
            woken: if may_stay { member.rested } else { 0 },
            stood: if may_stay { member.stood } else { 0 },
        })
    }
}

impl Member {
    pub(super) const fn has_battery(&self) -> bool {
        self.battery.is_some()
    }

    fn new(timeline: &Timeline, at: u32) -> Self {
        let agent = &timeline.agent;
        let level = level_set(timeline, at);
        let mut waypoints: Vec<Cell> = timeline.waypoints().map(|waypoint| waypoint.cell).collect();
        sorting::sort(&mut waypoints);
        waypoints.dedup();
        Self {
            name: agent.name.clone(),
            is_old: false,
            here: agent.start,
            tail: None,
            goal: timeline.goal(),
            waypoints,
            battery: agent
                .battery
                .map(|battery| (level.unwrap_or(battery.initial), battery.capacity)),
            held: held(timeline, at),
            rested: 0,
            stood: 0,
            arrived: None,
            rest: Vec::new(),
            entries: Vec::new(),
            charges: Vec::new(),
        }
    }

    fn old(
        timeline: &Timeline,
        trajectory: &Trajectory<'_>,
        before: &History,
        at: u32,
    ) -> Option<Self> {
        let (here, tail) = match trajectory.place(at) {
            Whereabouts::At(cell) => (cell, None),
            Whereabouts::Transit { from, to } => (to, Some(from)),
            Whereabouts::Absent => return None,
        };
        let entries: Vec<Option<Cell>> = (at..=trajectory.end().max(at))
            .map(|t| trajectory.at(t))
            .collect();
        let mut rest: Vec<Cell> = entries.iter().copied().flatten().collect();
        rest.dedup();
        let pending = |waypoint: &&TimedWaypoint| {
            let is_new = waypoint.since == Some(at);
            is_new || trajectory.visit(waypoint).is_none_or(|visit| visit > at)
        };
        let mut waypoints: Vec<Cell> = timeline
            .waypoints()
            .filter(pending)
            .map(|d| d.cell)
            .collect();
        sorting::sort(&mut waypoints);
        waypoints.dedup();
        let level = timeline.agent.battery.map(|battery| {
            let level = level_over_time(before, trajectory, at).unwrap_or(0);
            let set = level_set(timeline, at);
            let level = set.unwrap_or(u32::try_from(level).unwrap_or(0));
            (level, battery.capacity)
        });
        // Who goes on later has not arrived, even if it stands at its goal.
        let arrived = (before.stays() && trajectory.end() < at).then(|| trajectory.end());
        // It may stay for good where nothing new is to be done.
        let unchanged = timeline.goals.last().is_none_or(|(since, _)| *since < at)
            && timeline
                .waypoints()
                .all(|waypoint| waypoint.since != Some(at));
        let stays = before.stays() && unchanged;
        let since = arrived
            .or_else(|| trajectory.rests_since(at))
            .filter(|_| stays);
        let rested = since.map_or(0, |since| at.saturating_sub(since));
        Some(Self {
            name: timeline.name().to_owned(),
            is_old: true,
            here,
            tail,
            goal: timeline.goal(),
            waypoints,
            battery: level,
            held: held(timeline, at),
            rested,
            stood: match since {
                Some(since) if arrived.is_none() => awake(trajectory, before, since..at),
                _ => 0,
            },
            arrived,
            rest,
            entries,
            charges: {
                let later = trajectory.charges.iter().filter(|&&time| time >= at);
                later.map(|&time| time - at).collect()
            },
        })
    }

    /// What it did in the old plan, over the map of now; an empty walk where it
    /// cannot do so any more.
    pub(super) fn before(&self, task: &Task, terrain: &Terrain) -> Before {
        Before {
            walk: self.walk(task, terrain).unwrap_or_default(),
            charges: self.charges.clone(),
        }
    }

    /// The rest of the old path as a walk; `None` where its slow moves are none
    /// any more.
    fn walk(&self, task: &Task, terrain: &Terrain) -> Option<Walk> {
        let mut walk = Walk::with_capacity(self.entries.len());
        for (time, entry) in self.entries.iter().enumerate() {
            if let Some(cell) = entry {
                walk.push(Place::At(terrain.vertex(*cell)?));
                continue;
            }
            let Some(before) = time.checked_sub(1) else {
                walk.push(task.first_place());
                continue;
            };
            let from = terrain.vertex(self.entries.get(before).copied()??)?;
            let to = terrain.vertex(self.entries.get(time + 1).copied()??)?;
            let arc = terrain.arcs(from).iter().find(|arc| arc.to == to)?;
            walk.push(Place::Along(arc.id));
        }
        Some(walk)
    }
}

/// For how many of these steps at its goal an agent did not sleep.
fn awake(trajectory: &Trajectory<'_>, before: &History, steps: Range<u32>) -> u32 {
    let times = before
        .times()
        .filter(|&time| trajectory.timeline.from < time);
    let slept = trajectory.sleeps(times);
    let awake = steps.filter(|&time| !slept.iter().any(|&(from, to)| from <= time && time < to));
    awake.count() as u32
}

/// The level that a battery is set to at a time.
fn level_set(timeline: &Timeline, at: u32) -> Option<u32> {
    let last = timeline.levels.last().filter(|(time, _)| *time == at);
    last.map(|&(_, level)| level)
}

/// How long it must still wait.
fn held(timeline: &Timeline, at: u32) -> u32 {
    let ends = timeline.held.iter().map(|&(_, end)| end);
    ends.max().unwrap_or(0).saturating_sub(at)
}
