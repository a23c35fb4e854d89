//! One agent's path alone: start, goal, waypoints, moves and obstacles.

use super::findings::{Findings, Place};
use super::steps::{Broken, Step, steps};
use super::walk::Walk;
use super::{Rule, sentence};
use crate::Instance;
use crate::sorting::set;

/// Finds what is wrong with one path, whatever the other agents do.
pub(super) fn find(instance: &Instance, walk: &Walk<'_>, findings: &mut Findings<'_>) {
    find_ends(instance, walk, findings);
    find_waypoints(walk, findings);
    find_obstacles(instance, walk, findings);
    find_moves(instance, walk, findings);
}

fn find_ends(instance: &Instance, walk: &Walk<'_>, findings: &mut Findings<'_>) {
    let agent = walk.agent;
    // An agent that begins half way along a slow move is at its start one step later.
    let in_transit = instance.start_state(&agent.name).transit_from.is_some();
    let first = if in_transit {
        walk.at(0).or(walk.at(1))
    } else {
        walk.at(0)
    };
    if first.is_some_and(|first| first != agent.start) || in_transit && walk.at(0).is_some() {
        let first = first.unwrap_or(agent.start);
        let message = sentence::start(&agent.name, first, agent.start);
        findings.push(Rule::Start, 0, &[walk.index], Place::Cell(first), message);
    }
    if let Some(last) = walk.end()
        && let Some(goal) = agent.goal
        && last != goal
    {
        let time = walk.arrival();
        let message = sentence::goal(&agent.name, last, goal, time);
        findings.push(Rule::Goal, time, &[walk.index], Place::Cell(last), message);
    }
}

fn find_waypoints(walk: &Walk<'_>, findings: &mut Findings<'_>) {
    let mut missed = set(walk.agent.waypoints.iter().copied());
    for cell in walk.path.iter().flatten() {
        if missed.is_empty() {
            return;
        }
        missed.remove(cell);
    }
    let time = walk.arrival();
    for waypoint in missed {
        let message = sentence::waypoint(&walk.agent.name, waypoint, time);
        let place = Place::Cell(waypoint);
        findings.push(Rule::Waypoint, time, &[walk.index], place, message);
    }
}

fn find_obstacles(instance: &Instance, walk: &Walk<'_>, findings: &mut Findings<'_>) {
    let grid = instance.grid();
    for (time, cell) in walk.path.iter().enumerate() {
        if let Some(cell) = *cell
            && !grid.is_vertex(cell)
        {
            let on_map = grid.ground(cell).is_some();
            let message = sentence::obstacle(&walk.agent.name, cell, time, on_map);
            findings.push(
                Rule::Obstacle,
                time,
                &[walk.index],
                Place::Cell(cell),
                message,
            );
        }
    }
}

fn find_moves(instance: &Instance, walk: &Walk<'_>, findings: &mut Findings<'_>) {
    let name = &walk.agent.name;
    let held = instance.start_state(name).not_before();
    for (time, step) in steps(instance.grid(), walk.path) {
        let (place, message) = match step {
            Step::Broken { from, to, why } => {
                let place = match why {
                    Broken::TurnBack => Place::Cell(from),
                    _ => Place::Edge(from, to),
                };
                (place, sentence::broken_step(name, from, to, time, why))
            }
            Step::Move { from, to } | Step::SlowMove { from, to } if time < held as usize => {
                let message = sentence::held(name, from, time as u32);
                (Place::Edge(from, to), message)
            }
            Step::Move { .. } | Step::SlowMove { .. } | Step::Wait => continue,
        };
        findings.push(Rule::Move, time, &[walk.index], place, message);
    }
}
