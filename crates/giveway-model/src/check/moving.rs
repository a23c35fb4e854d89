//! Agents that meet an obstacle which moves.
//!
//! An obstacle is at one cell at each time, and stays at its last one. No agent may be at
//! that cell then, or exchange cells with the obstacle in a step. Agents that arrived and
//! stay are looked at as long as an obstacle moves.

use super::findings::{Findings, Place};
use super::walk::Walk;
use super::{Rule, sentence};
use crate::{Assumption, Cell, Instance};

/// Finds every time at which an agent and a moving obstacle meet.
pub(super) fn find(instance: &Instance, walks: &[Walk<'_>], findings: &mut Findings<'_>) {
    for assumption in instance.assumptions() {
        if let Assumption::MovingObstacle { name, path } = assumption {
            for walk in walks {
                meet(instance, walk, (name, path), findings);
            }
        }
    }
}

fn meet(
    instance: &Instance,
    walk: &Walk<'_>,
    (name, path): (&str, &[Cell]),
    findings: &mut Findings<'_>,
) {
    let agent = walk.agent.name.as_str();
    let obstacle = |time: usize| path.get(time).or(path.last()).copied();
    let at = |time: usize| {
        if time <= walk.arrival() {
            walk.at(time)
        } else {
            walk.end().filter(|_| instance.stays())
        }
    };
    let last = if instance.stays() {
        walk.arrival().max(path.len())
    } else {
        walk.arrival()
    };
    let mut before = None;
    for time in 0..=last {
        let (Some(there), Some(blocked)) = (at(time), obstacle(time)) else {
            before = None;
            continue;
        };
        if before == Some((there, blocked)) {
            // Both stand still: that was found already.
        } else if there == blocked {
            let message = sentence::moving(agent, name, there, time);
            let place = Place::Cell(there);
            findings.push(Rule::Obstacle, time, &[walk.index], place, message);
        } else if before == Some((blocked, there)) {
            let message = sentence::moving_swap(agent, name, (blocked, there), time - 1);
            let place = Place::Edge(blocked, there);
            findings.push(Rule::Obstacle, time - 1, &[walk.index], place, message);
        }
        before = Some((there, blocked));
    }
}
