//! The rules of a scene's own in a world that changes: each is judged while it is there.

use std::collections::BTreeMap;

use super::super::constraints::{Judged, Move, Row, Start, Table, Wait};
use super::super::findings::Findings;
use super::super::{Step, steps};
use super::{alone, asleep};
use crate::Plan;
use crate::change::{History, Trajectory, Whereabouts};
use crate::condition::Times;
use crate::constraint::{ConstraintKind, InForce};

/// No agent has anything behind it when the table begins.
static NOTHING: Start = Start::nothing();

/// Finds all that a plan breaks of the rules of the scene's own.
pub(super) fn find(
    history: &History,
    trajectories: &[(usize, Trajectory<'_>)],
    findings: &mut Findings<'_>,
) {
    if history.constraints().is_empty() {
        return;
    }
    let rows = rows(history, trajectories);
    let rules = rules(history, &rows, |_| true);
    let table = Table::new((history.last_grid(), history.zones()), rows, &rules);
    for rule in &rules {
        table.judge(rule, findings);
    }
}

/// The penalty of a plan. Of a rule that was added or removed only the times count at which
/// it is there.
pub(super) fn penalty(history: &History, plan: &Plan) -> u32 {
    of_agents(history, plan, None, |row| row.arrival)
}

/// The part of the penalty that an agent pays before a time.
pub(crate) fn penalty_until(history: &History, plan: &Plan, name: &str, until: u32) -> u32 {
    of_agents(history, plan, Some(name), |_| until)
}

/// The penalty of one agent, or of all, each up to an arrival.
fn of_agents(
    history: &History,
    plan: &Plan,
    name: Option<&str>,
    arrival: impl Fn(&Row<'_>) -> u32,
) -> u32 {
    let mut constraints = history.constraints().iter();
    if !constraints.any(|it| it.constraint.is_penalty() && !it.constraint.off) {
        return 0;
    }
    let timelines = history.timelines().iter().enumerate();
    let timelines = timelines.filter(|(_, it)| name.is_none_or(|name| it.name() == name));
    let trajectories: Vec<(usize, Trajectory<'_>)> = timelines
        .filter_map(|(index, timeline)| Some((index, Trajectory::of(history, timeline, plan)?)))
        .collect();
    let rows = rows(history, &trajectories);
    let rules = rules(history, &rows, |kind| {
        matches!(
            kind,
            ConstraintKind::Avoid { .. } | ConstraintKind::Late { .. }
        )
    });
    let table = Table::new((history.last_grid(), history.zones()), rows, &rules);
    let penalties = rules.iter().map(|rule| table.penalty(rule, &arrival));
    penalties.fold(0, u32::saturating_add)
}

/// The wait steps on end that an agent has made just before a time, as far as a rule that is
/// there since another time counts them.
pub(crate) fn waits_on_end(
    history: &History,
    trajectory: &Trajectory<'_>,
    (since, at): (u32, u32),
) -> u32 {
    let waits = waits(history, trajectory).into_iter();
    let (mut run, mut next) = (0, 0);
    for Wait { time, is_held } in waits.filter(|wait| wait.time < at) {
        if time != next {
            run = 0;
        }
        next = time + 1;
        run += u32::from(!is_held && time >= since);
    }
    if next == at { run } else { 0 }
}

/// The rules that are there at some time, each with the agents that are there meanwhile.
fn rules<'h>(
    history: &'h History,
    rows: &[Row<'_>],
    is_wanted: impl Fn(&ConstraintKind) -> bool,
) -> Vec<Judged<'h>> {
    let constraints = history.constraints().iter().enumerate();
    let wanted = constraints.filter(|(_, it)| is_wanted(&it.constraint.kind));
    let mut numbers = BTreeMap::new();
    numbers.extend(rows.iter().map(|row| (row.name, row)));
    let judged = |(index, timed): (usize, &'h crate::constraint::TimedConstraint)| {
        let mut span = timed.span()?;
        let is_there = |row: &Row<'_>| {
            let is_gone = row.gone.is_some_and(|gone| gone <= span.first());
            !is_gone && row.from <= span.last()
        };
        let number = |name: &str| {
            let row = numbers.get(name)?;
            is_there(row).then_some(row.agent)
        };
        let all = || {
            let there = rows.iter().filter(|row| is_there(row));
            there.map(|row| row.agent).collect()
        };
        let rule: InForce<'h> = timed.constraint.in_force_among(index, &number, all)?;
        if let ConstraintKind::Before { first, second } = &timed.constraint.kind {
            // It goes with the first of them that is removed.
            let ends = [first, second].map(|visit| numbers.get(visit.agent.as_str()));
            let ends = ends.into_iter().flatten().filter(|row| row.is_removed);
            let last = ends.map(|row| row.arrival).min().unwrap_or(u32::MAX);
            span = Times {
                to: Some(span.last().min(last)),
                ..span
            };
        }
        let since = timed.since;
        Some(Judged { rule, span, since })
    };
    wanted.filter_map(judged).collect()
}

fn rows<'a>(history: &'a History, trajectories: &'a [(usize, Trajectory<'a>)]) -> Vec<Row<'a>> {
    let row = |(agent, trajectory): &'a (usize, Trajectory<'a>)| {
        let timeline = trajectory.timeline;
        let steps = alone::steps_of(history, trajectory);
        let gone = match timeline.until {
            Some(until) => Some(until),
            None if history.keeps(timeline) => None,
            None => Some(trajectory.end().saturating_add(1)),
        };
        Row {
            agent: *agent,
            name: timeline.name(),
            from: timeline.from,
            path: trajectory.path,
            arrival: trajectory.end(),
            is_removed: trajectory.is_removed(),
            gone,
            moves: steps
                .filter_map(|(begin, step)| Move::of(begin, step))
                .collect(),
            waits: waits(history, trajectory),
            breakdowns: breakdowns(trajectory),
            heading: timeline.agent.heading,
            start: &NOTHING,
        }
    };
    trajectories.iter().map(row).collect()
}

/// When an agent breaks down; on its way along a slow edge, that is when the change comes.
fn breakdowns(trajectory: &Trajectory<'_>) -> Vec<u32> {
    let held = trajectory.timeline.held.iter();
    let held = held.filter(|(from, to)| from < to);
    let begins = held.map(|&(from, _)| match from.checked_sub(1) {
        Some(before) if matches!(trajectory.place(before), Whereabouts::Transit { .. }) => before,
        _ => from,
    });
    begins.collect()
}

/// The wait steps of an agent; what it slept through are none.
fn waits(history: &History, trajectory: &Trajectory<'_>) -> Vec<Wait> {
    let timeline = trajectory.timeline;
    let asleep = asleep(history, trajectory);
    let steps = steps(history.grid(0), trajectory.path);
    let listed = steps.filter(|(_, step)| *step == Step::Wait);
    let listed = listed.map(|(begin, _)| begin as u32 + timeline.from);
    // An agent that waits for a goal or a waypoint of its own cell need not have it listed.
    let after = (timeline.from + trajectory.path.len() as u32).saturating_sub(1);
    let times = listed.chain(after..trajectory.end());
    let is_awake = |time: &u32| !asleep.iter().any(|&(from, to)| (from..to).contains(time));
    let waits = times.filter(is_awake).map(|time| Wait {
        time,
        is_held: timeline.is_held(time),
    });
    waits.collect()
}
