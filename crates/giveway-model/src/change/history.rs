//! The world over time: what an instance and the changes of a plan make.

use super::{Changes, MAX_TIME, Timeline, Trajectory};
use crate::constraint::TimedConstraint;
use crate::{Agent, Assumption, Fault, Grid, Instance, Plan, Rules, Zone};

/// The map from a time on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Epoch {
    /// The first time at which the map is so.
    pub from: u32,
    /// The map.
    pub grid: Grid,
}

/// The world over time.
///
/// ```
/// use giveway_model::{change::History, format::native};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": ["..."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }]
/// }"#).unwrap();
/// let plan = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0]] } }"#,
/// ).unwrap();
/// let changes = native::read_changes(
///     r#"{ "giveway": 1, "changes": [{ "at": 1, "change": "add-obstacle", "cell": [1, 0] }] }"#,
/// ).unwrap();
/// let refused = History::of(&instance, &changes, &plan).unwrap_err();
/// assert_eq!(refused[0].found, "an obstacle at (1, 0), where A1 is at time 1");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct History {
    rules: Rules,
    stays: bool,
    first: Grid,
    pub(super) epochs: Vec<Epoch>,
    pub(super) timelines: Vec<Timeline>,
    zones: Vec<Zone>,
    pub(super) constraints: Vec<TimedConstraint>,
    assumptions: Vec<Assumption>,
}

impl History {
    /// The history of an instance in which nothing has changed yet.
    pub fn new(instance: &Instance) -> Self {
        let begun = |agent: &Agent| Timeline::new(agent.clone(), 0);
        Self {
            rules: instance.rules(),
            stays: instance.stays(),
            first: instance.grid().clone(),
            epochs: Vec::new(),
            timelines: instance.agents().iter().map(begun).collect(),
            zones: instance.zones().to_vec(),
            constraints: {
                let constraints = instance.constraints().iter().cloned();
                constraints.map(TimedConstraint::of_scene).collect()
            },
            assumptions: instance.assumptions().to_vec(),
        }
    }

    /// The history of all changes around one plan.
    ///
    /// # Errors
    /// The faults of the first time whose changes contradict the world, with
    /// their places in the list of changes.
    pub fn of(instance: &Instance, changes: &Changes, plan: &Plan) -> Result<Self, Vec<Fault>> {
        changes.few()?;
        let mut history = Self::new(instance);
        for (at, list) in changes.by_time() {
            history.apply(at, &list, plan)?;
        }
        Ok(history)
    }

    /// Whether arrived agents stay at their goals.
    pub const fn stays(&self) -> bool {
        self.stays
    }

    /// Whether an agent remains where it arrives; one without a goal always does.
    pub fn keeps(&self, timeline: &Timeline) -> bool {
        self.stays || timeline.goal().is_none()
    }

    /// The rules.
    pub const fn rules(&self) -> Rules {
        self.rules
    }

    /// The map at a time, what changes then included.
    pub fn grid(&self, time: u32) -> &Grid {
        let mut epochs = self.epochs.iter().rev();
        let found = epochs.find(|epoch| epoch.from <= time);
        found.map_or(&self.first, |epoch| &epoch.grid)
    }

    /// The map as it is after all changes.
    pub fn last_grid(&self) -> &Grid {
        self.grid(MAX_TIME)
    }

    /// The times at which something changed, ascending.
    pub fn times(&self) -> impl Iterator<Item = u32> + '_ {
        self.epochs.iter().map(|epoch| epoch.from)
    }

    /// All agents that there ever were, in the order in which they came.
    pub fn timelines(&self) -> &[Timeline] {
        &self.timelines
    }

    /// The named parts of the map.
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// All rules of the scene's own that there ever were, those of the scene first, then
    /// those that were added, in the order in which they came. A rule keeps its number.
    pub fn constraints(&self) -> &[TimedConstraint] {
        &self.constraints
    }

    /// The assumptions of the scene. No change touches the obstacles that move.
    pub fn assumptions(&self) -> &[Assumption] {
        &self.assumptions
    }

    /// The same world with other rules.
    pub(crate) fn with_rules(&self, edit: impl FnOnce(&mut Vec<TimedConstraint>)) -> Self {
        let mut edited = self.clone();
        edit(&mut edited.constraints);
        edited
    }

    /// The agents that a plan still has at a time: those that were neither
    /// removed nor have vanished before.
    pub fn trajectories<'a>(&'a self, plan: &'a Plan, time: u32) -> Vec<Trajectory<'a>> {
        let timelines = self.timelines.iter();
        let there = timelines.filter(|timeline| timeline.until.is_none() && timeline.from <= time);
        let trajectories = there.filter_map(|timeline| Trajectory::of(self, timeline, plan));
        trajectories
            .filter(|trajectory| {
                self.keeps(trajectory.timeline)
                    || trajectory.end() >= time
                    || is_leaving(trajectory, plan, time)
            })
            .collect()
    }
}

/// Whether the plan has an agent removed at this time or later, one step after its
/// last entry: then it was there to be removed, as the plan went before, even if what
/// is left of its path ends at its goal, or in transit.
fn is_leaving(trajectory: &Trajectory<'_>, plan: &Plan, time: u32) -> bool {
    let name = trajectory.timeline.name();
    let entries = u32::try_from(plan.path(name).len()).ok();
    let after = entries.and_then(|entries| trajectory.timeline.from.checked_add(entries));
    let until = plan.until.get(name);
    until.is_some_and(|&until| time <= until && after == Some(until))
}
