//! Agents that meet an obstacle which moves.
//!
//! An obstacle is at one cell at each time, and stays at its last one. No agent may be at
//! that cell then, or exchange cells with the obstacle in a step; half way along a slow edge
//! that is either of its two steps. Agents that arrived and stay are looked at as long as an
//! obstacle moves.

use super::findings::{Findings, Place};
use super::walk::Walk;
use super::{Rule, sentence};
use crate::change::{History, Trajectory};
use crate::{Assumption, Cell, Instance};

/// An agent that meets an obstacle which moves.
struct Meeting {
    /// The time; where the two exchange cells, the one at which that begins.
    time: usize,
    /// The cell of the agent: where both are, or the one that it exchanges for the other's.
    cell: Cell,
    /// The cell that the agent goes to, where the two exchange cells.
    to: Option<Cell>,
}

/// An agent as a moving obstacle meets it.
struct Body<'a> {
    index: usize,
    name: &'a str,
    at: &'a CellAt<'a>,
    arrival: usize,
    /// Whether it stays where it arrives.
    keeps: bool,
}

/// Finds every time at which an agent and a moving obstacle meet.
pub(super) fn find(instance: &Instance, walks: &[Walk<'_>], findings: &mut Findings<'_>) {
    for walk in walks {
        let keeps = instance.keeps(walk.agent);
        let at = |time: usize| {
            if time <= walk.arrival() {
                walk.at(time)
            } else {
                walk.end().filter(|_| keeps)
            }
        };
        let body = Body {
            index: walk.index,
            name: &walk.agent.name,
            at: &at,
            arrival: walk.arrival(),
            keeps,
        };
        body.find(instance.assumptions(), findings);
    }
}

/// The same where the world changes; obstacles that move do as they did before.
pub(super) fn find_over_time(
    history: &History,
    trajectories: &[(usize, Trajectory<'_>)],
    findings: &mut Findings<'_>,
) {
    if history.assumptions().is_empty() {
        return;
    }
    for (index, trajectory) in trajectories {
        let timeline = trajectory.timeline;
        let at = |time: usize| trajectory.at(u32::try_from(time).ok()?);
        let body = Body {
            index: *index,
            name: timeline.name(),
            at: &at,
            arrival: trajectory.end() as usize,
            keeps: timeline.until.is_none() && history.keeps(timeline),
        };
        body.find(history.assumptions(), findings);
    }
}

impl Body<'_> {
    fn find(&self, assumptions: &[Assumption], findings: &mut Findings<'_>) {
        for assumption in assumptions {
            let Assumption::MovingObstacle { name, path, closed } = assumption else {
                continue;
            };
            self.meet(path, &mut |Meeting { time, cell, to }| {
                let (place, message) = match to {
                    // A rule that closes its cell judges that.
                    None if *closed => return,
                    None => (
                        Place::Cell(cell),
                        sentence::moving(self.name, name, cell, time as u32),
                    ),
                    Some(to) => (
                        Place::Edge(cell, to),
                        sentence::moving_swap(self.name, name, (cell, to), time as u32),
                    ),
                };
                findings.push(Rule::Obstacle, time, &[self.index], place, message);
            });
        }
    }

    fn meet(&self, path: &[Cell], met: &mut dyn FnMut(Meeting)) {
        let meeting = |time: usize, cell, to| Meeting { time, cell, to };
        let obstacle = |time: usize| path.get(time).or(path.last()).copied();
        let last = if self.keeps {
            self.arrival.max(path.len())
        } else {
            self.arrival
        };
        let mut before = None;
        for time in 0..=last {
            let (Some(there), Some(blocked)) = ((self.at)(time), obstacle(time)) else {
                half_way(time, (self.at, &obstacle), &mut |time, from, to| {
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
