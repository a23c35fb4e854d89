//! Collisions of two agents, time by time, in a world that changes.
//!
//! A slow move is on its edge for two steps, a normal one for one; two that are
//! on one edge in one step and go opposite ways collide, at whatever speed each
//! of them began.

use std::collections::BTreeMap;

use super::super::findings::{Findings, Place};
use super::super::{Rule, Step, sentence};
use super::alone::steps_of;
use crate::Cell;
use crate::change::{History, Trajectory};

/// A move on an edge.
#[derive(Clone, Copy)]
struct Crossing {
    agent: usize,
    begin: u32,
    slow: bool,
}

/// The agents that go from a cell to its neighbour in a step.
type Crossings = BTreeMap<(u32, Cell, Cell), Vec<Crossing>>;

pub(super) fn find(
    history: &History,
    trajectories: &[(usize, Trajectory<'_>)],
    findings: &mut Findings<'_>,
) {
    find_vertices(history, trajectories, findings);
    find_swaps(history, trajectories, findings);
}

fn find_vertices(
    history: &History,
    trajectories: &[(usize, Trajectory<'_>)],
    findings: &mut Findings<'_>,
) {
    // The agents at a cell on their way, and the agents that rest there from one time to another.
    let mut at: BTreeMap<(u32, Cell), Vec<usize>> = BTreeMap::new();
    let mut resting: BTreeMap<Cell, Vec<(usize, u32, u32)>> = BTreeMap::new();
    for (index, trajectory) in trajectories {
        let from = trajectory.timeline.from;
        for (i, cell) in trajectory.path.iter().enumerate() {
            if let Some(cell) = *cell {
                at.entry((from + i as u32, cell)).or_default().push(*index);
            }
        }
        let after = from + trajectory.path.len() as u32;
        let until = match trajectory.timeline.until {
            Some(until) => until,
            None if history.keeps(trajectory.timeline) => u32::MAX,
            None => trajectory.end() + 1,
        };
        if let Some(last) = trajectory.path.last().copied().flatten()
            && after < until
        {
            resting
                .entry(last)
                .or_default()
                .push((*index, after, until));
        }
    }
    let name = |findings: &Findings<'_>, agent: usize| findings.name(agent).to_owned();
    for (&(time, cell), agents) in &at {
        for (k, &b) in agents.iter().enumerate() {
            for &a in agents.iter().take(k) {
                let message =
                    sentence::vertex(&name(findings, a), &name(findings, b), cell, time as usize);
                findings.push(
                    Rule::Vertex,
                    time as usize,
                    &[a, b],
                    Place::Cell(cell),
                    message,
                );
            }
            for &(rests, from, until) in resting.get(&cell).into_iter().flatten() {
                if rests != b && from <= time && time < until {
                    let (a, since) = (b, from as usize - 1);
                    let names = (name(findings, a), name(findings, rests));
                    let time = time as usize;
                    let message = sentence::resting(&names.0, &names.1, cell, time, since);
                    let pair = [a.min(rests), a.max(rests)];
                    findings.push(Rule::Vertex, time, &pair, Place::Cell(cell), message);
                }
            }
        }
    }
    // Of two that rest, the later one's last entry has met the other.
}

fn find_swaps(
    history: &History,
    trajectories: &[(usize, Trajectory<'_>)],
    findings: &mut Findings<'_>,
) {
    let mut crossings = Crossings::new();
    for (index, trajectory) in trajectories {
        let agent = *index;
        let mut add = |begin: u32, (from, to): (Cell, Cell), slow: bool| {
            for time in begin..=begin + u32::from(slow) {
                let crossing = Crossing { agent, begin, slow };
                crossings
                    .entry((time, from, to))
                    .or_default()
                    .push(crossing);
            }
        };
        for (begin, step) in steps_of(history, trajectory) {
            match step {
                Step::Move { from, to } => add(begin, (from, to), false),
                Step::SlowMove { from, to } => add(begin, (from, to), true),
                _ => {}
            }
        }
    }
    for (&(time, from, to), forth) in &crossings {
        if from > to {
            continue; // seen from the other end
        }
        let back = crossings.get(&(time, to, from));
        for &a in forth {
            for &b in back.into_iter().flatten() {
                // Once a pair: when the later of them begins.
                if a.begin.max(b.begin) == time {
                    push_swap(a, b, (from, to), time, findings);
                }
            }
        }
    }
}

/// Two agents, of which the first goes the edge as it is given.
fn push_swap(
    a: Crossing,
    b: Crossing,
    (from, to): (Cell, Cell),
    time: u32,
    findings: &mut Findings<'_>,
) {
    let (a, b, from, to) = if a.agent < b.agent {
        (a, b, from, to)
    } else {
        (b, a, to, from)
    };
    let (p, q) = (findings.name(a.agent), findings.name(b.agent));
    let (rule, message) = if a.slow && b.slow {
        let begins = ((p, a.begin as usize), (q, b.begin as usize));
        let message = sentence::slow_swap(begins.0, begins.1, (from, to));
        (Rule::SlowSwap, message)
    } else {
        let message = sentence::swap(p, q, from, to, time as usize);
        (Rule::Swap, message)
    };
    let place = Place::Edge(from, to);
    findings.push(rule, time as usize, &[a.agent, b.agent], place, message);
}
