//! The faults of one agent by itself: ends, waypoints, obstacles, moves, breakdowns, charges.

use super::super::charges::NoCharge;
use super::super::findings::{Findings, Place};
use super::super::steps::{Broken, step};
use super::super::{Rule, Step, sentence};
use crate::change::{History, TimedWaypoint, Trajectory, Whereabouts};
use crate::{Cell, sorting};

pub(super) fn find(
    history: &History,
    index: usize,
    trajectory: &Trajectory<'_>,
    findings: &mut Findings<'_>,
) {
    find_ends(index, trajectory, findings);
    find_obstacles(history, index, trajectory, findings);
    find_moves(history, index, trajectory, findings);
    find_charges(history, index, trajectory, findings);
}

fn find_ends(index: usize, trajectory: &Trajectory<'_>, findings: &mut Findings<'_>) {
    let timeline = trajectory.timeline;
    let (name, from) = (timeline.name(), timeline.from);
    if let Some(first) = trajectory.at(from)
        && first != timeline.agent.start
    {
        let message = sentence::start(name, first, timeline.agent.start);
        let place = Place::Cell(first);
        findings.push(Rule::Start, from as usize, &[index], place, message);
    }
    if trajectory.is_removed() {
        return;
    }
    let end = trajectory.end();
    if let Some(last) = trajectory.at(end)
        && let Some(goal) = timeline.goal()
        && last != goal
    {
        let message = sentence::goal(name, last, goal, end as usize);
        findings.push(
            Rule::Goal,
            end as usize,
            &[index],
            Place::Cell(last),
            message,
        );
    }
    let mut waypoints: Vec<&TimedWaypoint> = timeline.waypoints().collect();
    sorting::sort_by_key(&mut waypoints, |waypoint| waypoint.cell);
    for waypoint in waypoints {
        if trajectory.visit(waypoint).is_none() {
            let message = match waypoint.since {
                None => sentence::waypoint(name, waypoint.cell, end as usize),
                Some(since) => sentence::late_waypoint(name, waypoint.cell, since, end),
            };
            let place = Place::Cell(waypoint.cell);
            findings.push(Rule::Waypoint, end as usize, &[index], place, message);
        }
    }
}

/// The entries of the path that are cells, each with its time; a rest that is
/// not listed, from when something changes.
fn stops<'a>(
    history: &'a History,
    trajectory: &'a Trajectory<'_>,
) -> impl Iterator<Item = (u32, Cell)> + 'a {
    let from = trajectory.timeline.from;
    let entries = trajectory.path.iter().enumerate();
    let listed = entries.filter_map(move |(i, cell)| Some((i as u32 + from, (*cell)?)));
    let after = from + trajectory.path.len() as u32;
    let later = history.times().filter(move |&time| time >= after);
    listed.chain(later.filter_map(|time| Some((time, trajectory.at(time)?))))
}

fn find_obstacles(
    history: &History,
    index: usize,
    trajectory: &Trajectory<'_>,
    findings: &mut Findings<'_>,
) {
    for (time, cell) in stops(history, trajectory) {
        let grid = history.grid(time);
        if !grid.is_vertex(cell) {
            let on_map = grid.ground(cell).is_some();
            let time = time as usize;
            let message = sentence::obstacle(trajectory.timeline.name(), cell, time, on_map);
            findings.push(Rule::Obstacle, time, &[index], Place::Cell(cell), message);
        }
    }
}

fn find_moves(
    history: &History,
    index: usize,
    trajectory: &Trajectory<'_>,
    findings: &mut Findings<'_>,
) {
    let name = trajectory.timeline.name();
    for (time, step) in steps_of(history, trajectory) {
        match step {
            Step::Broken { from, to, why } => {
                let message = sentence::broken_step(name, from, to, time as usize, why);
                let place = match why {
                    Broken::TurnBack => Place::Cell(from),
                    _ => Place::Edge(from, to),
                };
                findings.push(Rule::Move, time as usize, &[index], place, message);
            }
            Step::Move { from, to } | Step::SlowMove { from, to }
                if trajectory.timeline.is_held(time) =>
            {
                let message = sentence::held(name, from, time);
                let place = Place::Edge(from, to);
                findings.push(Rule::Move, time as usize, &[index], place, message);
            }
            Step::Move { to, .. } | Step::SlowMove { to, .. } => {
                // Whether it is free on arrival is looked at with all other stops.
                let arrives = time + 1 + u32::from(matches!(step, Step::SlowMove { .. }));
                let free = |time: u32| history.grid(time).is_vertex(to);
                if !free(time) && free(arrives) {
                    let message = sentence::early(name, to, time);
                    let place = Place::Cell(to);
                    findings.push(Rule::Obstacle, time as usize, &[index], place, message);
                }
            }
            Step::Wait => {}
        }
    }
    find_last_transit(history, index, trajectory, findings);
}

/// An agent that is removed half way along an edge must have begun to cross a slow one.
fn find_last_transit(
    history: &History,
    index: usize,
    trajectory: &Trajectory<'_>,
    findings: &mut Findings<'_>,
) {
    let entries = trajectory
        .path
        .iter()
        .rev()
        .take_while(|entry| entry.is_none());
    let steps = entries.count();
    let listed = trajectory.path.len().checked_sub(steps + 1);
    let Some((last, from)) = listed.and_then(|last| Some((last, (*trajectory.path.get(last)?)?)))
    else {
        return;
    };
    if !trajectory.is_removed() || steps == 0 {
        return;
    }
    let begin = trajectory.timeline.from + last as u32;
    let grid = history.grid(begin);
    let mut slow = grid
        .neighbours(from)
        .filter(|&to| grid.is_slow_edge(from, to));
    let name = trajectory.timeline.name();
    let message = if steps > 1 || slow.next().is_none() {
        sentence::no_slow_edge(name, from, begin)
    } else if trajectory.timeline.is_held(begin) {
        sentence::held(name, from, begin)
    } else {
        return;
    };
    findings.push(
        Rule::Move,
        begin as usize,
        &[index],
        Place::Cell(from),
        message,
    );
}

/// The steps of an agent, each with its absolute time and by the map of that
/// time.
pub(super) fn steps_of<'a>(
    history: &'a History,
    trajectory: &'a Trajectory<'_>,
) -> impl Iterator<Item = (u32, Step)> + 'a {
    let first = trajectory.timeline.from;
    let entries = trajectory.path.iter().enumerate();
    let mut stops = entries.filter_map(move |(i, cell)| Some((i as u32 + first, (*cell)?)));
    let mut last = stops.next();
    stops.filter_map(move |(time, to)| {
        let (begin, from) = last.replace((time, to))?;
        let grid = history.grid(begin);
        Some((begin, step(grid, from, to, (time - begin) as usize)))
    })
}

/// Whether an agent may charge at a time.
pub(super) fn may_charge(
    history: &History,
    trajectory: &Trajectory<'_>,
    time: u32,
) -> Result<(), NoCharge> {
    if trajectory.timeline.agent.battery.is_none() {
        return Err(NoCharge::NoBattery);
    }
    if time >= trajectory.end() && !(trajectory.is_removed() && time == trajectory.end()) {
        return Err(NoCharge::Arrived);
    }
    match trajectory.place(time) {
        Whereabouts::At(cell) if history.grid(time).is_charger(cell) => Ok(()),
        Whereabouts::At(cell) => Err(NoCharge::NoCharger(cell)),
        Whereabouts::Transit { .. } => Err(NoCharge::InTransit),
        Whereabouts::Absent => Err(NoCharge::Absent),
    }
}

fn find_charges(
    history: &History,
    index: usize,
    trajectory: &Trajectory<'_>,
    findings: &mut Findings<'_>,
) {
    for &time in trajectory.charges {
        if let Err(why) = may_charge(history, trajectory, time) {
            let (name, end) = (trajectory.timeline.name(), trajectory.end() as usize);
            let message = sentence::charge(name, time as usize, end, why);
            let place = match why {
                NoCharge::NoCharger(cell) => Place::Cell(cell),
                _ => Place::Nowhere,
            };
            findings.push(Rule::Charge, time as usize, &[index], place, message);
        }
    }
}
