//! Plans that are none, in a world that changes.

use super::super::findings::Findings;
use super::super::{sentence, shape};
use crate::change::{History, Timeline};
use crate::{Cell, Plan};

pub(super) fn find(history: &History, plan: &Plan, findings: &mut Findings<'_>) {
    let timelines = history.timelines();
    for (index, timeline) in timelines.iter().enumerate() {
        let name = timeline.name();
        let end = timeline
            .until
            .map_or(shape::End::Arrives, |_| shape::End::Gone);
        match plan.paths.get(name) {
            None => shape::push(findings, index, timeline.from, sentence::no_path(name)),
            Some(path) => shape::find_in_path(path, index, name, (timeline.from, end), findings),
        }
        shape::find_in_charges(plan.charges(name), index, name, findings);
        find_times(timeline, plan, index, findings);
    }
    let names = timelines.iter().map(Timeline::name).collect();
    shape::find_strangers(names, plan, findings);
}

/// When it appears, and when it is gone.
fn find_times(timeline: &Timeline, plan: &Plan, index: usize, findings: &mut Findings<'_>) {
    let name = timeline.name();
    if !plan.paths.contains_key(name) {
        return; // which is told already
    }
    let from = plan.from.get(name).copied().unwrap_or(0);
    if from != timeline.from {
        let message = sentence::wrong_from(name, from, timeline.from);
        shape::push(findings, index, from, message);
    }
    // The path of one that broke down for good says by itself where it ends.
    let removed = timeline.until.filter(|_| timeline.stopped.is_none());
    let until = plan.until.get(name).copied();
    if until != removed {
        let message = sentence::wrong_until(name, until, removed);
        shape::push(findings, index, until.or(removed).unwrap_or(0), message);
    }
    let path = plan.path(name);
    if let Some(stood) = timeline.stood(path) {
        find_where_it_stands(timeline, path, &stood, index, findings);
        return;
    }
    let Some(until) = timeline.until else { return };
    let listed = path.len() as u32;
    let due = until.saturating_sub(timeline.from);
    // An agent that had arrived was at its last cell.
    let arrived = rests(timeline, path);
    if listed > due || (listed < due && !(arrived && listed > 0)) {
        let last = timeline.from + listed.saturating_sub(1);
        let message = sentence::wrong_end(name, last, until);
        shape::push(findings, index, last, message);
    }
}

/// The path of one that broke down for good ends at the time from which it stands; or earlier,
/// where it rested.
fn find_where_it_stands(
    timeline: &Timeline,
    path: &[Option<Cell>],
    stood: &[Option<Cell>],
    index: usize,
    findings: &mut Findings<'_>,
) {
    let name = timeline.name();
    let is_short = path.len() < stood.len();
    if path.len() > stood.len() || (is_short && !rests(timeline, path)) {
        let from = timeline.from;
        let last = from + (path.len() as u32).saturating_sub(1);
        let due = from + (stood.len() as u32).saturating_sub(1);
        let message = sentence::wrong_stand(name, last, due);
        shape::push(findings, index, last, message);
    }
}

/// Whether a path ends at the goal of its agent.
fn rests(timeline: &Timeline, path: &[Option<Cell>]) -> bool {
    let last = path.last().copied().flatten();
    last.is_some() && timeline.goal().is_none_or(|goal| last == Some(goal))
}
