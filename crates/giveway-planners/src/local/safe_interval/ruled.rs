//! Safe intervals under rules of a scene's own.
//!
//! As without rules, but that the intervals also leave out what rules forbid
//! ([`SafeIntervals`]), that masks count ([`Counters`]), and that where a wait is limited an
//! earlier arrival is no better than a later one: there each time has a label of its own.

use super::{Label, NO_PARENT, Sipp, counters::Counters, intervals::SafeIntervals};
use crate::{
    budget::{Budget, Stop},
    local::{Query, timetable::Timetable},
    single::{Mask, Task},
    terrain::{Arc, Vertex},
    walk::Walk,
};

/// The slot of labels at which a walk ends.
const END: u32 = u32::MAX;

/// One search.
struct Among<'a, 'p> {
    table: &'a Timetable<'p>,
    task: &'a Task,
    query: Query,
    safe: SafeIntervals<'a, 'p>,
    counters: Counters<'a>,
    /// Whether it stays where it arrives.
    rests: bool,
    /// It does not arrive sooner.
    earliest: u32,
    /// The vertices at which it has to be before some times: others are somewhere then.
    due: Vec<(Vertex, u32)>,
}

/// When an agent may leave a vertex.
#[derive(Clone, Copy)]
struct Departure {
    from: Vertex,
    first: u32,
    last: u32,
    /// It has to be at the next vertex before this time.
    there_before: u32,
}

/// The entry into a vertex.
#[derive(Clone, Copy)]
struct Entry {
    time: u32,
    /// The number of the safe interval.
    interval: u32,
    /// The end of the safe interval.
    to: u32,
}

/// Whether safe intervals tell all about a task under rules.
pub(in crate::local) fn is_told(table: &Timetable, query: Query) -> bool {
    let problem = table.problem;
    Counters::of(&problem.tasks[query.agent], &problem.terrain).is_some()
}

impl Sipp {
    /// The earliest walk of an agent among others, without collisions and by all rules;
    /// `None` where there is none by the latest time, or none was found with the effort.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(in crate::local) fn ruled(
        &mut self,
        table: &Timetable,
        query: Query,
        budget: &dyn Budget,
    ) -> Result<Option<Walk>, Stop> {
        let Some(mut among) = Among::new(table, query) else {
            return Ok(None);
        };
        let first = among.first_label();
        let first = first.and_then(|label| Some((among.bound(&label)?, label)));
        let Some((bound, first)) = first else {
            return Ok(None);
        };
        self.clear(table.problem.terrain.size(), bound);
        self.push(bound, first);
        let mut expansions = query.expansion_limit;
        while let Some((id, label)) = self.pop() {
            budget.tick()?;
            if self.is_outdone(&label) {
                continue;
            }
            let since = self.since(&label);
            match among.end(&label, since) {
                Some(arrival) if arrival == label.time => return Ok(Some(self.walk_to(id))),
                Some(time) => {
                    let end = Label {
                        slot: END,
                        time,
                        parent: id,
                        arc: None,
                        ..label
                    };
                    self.push_first(time, end);
                }
                None => {}
            }
            if expansions == 0 {
                return Ok(None);
            }
            expansions -= 1;
            self.expand_under_rules(&mut among, id, &label);
        }
        Ok(None)
    }

    /// The time since which the agent is at the vertex of a label.
    fn since(&self, label: &Label) -> u32 {
        match self.labels.get(label.parent as usize) {
            Some(parent) if label.arc.is_none() => parent.time,
            _ => label.time,
        }
    }

    /// Pushes a label unless there is one as early; whether it did.
    fn push_first(&mut self, bound: u32, label: Label) -> bool {
        let known = self.earliest(label.v, label.slot, label.mask);
        let is_first = known.is_none_or(|known| known > label.time);
        if is_first {
            self.push(bound, label);
        }
        is_first
    }

    fn expand_under_rules(&mut self, among: &mut Among, id: u32, label: &Label) {
        if label.slot == END {
            return;
        }
        let since = self.since(label);
        if since == label.time {
            self.stay(among, id, label);
        }
        // Where each time has a label of its own, the next one follows this one.
        if let (Some(arc), Some(parent)) = (label.arc, self.labels.get(label.parent as usize))
            && among.counters.most_waits(label.v).is_some()
        {
            let parent = (label.parent, *parent);
            self.cross(among, parent, arc, label.time + 1);
        }
        for &arc in among.table.problem.terrain.arcs(label.v) {
            self.cross(among, (id, *label), arc, 0);
            if among.counters.entry.is_some() {
                self.enter_goal(among, (id, *label), arc);
            }
        }
    }

    /// Pushes the labels of the stays that are made at the vertex of a label.
    fn stay(&mut self, among: &mut Among, id: u32, label: &Label) {
        let stays = among.counters.stays_at(label.mask, label.v, label.time);
        if stays.is_empty() {
            return;
        }
        let departure = among.departure((label, label.time), 0);
        for (time, mask) in stays {
            // Who has to be somewhere else before a time is there a step after leaving.
            let is_due = time >= among.due(label.mask);
            if time > departure.last || is_due {
                break;
            }
            let made = Label {
                mask,
                time,
                slot: among.slot(label.v, time, label.slot),
                parent: id,
                arc: None,
                ..*label
            };
            if let Some(bound) = among.bound(&made) {
                self.push_first(bound, made);
            }
        }
    }

    /// Pushes the labels to which an arc leads from a label, at a time or later.
    fn cross(&mut self, among: &mut Among, (id, label): (u32, Label), arc: Arc, after: u32) {
        let Some((mask, stands)) = among.counters.moved(label.mask, label.v, arc) else {
            return;
        };
        let departure = among.departure((&label, self.since(&label)), stands);
        let each_time = among.counters.most_waits(arc.to).is_some();
        let mut after = after;
        while let Some(entry) = among.entry(departure, arc, after) {
            let time = entry.time;
            let there = Label {
                v: arc.to,
                slot: among.slot(arc.to, time, entry.interval),
                mask: among.counters.arrived(mask, arc.to, time),
                time,
                parent: id,
                arc: Some(arc),
            };
            let Some(bound) = among.bound(&there) else {
                break; // it would only be later in later intervals
            };
            let is_first = self.push_first(bound, there);
            let next = if each_time { time } else { entry.to };
            match next.checked_add(1) {
                Some(next) if !(each_time && is_first) => after = next,
                _ => break,
            }
        }
    }

    /// Pushes the label at which a walk ends that has to end by entering its goal.
    fn enter_goal(&mut self, among: &mut Among, (id, label): (u32, Label), arc: Arc) {
        let Some((mask, stands)) = among.counters.moved(label.mask, label.v, arc) else {
            return;
        };
        let Some((mask, first)) = among.counters.entering(mask) else {
            return;
        };
        if !among.task.is_end(arc.to, mask) {
            return;
        }
        let first = if among.rests {
            let last = among.safe.of(arc.to).last();
            first.max(last.map_or(u32::MAX, |&(from, _)| from))
        } else {
            first
        };
        let departure = among.departure((&label, self.since(&label)), stands);
        let Some(entry) = among.entry(departure, arc, first) else {
            return;
        };
        let time = entry.time;
        let there = Label {
            v: arc.to,
            slot: entry.interval,
            mask: among.counters.arrived(mask, arc.to, time),
            time,
            parent: id,
            arc: Some(arc),
        };
        if among.end(&there, time) == Some(time)
            && let Some(bound) = among.bound(&there)
        {
            self.push_first(bound, Label { slot: END, ..there });
        }
    }
}

impl<'a, 'p> Among<'a, 'p> {
    /// A search; `None` where there is no walk.
    fn new(table: &'a Timetable<'p>, query: Query) -> Option<Self> {
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

    fn first_label(&mut self) -> Option<Label> {
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
    fn slot(&self, v: Vertex, time: u32, interval: u32) -> u32 {
        let each_time = self.counters.most_waits(v).is_some();
        if each_time { time } else { interval }
    }

    /// The time before which an agent that has come so far has to be somewhere.
    fn due(&self, mask: Mask) -> u32 {
        let open = self.due.iter().filter(|(v, _)| !self.task.has_been(mask, *v));
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
    fn departure(&mut self, (label, since): (&Label, u32), stands: u32) -> Departure {
        let first = label.time.saturating_add(stands);
        Departure {
            from: label.v,
            first: first.max(self.task.earliest_move),
            last: self.leaves_by(label.v, since),
            there_before: self.due(label.mask),
        }
    }

    /// The first entry over an arc at a time or later.
    fn entry(&mut self, departure: Departure, arc: Arc, after: u32) -> Option<Entry> {
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
                self.safe.into_transit(departure.from, arc, allowed)?
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
    fn end(&mut self, label: &Label, since: u32) -> Option<u32> {
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
    fn bound(&self, label: &Label) -> Option<u32> {
        let Label { v, mask, time, .. } = *label;
        if self.counters.is_too_late(mask, time) {
            return None;
        }
        let cost_to_go = &self.table.problem.cost_to_go[self.query.agent];
        let bound = time.saturating_add(cost_to_go.from(v, mask, 0)?);
        let bound = bound.max(self.earliest).max(self.counters.least_arrival(mask));
        (bound <= self.query.latest).then_some(bound)
    }
}
