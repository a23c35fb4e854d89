//! What one agent does wrong by itself: ends, waypoints, obstacles, moves,
//! breakdowns, charges.

use super::super::charges::NoCharge;
use super::super::findings::{Findings, Place};
use super::super::steps::{Broken, step};
use super::super::{Rule, Step, sentence};
use crate::change::{Duty, History, Life, Whereabouts};
use crate::{Cell, sorting};

pub(super) fn find(history: &History, index: usize, life: &Life<'_>, findings: &mut Findings<'_>) {
    find_ends(index, life, findings);
    find_obstacles(history, index, life, findings);
    find_moves(history, index, life, findings);
    find_charges(history, index, life, findings);
}

fn find_ends(index: usize, life: &Life<'_>, findings: &mut Findings<'_>) {
    let career = life.career;
    let (name, from) = (career.name(), career.from);
    if let Some(first) = life.at(from)
        && first != career.agent.start
    {
        let message = sentence::start(name, first, career.agent.start);
        let place = Place::Cell(first);
        findings.push(Rule::Start, from as usize, &[index], place, message);
    }
    if life.is_removed() {
        return;
    }
    let end = life.end();
    if let Some(last) = life.at(end)
        && last != career.goal()
    {
        let message = sentence::goal(name, last, career.goal(), end as usize);
        findings.push(
            Rule::Goal,
            end as usize,
            &[index],
            Place::Cell(last),
            message,
        );
    }
    let mut duties: Vec<&Duty> = career.duties().collect();
    sorting::sort_by_key(&mut duties, |duty| duty.cell);
    for duty in duties {
        if life.visit(duty).is_none() {
            let message = match duty.since {
                None => sentence::waypoint(name, duty.cell, end as usize),
                Some(since) => sentence::late_waypoint(name, duty.cell, since, end),
            };
            let place = Place::Cell(duty.cell);
            findings.push(Rule::Waypoint, end as usize, &[index], place, message);
        }
    }
}

/// The entries of the path that are cells, each with its time; a rest that is
/// not listed, from when something changes.
fn stops<'a>(history: &'a History, life: &'a Life<'_>) -> impl Iterator<Item = (u32, Cell)> + 'a {
    let from = life.career.from;
    let entries = life.path.iter().enumerate();
    let listed = entries.filter_map(move |(i, cell)| Some((i as u32 + from, (*cell)?)));
    let after = from + life.path.len() as u32;
    let later = history.times().filter(move |&time| time >= after);
    listed.chain(later.filter_map(|time| Some((time, life.at(time)?))))
}

fn find_obstacles(history: &History, index: usize, life: &Life<'_>, findings: &mut Findings<'_>) {
    for (time, cell) in stops(history, life) {
        let grid = history.grid(time);
        if !grid.is_vertex(cell) {
            let on_map = grid.ground(cell).is_some();
            let time = time as usize;
            let message = sentence::obstacle(life.career.name(), cell, time, on_map);
            findings.push(Rule::Obstacle, time, &[index], Place::Cell(cell), message);
        }
    }
}

fn find_moves(history: &History, index: usize, life: &Life<'_>, findings: &mut Findings<'_>) {
    let name = life.career.name();
    for (time, step) in steps_of(history, life) {
        match step {
            Step::Broken { from, to, why } => {
                let message = sentence::broken_step(name, from, to, time as usize, why);
                let place = match why {
                    Broken::TurnBack => Place::Cell(from),
                    _ => Place::Edge(from, to),
                };
                findings.push(Rule::Move, time as usize, &[index], place, message);
            }
            Step::Move { from, to } | Step::SlowMove { from, to } if life.career.is_held(time) => {
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
    find_last_transit(history, index, life, findings);
}

/// Who is removed half way along an edge must have begun to cross a slow one.
fn find_last_transit(
    history: &History,
    index: usize,
    life: &Life<'_>,
    findings: &mut Findings<'_>,
) {
    let entries = life.path.iter().rev().take_while(|entry| entry.is_none());
    let steps = entries.count();
    let listed = life.path.len().checked_sub(steps + 1);
    let Some((last, from)) = listed.and_then(|last| Some((last, (*life.path.get(last)?)?))) else {
        return;
    };
    if !life.is_removed() || steps == 0 {
        return;
    }
    let begin = life.career.from + last as u32;
    let grid = history.grid(begin);
    let mut slow = grid
        .neighbours(from)
        .filter(|&to| grid.is_slow_edge(from, to));
    let name = life.career.name();
    let message = if steps > 1 || slow.next().is_none() {
        sentence::no_slow_edge(name, from, begin)
    } else if life.career.is_held(begin) {
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
    life: &'a Life<'_>,
) -> impl Iterator<Item = (u32, Step)> + 'a {
    let first = life.career.from;
    let entries = life.path.iter().enumerate();
    let mut stops = entries.filter_map(move |(i, cell)| Some((i as u32 + first, (*cell)?)));
    let mut last = stops.next();
    stops.filter_map(move |(time, to)| {
        let (begin, from) = last.replace((time, to))?;
        let grid = history.grid(begin);
        Some((begin, step(grid, from, to, (time - begin) as usize)))
    })
}

/// Whether an agent may charge at a time.
pub(super) fn may_charge(history: &History, life: &Life<'_>, time: u32) -> Result<(), NoCharge> {
    if life.career.agent.battery.is_none() {
        return Err(NoCharge::NoBattery);
    }
    if time >= life.end() && !(life.is_removed() && time == life.end()) {
        return Err(NoCharge::Arrived);
    }
    match life.place(time) {
        Whereabouts::At(cell) if history.grid(time).is_charger(cell) => Ok(()),
        Whereabouts::At(cell) => Err(NoCharge::NoCharger(cell)),
        Whereabouts::Transit { .. } => Err(NoCharge::InTransit),
        Whereabouts::Absent => Err(NoCharge::Absent),
    }
}

fn find_charges(history: &History, index: usize, life: &Life<'_>, findings: &mut Findings<'_>) {
    for &time in life.charges {
        if let Err(why) = may_charge(history, life, time) {
            let (name, end) = (life.career.name(), life.end() as usize);
            let message = sentence::charge(name, time as usize, end, why);
            let place = match why {
                NoCharge::NoCharger(cell) => Place::Cell(cell),
                _ => Place::Nowhere,
            };
            findings.push(Rule::Charge, time as usize, &[index], place, message);
        }
    }
}
