//! One agent among others that do not collide: safe-interval path planning.
//!
//! Phillips and Likhachev, "SIPP: Safe interval path planning for dynamic
//! environments" (2011): a state is a vertex in one of its safe intervals, and
//! only the earliest arrival in it counts, since whoever is there may wait to its
//! end. [`plain`] is for agents that have only to reach their goals by way of
//! waypoints; [`ruled`] also keeps to rules of a scene's own.

mod among;
mod counters;
mod intervals;
mod plain;
mod ruled;

pub(super) use ruled::is_told;

use crate::{
    single::{Mask, Place},
    terrain::{Arc, Vertex},
    walk::Walk,
};

/// An arrival at a vertex, by one way.
#[derive(Clone, Copy)]
struct Label {
    v: Vertex,
    /// Of labels at one vertex with one slot and mask only the earliest counts: the slot is the
    /// number of the safe interval, where all that can be done from a label can be done from
    /// an earlier one.
    slot: u32,
    mask: Mask,
    time: u32,
    parent: u32,
    /// The arc that it came by; `None` at the start, and where it waited for something.
    arc: Option<Arc>,
}

const NO_PARENT: u32 = u32::MAX;

/// The labels of a search; the memory is kept for the next one.
#[derive(Default)]
pub(super) struct Sipp {
    labels: Vec<Label>,
    /// Labels to expand, by the arrival that they promise, less `base`.
    buckets: Vec<Vec<u32>>,
    /// The arrival that the first bucket stands for.
    base: u32,
    /// The first bucket that may have labels.
    next: usize,
    /// The earliest times at a vertex, in the order of slot and mask.
    seen: Vec<Vec<((u32, Mask), u32)>>,
    touched: Vec<Vertex>,
}

impl Sipp {
    /// Forgets the last search.
    fn clear(&mut self, vertices: usize, base: u32) {
        self.labels.clear();
        self.buckets.iter_mut().for_each(Vec::clear);
        (self.base, self.next) = (base, 0);
        for v in self.touched.drain(..) {
            self.seen[v as usize].clear();
        }
        self.seen.resize(vertices.max(self.seen.len()), Vec::new());
    }

    /// The label to expand next, with its number; labels of one promise are taken last in, first
    /// out.
    #[inline]
    fn pop(&mut self) -> Option<(u32, Label)> {
        while let Some(bucket) = self.buckets.get_mut(self.next) {
            let Some(id) = bucket.pop() else {
                self.next += 1;
                continue;
            };
            return Some((id, self.labels[id as usize]));
        }
        None
    }

    /// Whether an earlier label took the place of one.
    #[inline]
    fn is_outdone(&self, label: &Label) -> bool {
        self.earliest(label.v, label.slot, label.mask) != Some(label.time)
    }

    fn earliest(&self, v: Vertex, slot: u32, mask: Mask) -> Option<u32> {
        let seen = &self.seen[v as usize];
        let place = seen.binary_search_by_key(&(slot, mask), |&(key, _)| key);
        place.ok().map(|place| seen[place].1)
    }

    fn push(&mut self, bound: u32, label: Label) {
        let seen = &mut self.seen[label.v as usize];
        if seen.is_empty() {
            self.touched.push(label.v);
        }
        let key = (label.slot, label.mask);
        match seen.binary_search_by_key(&key, |&(key, _)| key) {
            Ok(place) => seen[place].1 = label.time,
            Err(place) => seen.insert(place, (key, label.time)),
        }
        let bucket = (bound.saturating_sub(self.base) as usize).max(self.next);
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
            if let Some(parent) = self.labels.get(label.parent as usize) {
                let slow = label.arc.filter(|arc| arc.slow);
                if let Some(arc) = slow {
                    walk.push(Place::Along(arc.id));
                }
                let waits = label.time - parent.time - 1 - u32::from(slow.is_some());
                walk.extend((0..waits).map(|_| Place::At(parent.v)));
            }
            id = label.parent;
        }
        walk.reverse();
        walk
    }
}
