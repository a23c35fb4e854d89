//! What counters remember of where an agent starts: the goal at which it stands, and areas
//! that it has to leave before they count it.

use giveway_model::condition::Times;

use super::{Area, Place};
use crate::terrain::Vertex;

/// An arrival by entering, not before a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The time.
    pub from: u32,
    /// Whether it stands where it starts since before time 0.
    pub stood: bool,
    /// Whether it may stay where it starts: it arrived before time 0.
    pub may_stay: bool,
}

/// An area in which a rule of a scene's own does not count an agent until it has left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// The number of the rule.
    pub rule: usize,
    /// The area.
    pub area: Area,
    /// The slow arcs with an end in it, in ascending order.
    pub arcs: Vec<u32>,
    /// When it may not come back; `None` where others decide that.
    pub closed: Option<Times>,
    /// Whether the agent stays where it arrives.
    pub rests: bool,
}

impl Left {
    /// Whether a place is in the area.
    pub fn has(&self, place: Place) -> bool {
        match place {
            Place::At(v) => self.area.has(v),
            Place::Along(arc) => self.arcs.binary_search(&arc).is_ok(),
        }
    }

    pub(super) fn next(&self, has_left: u32, to: Place, now: u32) -> Option<u32> {
        let is_inside = self.has(to);
        let is_closed = self.closed.is_some_and(|times| times.contains(now));
        let is_allowed = has_left == 0 || !is_inside || !is_closed;
        is_allowed.then(|| has_left.max(u32::from(!is_inside)))
    }

    /// Whether it may rest at a vertex from a time on, the last one at which it is closed
    /// being past.
    pub(super) fn may_end(&self, has_left: u32, v: Vertex, now: u32) -> bool {
        let is_open = self.closed.is_none_or(|times| now > times.last());
        has_left == 0 || !self.rests || !self.area.has(v) || is_open
    }
}
