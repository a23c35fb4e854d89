//! Batteries in a world that changes: levels that are set, agents that sleep.

use super::super::findings::{Findings, Place};
use super::super::{Rule, sentence};
use super::alone::may_charge;
use super::asleep;
use crate::change::{History, Trajectory};

/// The battery level of an agent at each time from its first to its last;
/// empty for one without a battery. Levels may be negative: the plan then is
/// none.
pub fn levels(history: &History, trajectory: &Trajectory<'_>) -> Vec<i64> {
    let timeline = trajectory.timeline;
    let Some(battery) = timeline.agent.battery else {
        return Vec::new();
    };
    let asleep = asleep(history, trajectory);
    let set_at = |time: u32| {
        let mut levels = timeline.levels.iter().rev();
        levels.find(|(at, _)| *at == time).map(|&(_, level)| level)
    };
    let mut level = i64::from(set_at(timeline.from).unwrap_or(battery.initial));
    let mut levels = vec![level];
    for time in timeline.from..trajectory.end() {
        let slept = asleep.iter().any(|&(a, b)| a <= time && time < b);
        if trajectory.charges.contains(&time) && may_charge(history, trajectory, time).is_ok() {
            level = i64::from(battery.capacity);
        } else if !slept {
            level -= 1;
        }
        if let Some(set) = set_at(time + 1) {
            level = i64::from(set);
        }
        levels.push(level);
    }
    levels
}

/// The battery level of an agent at a time, after its arrival too: from then on
/// it uses nothing, but its level may be set. `None` for one without a battery
/// and before its first time.
pub fn level_at(history: &History, trajectory: &Trajectory<'_>, time: u32) -> Option<i64> {
    let mut set = trajectory.timeline.levels.iter().rev();
    let later = |at: u32| trajectory.end() < at && at <= time;
    if let Some(&(_, level)) = set.find(|(at, _)| later(*at)) {
        return Some(i64::from(level));
    }
    let index = time
        .min(trajectory.end())
        .checked_sub(trajectory.timeline.from)?;
    levels(history, trajectory).get(index as usize).copied()
}

/// Finds the first time of each stretch below the floor.
pub(super) fn find(
    history: &History,
    index: usize,
    trajectory: &Trajectory<'_>,
    findings: &mut Findings<'_>,
) {
    let floor = i64::from(history.rules().battery_floor);
    let mut was_below = false;
    for (i, level) in levels(history, trajectory).into_iter().enumerate() {
        let below = level < floor;
        if below && !was_below {
            let time = trajectory.timeline.from + i as u32;
            let message =
                sentence::battery(trajectory.timeline.name(), level, floor, time as usize);
            let place = trajectory.at(time).map_or(Place::Nowhere, Place::Cell);
            findings.push(Rule::Battery, time as usize, &[index], place, message);
        }
        was_below = below;
    }
}
