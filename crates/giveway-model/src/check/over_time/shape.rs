//! Plans that are none, in a world that changes.

use super::super::findings::{Findings, Place};
use super::super::{Rule, sentence, shape};
use crate::Plan;
use crate::change::{History, Timeline};

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
    let until = plan.until.get(name).copied();
    if until != timeline.until {
        let message = sentence::wrong_until(name, until, timeline.until);
        shape::push(
            findings,
            index,
            until.or(timeline.until).unwrap_or(0),
            message,
        );
    }
    let Some(until) = timeline.until else { return };
    let path = plan.path(name);
    let listed = path.len() as u32;
    let due = until.saturating_sub(timeline.from);
    // An agent that had arrived was at its last cell.
    let last = path.last().copied().flatten();
    let arrived = last.is_some() && timeline.goal().is_none_or(|goal| last == Some(goal));
    if listed > due || (listed < due && !(arrived && listed > 0)) {
        let last = timeline.from + listed.saturating_sub(1);
        let message = sentence::wrong_end(name, last, until);
        findings.push(
            Rule::Shape,
            last as usize,
            &[index],
            Place::Nowhere,
            message,
        );
    }
}
