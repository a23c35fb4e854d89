//! Safe intervals under rules of a scene's own.
//!
//! As without rules, but that the intervals also leave out what rules forbid
//! ([`SafeIntervals`](super::intervals::SafeIntervals)), that masks count ([`Counters`]), and that where a wait is limited an
//! earlier arrival is no better than a later one: there each time has a label of its own.

use super::{
    Label, Sipp,
    among::{Among, END},
    counters::Counters,
};
use crate::{
    budget::{Budget, Stop},
    local::{Query, timetable::Timetable},
    single::Task,
    terrain::{Arc, Terrain},
    walk::Walk,
};

/// Whether safe intervals tell all about a task, rules of a scene's own among it.
pub(in crate::local) fn is_told(task: &Task, terrain: &Terrain) -> bool {
    Counters::of(task, terrain).is_some()
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
