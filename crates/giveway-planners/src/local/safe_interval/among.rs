//! One search by safe intervals under rules: when the agent may leave and enter vertices, and
//! where its walk may end.

use super::{Label, NO_PARENT, counters::Counters, intervals::SafeIntervals};
use crate::{
    local::{Query, timetable::Timetable},
    single::{Mask, Task},
    terrain::{Arc, Vertex},
};

/// The slot of labels at which a walk ends.
pub(super) const END: u32 = u32::MAX;

/// One search.
pub(super) struct Among<'a, 'p> {
    pub(super) table: &'a Timetable<'p>,
    pub(super) task: &'a Task,
    query: Query,
    pub(super) safe: SafeIntervals<'a, 'p>,
    pub(super) counters: Counters<'a>,
    /// Whether it stays where it arrives.
    pub(super) rests: bool,
    /// It does not arrive sooner.
    earliest: u32,
    /// The vertices at which it has to be before some times: others are somewhere then.
    due: Vec<(Vertex, u32)>,
}

/// When an agent may leave a vertex.
#[derive(Clone, Copy)]
pub(super) struct Departure {
    from: Vertex,
    first: u32,
    pub(super) last: u32,
    /// It has to be at the next vertex before this time.
    there_before: u32,
}

/// The entry into a vertex.
#[derive(Clone, Copy)]
pub(super) struct Entry {
    pub(super) time: u32,
    /// The number of the safe interval.
    pub(super) interval: u32,
    /// The end of the safe interval.
    pub(super) to: u32,
}

impl<'a, 'p> Among<'a, 'p> {
    /// A search; `None` where there is no walk.
    pub(super) fn new(table: &'a Timetable<'p>, query: Query) -> Option<Self> {
        let problem = table.problem;
        let task = problem.tasks.get(query.agent)?;
        let mut among = Self {
            table,
            task,
            query: Query {
                latest: query.latest.min(task.not_after()),
                ..query
            },
            safe: SafeIntervals::new(table, query.agent),
            counters: Counters::of(task, &problem.terrain)?,
            rests: problem.rests(query.agent),
            earliest: task.not_before,
            due: table.visits_due(query.agent),
        };
        among.earliest = among.earliest.max(among.counters.entry.unwrap_or(0));
        if let Some(goal) = task.goal.filter(|_| among.rests) {
            let &(from, to) = among.safe.of(goal).last()?;
            among.earliest = among.earliest.max(from);
            if to < u32::MAX {
                return None;
            }
        }
        Some(among)
    }

    pub(super) fn first_label(&mut self) -> Option<Label> {
        let first = self.task.first()?;
        let (slot, (from, _)) = self.safe.from(self.task.start, 0)?;
        let is_due = self.due.iter().any(|&(_, time)| time == 0);
        (from == 0 && !is_due).then_some(Label {
            v: self.task.start,
            slot: self.slot(self.task.start, 0, slot),
            mask: self.counters.first(first.mask)?,
            time: 0,
            parent: NO_PARENT,
            arc: None,
        })
    }

    /// The slot of a label, by its time and the number of the safe interval.
    pub(super) fn slot(&self, v: Vertex, time: u32, interval: u32) -> u32 {
        let each_time = self.counters.most_waits(v).is_some();
        if each_time { time } else { interval }
    }

    /// The time before which an agent that has come so far has to be somewhere.
    pub(super) fn due(&self, mask: Mask) -> u32 {
        let open = self
            .due
            .iter()
            .filter(|(v, _)| !self.task.has_been(mask, *v));
        open.map(|&(_, time)| time).min().unwrap_or(u32::MAX)
    }

    /// The last time at which it can still be at a vertex where it is since a time.
    fn leaves_by(&mut self, v: Vertex, since: u32) -> u32 {
        let safe = self.safe.from(v, since);
        let to = safe.map_or(since, |(_, (_, to))| to);
        match self.counters.most_waits(v) {
            Some(most) => to.min(since.saturating_add(most)),
            None => to,
        }
    }

    /// When the agent may leave the vertex of a label, where it is since a time and stands
    /// for some steps.
    pub(super) fn departure(&mut self, (label, since): (&Label, u32), stands: u32) -> Departure {
        let first = label.time.saturating_add(stands);
        Departure {
            from: label.v,
            first: first.max(self.task.earliest_move),
            last: self.leaves_by(label.v, since),
            there_before: self.due(label.mask),
        }
    }

    /// The first entry over an arc at a time or later.
    pub(super) fn entry(&mut self, departure: Departure, arc: Arc, after: u32) -> Option<Entry> {
        let steps = 1 + u32::from(arc.slow);
        let mut leaving = departure.first.max(after.saturating_sub(steps));
        loop {
            if leaving > departure.last {
                return None;
            }
            let time = leaving.checked_add(steps)?;
            if time > self.query.latest || time >= departure.there_before {
                return None;
            }
            let allowed = self.safe.allowed(arc, leaving)?;
            let allowed = if arc.slow {
                self.safe.transit_begin(departure.from, arc, allowed)?
            } else {
                allowed
            };
            if allowed > leaving {
                leaving = allowed;
                continue;
            }
            let (interval, (from, to)) = self.safe.from(arc.to, time)?;
            if from > time {
                leaving = from - steps;
            } else if self.table.is_swap(leaving, departure.from, arc) {
                leaving += 1;
            } else {
                return Some(Entry { time, interval, to });
            }
        }
    }

    /// The arrival of a walk that ends at a label, where the agent is since a time; `None`
    /// where none does.
    pub(super) fn end(&mut self, label: &Label, since: u32) -> Option<u32> {
        let Label { v, mask, time, .. } = *label;
        if !self.task.is_end(v, mask) {
            return None;
        }
        if label.slot == END {
            return Some(time);
        }
        let (_, (_, to)) = self.safe.from(v, time)?;
        let due = self.due(mask);
        if self.rests && to < u32::MAX || due < u32::MAX {
            return None;
        }
        let resting = self.task.not_resting.iter().filter(|(u, _)| *u == v);
        let resting = resting.map(|&(_, last)| last.saturating_add(1));
        let first = resting.fold(self.task.not_before, u32::max);
        let arrival = time.max(first);
        let waits = arrival > time;
        let may_wait = arrival <= self.leaves_by(v, since);
        let may_end = arrival <= self.query.latest
            && (!waits || may_wait && self.counters.entry.is_none())
            && self.counters.may_end(mask, v, (since, arrival));
        may_end.then_some(arrival)
    }

    /// The earliest arrival from a label, if that is early enough.
    pub(super) fn bound(&self, label: &Label) -> Option<u32> {
        let Label { v, mask, time, .. } = *label;
        if self.counters.is_too_late(mask, time) {
            return None;
        }
        let cost_to_go = &self.table.problem.cost_to_go[self.query.agent];
        let bound = time.saturating_add(cost_to_go.from(v, mask, 0)?);
        let bound = bound
            .max(self.earliest)
            .max(self.counters.least_arrival(mask));
        (bound <= self.query.latest).then_some(bound)
    }
}
