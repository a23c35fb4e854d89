//! The safe intervals of one agent under rules: what others and rules leave of each vertex.
//!
//! Closed times, full zones, gaps and distances to others are spans of time at vertices; so is
//! that an agent must not be at a vertex before another has been at one. The intervals of
//! a vertex are made when a search comes to it.

use std::ops::Range;

use crate::{
    AgentId,
    local::timetable::Timetable,
    rules::{Shared, SharedKind, near},
    single::{Act, Task},
    terrain::{Arc, Vertex},
};

/// The times from one to another, both included.
pub(super) type Interval = (u32, u32);

/// The intervals of the vertices that a search came to.
pub(super) struct SafeIntervals<'a, 'p> {
    table: &'a Timetable<'p>,
    agent: AgentId,
    task: &'a Task,
    /// The rules between agents that bind this one, with their numbers.
    shared: Vec<(usize, &'p Shared)>,
    /// When zones are full, by the number of their rule; empty up to their first use.
    full: Vec<Option<Vec<Interval>>>,
    /// Where the intervals of each vertex are in `intervals`; `None` where they are not made.
    places: Vec<Option<Range<u32>>>,
    intervals: Vec<Interval>,
    scratch: Vec<Interval>,
}

impl<'a, 'p> SafeIntervals<'a, 'p> {
    /// Of an agent among others.
    pub(super) fn new(table: &'a Timetable<'p>, agent: AgentId) -> Self {
        let problem = table.problem;
        let rules = problem.between.rules.iter().enumerate();
        Self {
            table,
            agent,
            task: &problem.tasks[agent],
            shared: rules.filter(|(_, rule)| rule.binds(agent)).collect(),
            full: vec![None; problem.between.rules.len()],
            places: vec![None; problem.terrain.size()],
            intervals: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// The safe intervals of a vertex, in order.
    pub(super) fn of(&mut self, v: Vertex) -> &[Interval] {
        let place = match self.places.get(v as usize).cloned().flatten() {
            Some(place) => place,
            None => self.make(v),
        };
        let (begin, end) = (place.start as usize, place.end as usize);
        self.intervals.get(begin..end).unwrap_or_default()
    }

    /// The first safe interval of a vertex that ends at a time or later, and its number.
    pub(super) fn from(&mut self, v: Vertex, time: u32) -> Option<(u32, Interval)> {
        let all = self.of(v);
        let number = all.partition_point(|&(_, to)| to < time);
        all.get(number).map(|&it| (number as u32, it))
    }

    fn make(&mut self, v: Vertex) -> Range<u32> {
        let mut blocked = std::mem::take(&mut self.scratch);
        blocked.clear();
        let spans = self.table.spans.get(v as usize);
        for span in spans.into_iter().flatten() {
            let gap = self.gap_to(span.agent as AgentId);
            blocked.push((span.from.saturating_sub(gap), span.to.saturating_add(gap)));
        }
        for forbidden in &self.task.conditions.forbidden {
            match &forbidden.act {
                Act::Stand(area) if area.has(v) => {
                    blocked.push((forbidden.times.first(), forbidden.times.last()));
                }
                Act::Stand(_) | Act::Cross(_) | Act::Charge(_) => {}
            }
        }
        self.add_touched(v, &mut blocked);
        blocked.extend(self.table.before_first_visit(self.agent, v));
        blocked.sort_unstable();
        let begin = self.intervals.len() as u32;
        let mut free = Some(0);
        for &(from, to) in &blocked {
            let Some(begin) = free else { break };
            if begin < from {
                self.intervals.push((begin, from - 1));
            }
            free = to.checked_add(1).map(|next| next.max(begin));
        }
        self.intervals.extend(free.map(|begin| (begin, u32::MAX)));
        self.scratch = blocked;
        let place = begin..self.intervals.len() as u32;
        if let Some(known) = self.places.get_mut(v as usize) {
            *known = Some(place.clone());
        }
        place
    }

    /// The time steps that have to lie between this agent and another at one vertex.
    fn gap_to(&self, other: AgentId) -> u32 {
        let gaps = self.shared.iter().map(|(_, rule)| match rule.kind {
            SharedKind::Gap { steps } if rule.binds(other) => steps,
            SharedKind::Gap { .. } | SharedKind::Capacity { .. } | SharedKind::Apart { .. } => 0,
        });
        gaps.max().unwrap_or(0)
    }

    /// Adds the times at which the agent must not be at a vertex or in transit to or from it:
    /// zones are full, or others are too near.
    fn add_touched(&mut self, v: Vertex, blocked: &mut Vec<Interval>) {
        let table = self.table;
        for (number, rule) in &self.shared {
            match &rule.kind {
                SharedKind::Capacity { area, most, times } if area.has(v) => {
                    let Some(full) = self.full.get_mut(*number) else {
                        continue;
                    };
                    let full = full.get_or_insert_with(|| table.full(*number, *most, *times));
                    blocked.extend_from_slice(full);
                }
                SharedKind::Apart { distance, times } => {
                    for u in near(&table.problem.terrain, v, *distance) {
                        table.touching(u, |other, (from, to)| {
                            let (from, to) = (from.max(times.first()), to.min(times.last()));
                            if from <= to && rule.binds(other) {
                                blocked.push((from, to));
                            }
                        });
                    }
                }
                SharedKind::Capacity { .. } | SharedKind::Gap { .. } => {}
            }
        }
    }

    /// The first time from one on at which the agent may begin to cross a slow arc from a
    /// vertex, as far as zones and distances say.
    pub(super) fn transit_begin(&mut self, from: Vertex, arc: Arc, leaving: u32) -> Option<u32> {
        let mut blocked = std::mem::take(&mut self.scratch);
        blocked.clear();
        self.add_touched(from, &mut blocked);
        self.add_touched(arc.to, &mut blocked);
        blocked.sort_unstable();
        let mut amid = leaving.checked_add(1);
        for &(from, to) in &blocked {
            amid = match amid {
                Some(time) if from <= time && time <= to => to.checked_add(1),
                amid => amid,
            };
        }
        self.scratch = blocked;
        amid.map(|time| time - 1)
    }

    /// The first time from one on at which the agent may begin to cross an arc, as far as
    /// its own task says.
    pub(super) fn allowed(&self, arc: Arc, leaving: u32) -> Option<u32> {
        let mut leaving = leaving;
        // Each of them moves the time on at most once, so this ends.
        loop {
            let closed = self.task.conditions.forbidden.iter().find(|forbidden| {
                forbidden.times.contains(leaving)
                    && match &forbidden.act {
                        Act::Cross(arcs) => arcs.binary_search(&arc.id).is_ok(),
                        Act::Stand(_) | Act::Charge(_) => false,
                    }
            });
            match closed {
                None => return Some(leaving),
                Some(forbidden) => leaving = forbidden.times.last().checked_add(1)?,
            }
        }
    }
}
