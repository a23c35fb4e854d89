//! Collisions of two agents, time step by time step.

use super::findings::{Findings, Place};
use super::occupancy::Occupancy;
use super::steps::{Step, step};
use super::walk::Walk;
use super::{Rule, sentence};
use crate::{Cell, Instance};

/// Finds every collision, by time.
///
/// An agent at a vertex is only compared with those at the same vertex, and one
/// that moves with those at its other end: at the same time, or for a slow edge
/// one step before.
pub(super) fn find(instance: &Instance, walks: &[Walk<'_>], findings: &mut Findings<'_>) {
    let grid = instance.grid();
    let mut sweep = Sweep {
        instance,
        walks,
        now: Occupancy::new(grid),
        before: Occupancy::new(grid),
        resting: Occupancy::new(grid),
    };
    let mut active: Vec<usize> = (0..walks.len()).collect();
    let mut time = 0;
    while !active.is_empty() && !findings.is_full() {
        std::mem::swap(&mut sweep.now, &mut sweep.before);
        sweep.now.clear();
        sweep.stand(&active, time, findings);
        if time == 0 {
            sweep.meet_in_transit(findings);
        }
        sweep.cross(&active, time, findings);
        sweep.rest(&mut active, time);
        time += 1;
    }
}

/// The agents around one time; agents are numbers of walks.
struct Sweep<'a> {
    instance: &'a Instance,
    walks: &'a [Walk<'a>],
    /// The agents at each vertex now, but for those that arrived earlier.
    now: Occupancy<'a>,
    /// The agents at each vertex one step before, but for those that arrived earlier.
    before: Occupancy<'a>,
    /// The agents that arrived earlier and stay.
    resting: Occupancy<'a>,
}

impl Sweep<'_> {
    /// Puts the agents at their vertices of this time, and finds vertex
    /// collisions. Two that both arrived earlier have been found already.
    fn stand(&mut self, active: &[usize], time: usize, findings: &mut Findings<'_>) {
        for &a in active {
            let Some(cell) = self.walk(a).and_then(|walk| walk.at(time)) else {
                continue;
            };
            let place = Place::Cell(cell);
            for b in self.now.at(cell) {
                let message = sentence::vertex(self.name(b), self.name(a), cell, time);
                findings.push(Rule::Vertex, time, &self.pair(b, a), place, message);
            }
            for b in self.resting.at(cell) {
                let since = self.walk(b).map_or(0, Walk::arrival);
                let message = sentence::resting(self.name(a), self.name(b), cell, time, since);
                findings.push(Rule::Vertex, time, &self.pair(a, b), place, message);
            }
            self.now.put(a, cell);
        }
    }

    /// Finds the agents that begin to cross an edge on which another is half way at
    /// time 0, in the opposite direction.
    fn meet_in_transit(&self, findings: &mut Findings<'_>) {
        for (a, walk) in self.walks.iter().enumerate() {
            let Some(from) = self.instance.start_state(self.name(a)).transit_from else {
                continue;
            };
            let to = walk.agent.start;
            let back = [
                Step::Move { from: to, to: from },
                Step::SlowMove { from: to, to: from },
            ];
            for b in self.now.at(to) {
                if self.step(b, 0).is_some_and(|step| back.contains(&step)) {
                    let message = sentence::swap(self.name(a), self.name(b), from, to, 0);
                    let place = Place::Edge(from, to);
                    findings.push(Rule::Swap, 0, &self.pair(a, b), place, message);
                }
            }
        }
    }

    /// Finds the agents that cross one edge in opposite directions.
    fn cross(&self, active: &[usize], time: usize, findings: &mut Findings<'_>) {
        for &a in active {
            match self.step(a, time) {
                Some(Step::Move { from, to }) => {
                    let back = Step::Move { from: to, to: from };
                    for b in self.now.at(to) {
                        if a < b && self.step(b, time) == Some(back) {
                            let (p, q) = (self.name(a), self.name(b));
                            let message = sentence::swap(p, q, from, to, time);
                            let place = Place::Edge(from, to);
                            findings.push(Rule::Swap, time, &self.pair(a, b), place, message);
                        }
                    }
                }
                Some(Step::SlowMove { from, to }) => {
                    let back = Step::SlowMove { from: to, to: from };
                    for b in self.now.at(to) {
                        if a < b && self.step(b, time) == Some(back) {
                            self.push_slow_swap((a, time), (b, time), (from, to), findings);
                        }
                    }
                    let Some(earlier) = time.checked_sub(1) else {
                        continue;
                    };
                    for b in self.before.at(to) {
                        if self.step(b, earlier) == Some(back) {
                            self.push_slow_swap((b, earlier), (a, time), (to, from), findings);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// Notes a slow swap of two agents, each with the time at which it leaves;
    /// the first to leave goes `from` - `to`.
    fn push_slow_swap(
        &self,
        first: (usize, usize),
        second: (usize, usize),
        (from, to): (Cell, Cell),
        findings: &mut Findings<'_>,
    ) {
        let later = first.1.max(second.1);
        // The agent with the lower number comes first, and the edge is named as it goes.
        let (p, q, from, to) = if first.0 < second.0 {
            (first, second, from, to)
        } else {
            (second, first, to, from)
        };
        let message = sentence::slow_swap((self.name(p.0), p.1), (self.name(q.0), q.1), (from, to));
        let place = Place::Edge(from, to);
        findings.push(Rule::SlowSwap, later, &self.pair(p.0, q.0), place, message);
    }

    /// Takes those that arrive now from the active ones; where agents stay,
    /// they block their cells from the next time on.
    fn rest(&mut self, active: &mut Vec<usize>, time: usize) {
        let walks = self.walks;
        let arrives = |a: usize| walks.get(a).is_none_or(|walk| walk.arrival() <= time);
        for &a in active.iter().filter(|&&a| arrives(a)) {
            if let Some(walk) = walks.get(a)
                && self.instance.keeps(walk.agent)
                && let Some(cell) = walk.end()
            {
                self.resting.put(a, cell);
            }
        }
        active.retain(|&a| !arrives(a));
    }

    /// The step that an agent begins at a time, if it stands at a vertex then.
    fn step(&self, a: usize, time: usize) -> Option<Step> {
        let walk = self.walk(a)?;
        let from = walk.at(time)?;
        let grid = self.instance.grid();
        match walk.at(time + 1) {
            Some(to) => Some(step(grid, from, to, 1)),
            None => Some(step(grid, from, walk.at(time + 2)?, 2)),
        }
    }

    fn walk(&self, a: usize) -> Option<&Walk<'_>> {
        self.walks.get(a)
    }

    fn name(&self, a: usize) -> &str {
        self.walk(a).map_or("", |walk| walk.agent.name.as_str())
    }

    /// Two agents as indices of the instance, in its order.
    fn pair(&self, a: usize, b: usize) -> [usize; 2] {
        let index = |a| self.walk(a).map_or(usize::MAX, |walk| walk.index);
        let (a, b) = (index(a), index(b));
        [a.min(b), a.max(b)]
    }
}
