//! Safe intervals of a plain agent: between the spans of others, at vertices as they are.
//!
//! Waypoints are part of the state; a slow move takes two steps, in the middle
//! of which the agent is at no vertex.

use super::{Label, NO_PARENT, Sipp};
use crate::{
    budget::{Budget, Stop},
    local::{OtherAgents, Query, timetable::Timetable},
    single::{Mask, Task},
    terrain::Vertex,
    walk::Walk,
};

/// One search.
struct Among<'a, 'p> {
    table: &'a Timetable<'p>,
    task: &'a Task,
    query: Query,
    /// It does not arrive sooner: others pass its goal up to then.
    earliest: u32,
}

impl Sipp {
    /// The earliest walk of a plain agent among others, without collisions;
    /// `None` where there is none by the latest time, or none was found with the
    /// effort.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(in crate::local) fn plain(
        &mut self,
        table: &Timetable,
        query: Query,
        budget: &dyn Budget,
    ) -> Result<Option<Walk>, Stop> {
        let problem = table.problem;
        let task = &problem.tasks[query.agent];
        let passed = task.goal.and_then(|goal| table.last_visit(goal));
        let passed = passed.filter(|_| problem.rests(query.agent));
        let among = Among {
            table,
            task,
            query,
            earliest: passed.map_or(0, |time| time + 1),
        };
        let (start, mask) = (task.start, task.first_mask());
        if table.who(0, start).is_some() {
            return Ok(None);
        }
        let Some(bound) = among.bound(start, mask, 0) else {
            return Ok(None);
        };
        self.clear(problem.terrain.size(), bound);
        self.push(
            bound,
            Label {
                v: start,
                slot: 0,
                mask,
                time: 0,
                parent: NO_PARENT,
                arc: None,
            },
        );
        let found = self.search(&among, budget)?;
        Ok(found.map(|id| self.walk_to(id)))
    }

    /// The number of the label at the end.
    fn search(&mut self, among: &Among, budget: &dyn Budget) -> Result<Option<u32>, Stop> {
        let mut expansions = among.query.expansion_limit;
        while let Some((id, label)) = self.pop() {
            budget.tick()?;
            if self.is_outdone(&label) {
                continue;
            }
            if among.is_end(&label) {
                return Ok(Some(id));
            }
            if expansions == 0 {
                return Ok(None);
            }
            expansions -= 1;
            self.expand(among, id, &label);
        }
        Ok(None)
    }

    fn expand(&mut self, among: &Among, id: u32, label: &Label) {
        let spans = &among.table.spans;
        let last = among.leaves_by(label);
        for &arc in among.table.problem.terrain.arcs(label.v) {
            let steps = 1 + u32::from(arc.slow);
            let (first, last) = (label.time + steps, last.saturating_add(steps));
            let there = &spans[arc.to as usize];
            let mask = label.mask | among.task.bit(arc.to);
            // The first interval that ends no sooner than it can be there.
            let begin = there.partition_point(|span| span.from <= first);
            for interval in begin..=there.len() {
                let from = match interval.checked_sub(1) {
                    None => 0,
                    Some(before) if there[before].to == u32::MAX => break,
                    Some(before) => there[before].to + 1,
                };
                let to = there.get(interval).map_or(u32::MAX, |span| span.from - 1);
                let mut time = first.max(from);
                if time > last {
                    break;
                }
                while time <= to.min(last) && among.table.is_swap(time - steps, label.v, arc) {
                    time += 1;
                }
                if time > to.min(last) {
                    continue;
                }
                let slot = interval as u32;
                if self
                    .earliest(arc.to, slot, mask)
                    .is_some_and(|known| known <= time)
                {
                    continue;
                }
                let Some(bound) = among.bound(arc.to, mask, time) else {
                    break; // it would only be later in later intervals
                };
                self.push(
                    bound,
                    Label {
                        v: arc.to,
                        slot,
                        mask,
                        time,
                        parent: id,
                        arc: Some(arc),
                    },
                );
            }
        }
    }
}

impl Among<'_, '_> {
    /// The last time at which it can still be where a label is.
    #[inline]
    fn leaves_by(&self, label: &Label) -> u32 {
        let spans = &self.table.spans[label.v as usize];
        let next = spans.get(label.slot as usize);
        next.map_or(u32::MAX, |span| span.from - 1)
    }

    /// Whether a label is an arrival for good.
    #[inline]
    fn is_end(&self, label: &Label) -> bool {
        let stays = self.table.problem.rests(self.query.agent);
        self.task.is_end(label.v, label.mask) && (!stays || self.leaves_by(label) == u32::MAX)
    }

    /// The earliest arrival from a vertex, if that is early enough.
    #[inline]
    fn bound(&self, v: Vertex, mask: Mask, time: u32) -> Option<u32> {
        let cost_to_go = &self.table.problem.cost_to_go[self.query.agent];
        let bound = (time + cost_to_go.from(v, mask, 0)?).max(self.earliest);
        (bound <= self.query.latest).then_some(bound)
    }
}
