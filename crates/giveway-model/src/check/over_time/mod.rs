//! The judge of a plan around which the world changes.
//!
//! Each time is judged in the world of that time: a step by the map at which it
//! begins, a cell by the map of its own time. Like [`super::check`] it shares
//! nothing with the solver.

mod alone;
mod battery;
mod constraints;
mod shape;
mod together;

use super::findings::Findings;
use super::{Report, Step, steps};
use crate::change::{Changes, History, Timeline, Trajectory};
use crate::{Costs, Fault, Instance, Plan};

pub use battery::{level_at, levels};
pub(crate) use constraints::{penalty_until, waits_on_end};

/// Judges a plan with the changes of the world while it runs.
///
/// Without changes it says what [`check`](super::check) says. A removed agent
/// leaves all costs; an added one counts with its absolute arrival. An agent
/// that had arrived before a change made it go on slept up to then: it used no
/// battery and made no waits. The plan says so ([`Plan::slept`]), since one that
/// was about to go on anyway stands there in the same way.
///
/// # Errors
/// The faults of changes that contradict the world as the plan has it.
///
/// ```
/// use giveway_model::{check::check_changes, format::native};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": ["..."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [1, 0] }]
/// }"#).unwrap();
/// let changes = native::read_changes(r#"{ "giveway": 1, "changes":
///     [{ "at": 3, "change": "set-goal", "agent": "A1", "cell": [2, 0] }] }"#).unwrap();
/// let plan = native::read_plan(r#"{ "giveway": 1, "knows": 3, "slept": { "A1": [[1, 3]] },
///     "paths": { "A1": [[0, 0], [1, 0], [1, 0], [1, 0], [2, 0]] } }"#).unwrap();
/// let report = check_changes(&instance, &changes, &plan).unwrap();
/// assert!(report.is_valid());
/// assert_eq!(report.costs.unwrap().waits, 0);
/// ```
pub fn check_changes(
    instance: &Instance,
    changes: &Changes,
    plan: &Plan,
) -> Result<Report, Vec<Fault>> {
    let history = History::of(instance, changes, plan)?;
    Ok(check_history(&history, plan))
}

/// Judges a plan in a history that was made from it.
///
/// A rule of the scene's own is judged in the world of each time: from when a change added
/// it, and before one removed it, among the agents that are there meanwhile. Where a rule is
/// about the way so far (a sequence, a visit, a precedence, a gap, turns), what was done before
/// it was added counts. Waits on end count from then on; a zone counts an agent that is in it
/// then once it has left, and so it does with one that a breakdown keeps there.
pub fn check_history(history: &History, plan: &Plan) -> Report {
    let timelines = history.timelines();
    let mut findings = Findings::named(timelines.iter().map(Timeline::name).collect());
    shape::find(history, plan, &mut findings);
    let trajectories: Vec<(usize, Trajectory<'_>)> = timelines
        .iter()
        .enumerate()
        .filter_map(|(index, timeline)| Some((index, Trajectory::of(history, timeline, plan)?)))
        .collect();
    for &(index, trajectory) in &trajectories {
        alone::find(history, index, &trajectory, &mut findings);
        battery::find(history, index, &trajectory, &mut findings);
    }
    together::find(history, &trajectories, &mut findings);
    constraints::find(history, &trajectories, &mut findings);
    super::moving::find_over_time(history, &trajectories, &mut findings);
    Report {
        violations: findings.into_violations(),
        costs: costs(history, plan),
    }
}

/// The costs of a plan in a history; `None` where an agent has no path.
pub fn costs_over_time(history: &History, plan: &Plan) -> Option<Costs> {
    costs(history, plan)
}

/// The charges, moves and waits of an agent that begin before a time; nothing
/// else of its costs is known by then.
pub fn costs_until(history: &History, trajectory: &Trajectory<'_>, until: u32) -> Costs {
    let asleep = asleep(history, trajectory);
    let slept = |time: u32| asleep.iter().any(|&(a, b)| a <= time && time < b);
    let mut costs = Costs {
        charges: trajectory
            .charges
            .iter()
            .filter(|&&time| time < until)
            .count() as u32,
        ..Costs::default()
    };
    for (begin, step) in steps(history.grid(0), trajectory.path) {
        let time = begin as u32 + trajectory.timeline.from;
        match step {
            _ if time >= until => {}
            Step::Wait => costs.waits += u32::from(!slept(time)),
            _ => costs.moves += 1,
        }
    }
    let listed = trajectory.path.len() as u32 + trajectory.timeline.from;
    for time in listed.saturating_sub(1)..trajectory.end().min(until) {
        costs.waits += u32::from(!slept(time));
    }
    costs
}

fn costs(history: &History, plan: &Plan) -> Option<Costs> {
    let mut costs = Costs::default();
    for timeline in history.timelines() {
        if timeline.until.is_some() {
            continue;
        }
        let trajectory = Trajectory::of(history, timeline, plan)?;
        costs.makespan = costs.makespan.max(trajectory.end());
        costs.sum_of_costs = costs.sum_of_costs.saturating_add(trajectory.end());
        costs.charges = costs
            .charges
            .saturating_add(trajectory.charges.len() as u32);
        let asleep = asleep(history, &trajectory);
        for (begin, step) in steps(history.grid(0), trajectory.path) {
            let time = begin as u32 + timeline.from;
            match step {
                Step::Wait if asleep.iter().any(|&(a, b)| a <= time && time < b) => {}
                Step::Wait => costs.waits = costs.waits.saturating_add(1),
                _ => costs.moves = costs.moves.saturating_add(1),
            }
        }
        // An agent that waits for a goal or a waypoint of its own cell need not
        // have it listed.
        let listed = trajectory.path.len() as u32 + timeline.from;
        for time in listed.saturating_sub(1)..trajectory.end() {
            let slept = asleep.iter().any(|&(a, b)| a <= time && time < b);
            costs.waits = costs.waits.saturating_add(u32::from(!slept));
        }
    }
    costs.penalty = constraints::penalty(history, plan);
    Some(costs)
}

/// The times that an agent slept through, up to a change each.
fn asleep(history: &History, trajectory: &Trajectory<'_>) -> Vec<(u32, u32)> {
    let from = trajectory.timeline.from;
    trajectory.sleeps(history.times().filter(|&time| from < time))
}
