//! Agents that meet an obstacle which moves.
//!
//! An obstacle is at one cell at each time, and stays at its last one. No agent may be at
//! that cell then, or exchange cells with the obstacle in a step; half way along a slow edge
//! that is either of its two steps. Agents that arrived and stay are looked at as long as an
//! obstacle moves.

use super::findings::{Findings, Place};
use super::walk::Walk;
use super::{Rule, sentence};
use crate::{Assumption, Cell, Instance, Plan};
use borsh::{BorshDeserialize, BorshSerialize};

/// An agent that meets an obstacle which moves.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct MovingMeeting {
    /// The agent.
    pub agent: String,
    /// The obstacle's name.
    pub obstacle: String,
    /// The time; where the two exchange cells, the one at which that begins.
    pub time: u32,
    /// The cell of the agent: where both are, or the one that it exchanges for the other's.
    pub cell: Cell,
    /// The cell that the agent goes to, where the two exchange cells.
    pub to: Option<Cell>,
}

impl MovingMeeting {
    /// The meeting as a sentence.
    pub fn sentence(&self) -> String {
        match self.to {
            None => sentence::moving(&self.agent, &self.obstacle, self.cell, self.time),
            Some(to) => {
                sentence::moving_swap(&self.agent, &self.obstacle, (self.cell, to), self.time)
            }
        }
    }
}

/// The first meeting of a plan with an obstacle that moves, by time, then agents in the order
/// of the instance.
pub fn first_meeting(instance: &Instance, plan: &Plan) -> Option<MovingMeeting> {
    let walks = Walk::all(instance, plan);
    let mut met: Vec<(usize, MovingMeeting)> = Vec::new();
    meetings(instance, &walks, |walk, meeting| {
        met.push((walk.index, meeting));
    });
    let first = met
        .into_iter()
        .min_by_key(|(index, met)| (met.time, *index));
    first.map(|(_, meeting)| meeting)
}

/// Finds every time at which an agent and a moving obstacle meet.
pub(super) fn find(instance: &Instance, walks: &[Walk<'_>], findings: &mut Findings<'_>) {
    meetings(instance, walks, |walk, meeting| {
        let place = match meeting.to {
            None => Place::Cell(meeting.cell),
            Some(to) => Place::Edge(meeting.cell, to),
        };
        let time = meeting.time as usize;
        let message = meeting.sentence();
        findings.push(Rule::Obstacle, time, &[walk.index], place, message);
    });
}

fn meetings(
    instance: &Instance,
    walks: &[Walk<'_>],
    mut met: impl FnMut(&Walk<'_>, MovingMeeting),
) {
    for assumption in instance.assumptions() {
        if let Assumption::MovingObstacle { name, path } = assumption {
            for walk in walks {
                meet(instance, walk, (name, path), &mut |meeting| {
                    met(walk, meeting);
                });
            }
        }
    }
}

fn meet(
    instance: &Instance,
    walk: &Walk<'_>,
    (name, path): (&str, &[Cell]),
    met: &mut dyn FnMut(MovingMeeting),
) {
    let meeting = |time: usize, cell, to| MovingMeeting {
        agent: walk.agent.name.clone(),
        obstacle: name.to_owned(),
        time: time as u32,
        cell,
        to,
    };
    let obstacle = |time: usize| path.get(time).or(path.last()).copied();
    let keeps = instance.keeps(walk.agent);
    let at = |time: usize| {
        if time <= walk.arrival() {
            walk.at(time)
        } else {
            walk.end().filter(|_| keeps)
        }
    };
    let last = if keeps {
        walk.arrival().max(path.len())
    } else {
        walk.arrival()
    };
    let mut before = None;
    for time in 0..=last {
        let (Some(there), Some(blocked)) = (at(time), obstacle(time)) else {
            half_way(time, (&at, &obstacle), &mut |time, from, to| {
                met(meeting(time, from, Some(to)));
            });
            before = None;
            continue;
        };
        if before == Some((there, blocked)) {
            // Both stand still: that was found already.
        } else if there == blocked {
            met(meeting(time, there, None));
        } else if before == Some((blocked, there)) {
            met(meeting(time - 1, blocked, Some(there)));
        }
        before = Some((there, blocked));
    }
}

/// Where something is at a time.
type CellAt<'a> = dyn Fn(usize) -> Option<Cell> + 'a;

/// An agent half way along a slow edge, which an obstacle crosses the other way in one of the
/// two steps.
fn half_way(
    time: usize,
    (at, obstacle): (&CellAt, &CellAt),
    met: &mut dyn FnMut(usize, Cell, Cell),
) {
    let Some(begin) = time.checked_sub(1) else {
        return;
    };
    let (Some(from), Some(to)) = (at(begin), at(time + 1)) else {
        return;
    };
    for step in [begin, time] {
        if obstacle(step) == Some(to) && obstacle(step + 1) == Some(from) {
            met(step, from, to);
        }
    }
}
