//! Robots that broke down for good: each stays where it is as an obstacle with its name.

use giveway_model::change::{Stopped as Standing, Timeline, What};
use giveway_model::{Cell, Plan, tr};

use crate::{Answer, State};

/// A robot that broke down for good.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stopped {
    /// Its name.
    pub name: String,
    /// Its index on the board.
    pub agent: Option<usize>,
    /// Where it stays.
    pub cell: Cell,
}

/// Where a plan has an agent at a time, by its name; `None` in transit and where it is not there.
pub(super) fn place(plan: &Plan, agent: &str, at: u32) -> Option<Cell> {
    entries_from(plan, agent, at)?.first().copied().flatten()
}

/// Where an agent stands that breaks down at a time: at the end of a slow move under way.
pub(super) fn stand(plan: Option<&Plan>, agent: &str, at: u32) -> Option<Cell> {
    let mut entries = entries_from(plan?, agent, at)?.iter();
    entries.find_map(|cell| *cell)
}

/// What a plan lists of an agent from a time on: at least its last entry.
fn entries_from<'a>(plan: &'a Plan, agent: &str, at: u32) -> Option<&'a [Option<Cell>]> {
    let path = plan.path(agent);
    let from = plan.from.get(agent).copied().unwrap_or(0);
    let time = at.checked_sub(from)? as usize;
    let last = path.len().checked_sub(1)?;
    path.get(time.min(last)..)
}

/// How many robots have broken down for good, beside those that are there.
#[inline(never)]
pub(crate) fn stopped_in_words(n: usize) -> String {
    tr!("{n} broken down for good", n)
}

/// When and where an agent of a plan that went on broke down for good.
#[inline(never)]
pub(crate) fn stopped(answer: &Answer, agent: &str) -> Option<(u32, Cell)> {
    let mut all = standing(answer);
    let (_, from, standing) = all.find(|(timeline, ..)| timeline.name() == agent)?;
    Some((from, standing.cell))
}

/// The robots that have broken down for good in a world that changes.
pub(super) fn of_changes(state: &State) -> Vec<Stopped> {
    let mut all = Vec::new();
    let mut add = |name: &str, cell: Cell| {
        let mut agents = state.world().agents().iter();
        all.push(Stopped {
            name: name.to_owned(),
            agent: agents.position(|own| own.name == name),
            cell,
        });
    };
    let time = state.view.playback.time;
    for (timeline, from, standing) in state.shown().into_iter().flat_map(|it| standing(it)) {
        if from <= time && standing.until.is_none_or(|until| time < until) {
            add(timeline.name(), standing.cell);
        }
    }
    let compares = state.document.mode.comparing().is_some();
    let changing = state.document.mode.changing();
    if let Some(changing) = changing.filter(|own| own.at <= time && !compares) {
        for what in &changing.list {
            if let What::StopAgent { agent } = what
                && let Some(cell) = stand(changing.about.plan(), agent, changing.at)
            {
                add(agent, cell);
            }
        }
    }
    all.dedup();
    all
}

/// The robots of a plan that went on that broke down for good: since when, and where.
fn standing(answer: &Answer) -> impl Iterator<Item = (&Timeline, u32, Standing)> {
    let course = answer.course.as_deref();
    let timelines = course.map_or(&[][..], |course| course.history.timelines());
    timelines
        .iter()
        .filter_map(|timeline| Some((timeline, timeline.until?, timeline.stopped?)))
}
