//! One agent among others that do not collide: safe-interval path planning.
//!
//! Phillips and Likhachev, "SIPP: Safe interval path planning for dynamic
//! environments" (2011): a state is a vertex in one of its safe intervals, and
//! only the earliest arrival in it counts, since whoever is there may wait to its
//! end. Waypoints are part of the state; a slow move takes two steps, in the middle
//! of which the agent is at no vertex.

use super::{OtherAgents, Query, timetable::Timetable};
use crate::{
    budget::{Budget, Stop},
    single::{Mask, Place, Task},
    terrain::{Arc, Vertex},
    walk::Walk,
};

/// The earliest arrival in an interval, by one way.
#[derive(Clone, Copy)]
struct Label {
    v: Vertex,
    /// The interval's number: that of the span after it.
    interval: u32,
    mask: Mask,
    time: u32,
    parent: u32,
    /// The arc that it came by.
    arc: Option<Arc>,
}

const NO_PARENT: u32 = u32::MAX;

/// The memory of a search, kept for the next one.
#[derive(Default)]
pub(super) struct Sipp {
    labels: Vec<Label>,
    /// Labels to expand, by the arrival that they promise, less that of the first.
    buckets: Vec<Vec<u32>>,
    /// The earliest times in the intervals of a vertex, in the order of interval and mask.
    seen: Vec<Vec<((u32, Mask), u32)>>,
    touched: Vec<Vertex>,
}

/// One search.
struct Among<'a, 'p> {
    table: &'a Timetable<'p>,
    task: &'a Task,
    query: Query,
    /// It does not arrive sooner: others pass its goal up to then.
    earliest: u32,
    /// The arrival that the first bucket stands for.
    base: u32,
}

impl Sipp {
    /// The earliest walk of a plain agent among others, without collisions;
    /// `None` where there is none by the latest time, or none was found with the
    /// effort.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn run(
        &mut self,
        table: &Timetable,
        query: Query,
        budget: &dyn Budget,
    ) -> Result<Option<Walk>, Stop> {
        let problem = table.problem;
        let task = &problem.tasks[query.agent];
        let passed = task.goal.and_then(|goal| table.last_visit(goal));
        let passed = passed.filter(|_| problem.rests(query.agent));
        let mut among = Among {
            table,
            task,
            query,
            earliest: passed.map_or(0, |time| time + 1),
            base: 0,
        };
        self.clear(problem.terrain.size());
        let (start, mask) = (task.start, task.first_mask());
        if table.who(0, start).is_some() {
            return Ok(None);
        }
        let Some(bound) = among.bound(start, mask, 0) else {
            return Ok(None);
        };
        among.base = bound;
        self.push(
            &among,
            bound,
            Label {
                v: start,
                interval: 0,
                mask,
                time: 0,
                parent: NO_PARENT,
                arc: None,
            },
        );
        let found = self.search(&among, budget)?;
        Ok(found.map(|id| self.walk_to(id)))
    }

    fn clear(&mut self, vertices: usize) {
        self.labels.clear();
        self.buckets.iter_mut().for_each(Vec::clear);
        for v in self.touched.drain(..) {
            self.seen[v as usize].clear();
        }
        self.seen.resize(vertices.max(self.seen.len()), Vec::new());
    }

    /// The number of the label at the end; labels of one promise are taken last in,
    /// first out.
    fn search(&mut self, among: &Among, budget: &dyn Budget) -> Result<Option<u32>, Stop> {
        let mut expansions = among.query.expansion_limit;
        let mut bucket = 0;
        while bucket < self.buckets.len() {
            let Some(id) = self.buckets[bucket].pop() else {
                bucket += 1;
                continue;
            };
            budget.tick()?;
            let label = self.labels[id as usize];
            if self.earliest(label.v, label.interval, label.mask) != Some(label.time) {
                continue; // somebody came sooner
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
                while time <= to.min(last) && among.is_swap(time - steps, label.v, arc) {
                    time += 1;
                }
                if time > to.min(last) {
                    continue;
                }
                let interval = interval as u32;
                if self
                    .earliest(arc.to, interval, mask)
                    .is_some_and(|known| known <= time)
                {
                    continue;
                }
                let Some(bound) = among.bound(arc.to, mask, time) else {
                    break; // it would only be later in later intervals
                };
                self.push(
                    among,
                    bound,
                    Label {
                        v: arc.to,
                        interval,
                        mask,
                        time,
                        parent: id,
                        arc: Some(arc),
                    },
                );
            }
        }
    }

    fn earliest(&self, v: Vertex, interval: u32, mask: Mask) -> Option<u32> {
        let seen = &self.seen[v as usize];
        let place = seen.binary_search_by_key(&(interval, mask), |&(key, _)| key);
        place.ok().map(|place| seen[place].1)
    }

    fn push(&mut self, among: &Among, bound: u32, label: Label) {
        let seen = &mut self.seen[label.v as usize];
        if seen.is_empty() {
            self.touched.push(label.v);
        }
        let key = (label.interval, label.mask);
        match seen.binary_search_by_key(&key, |&(key, _)| key) {
            Ok(place) => seen[place].1 = label.time,
            Err(place) => seen.insert(place, (key, label.time)),
        }
        let bucket = (bound - among.base) as usize;
        if self.buckets.len() <= bucket {
            self.buckets.resize(bucket + 1, Vec::new());
        }
        self.buckets[bucket].push(self.labels.len() as u32);
        self.labels.push(label);
    }

    fn walk_to(&self, mut id: u32) -> Walk {
        let mut walk = Walk::new();
        while id != NO_PARENT {
            let label = &self.labels[id as usize];
            walk.push(Place::At(label.v));
            if let (Some(arc), Some(parent)) = (label.arc, self.labels.get(label.parent as usize)) {
                if arc.slow {
                    walk.push(Place::Along(arc.id));
                }
                let waits = label.time - parent.time - 1 - u32::from(arc.slow);
                walk.extend((0..waits).map(|_| Place::At(parent.v)));
            }
            id = label.parent;
        }
        walk.reverse();
        walk
    }
}

impl Among<'_, '_> {
    /// The last time at which it can still be where a label is.
    fn leaves_by(&self, label: &Label) -> u32 {
        let spans = &self.table.spans[label.v as usize];
        let next = spans.get(label.interval as usize);
        next.map_or(u32::MAX, |span| span.from - 1)
    }

    /// Whether somebody comes the other way, if it leaves `u` at this time.
    fn is_swap(&self, leaving: u32, u: Vertex, arc: Arc) -> bool {
        let opposite = (arc.to, u);
        let against = |time| self.table.crosses(time, opposite, arc.slow).is_some();
        against(leaving) || arc.slow && against(leaving + 1)
    }

    /// Whether a label is an arrival for good.
    fn is_end(&self, label: &Label) -> bool {
        let stays = self.table.problem.rests(self.query.agent);
        self.task.is_end(label.v, label.mask) && (!stays || self.leaves_by(label) == u32::MAX)
    }

    /// The earliest arrival from a vertex, if that is early enough.
    fn bound(&self, v: Vertex, mask: Mask, time: u32) -> Option<u32> {
        let cost_to_go = &self.table.problem.cost_to_go[self.query.agent];
        let bound = (time + cost_to_go.from(v, mask, 0)?).max(self.earliest);
        (bound <= self.query.latest).then_some(bound)
    }
}
