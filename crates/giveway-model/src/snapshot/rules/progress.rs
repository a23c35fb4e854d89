//! What agents have done before the time of a snapshot, as rules see it.

use super::{RestOfRules, Resumed};
use crate::Cell;
use crate::change::{Trajectory, Whereabouts};
use crate::condition::Times;
use crate::constraint::{Heading, meant};

impl RestOfRules<'_> {
    /// Whether an agent was at a cell.
    pub(super) fn has_been(&self, cell: Cell, past: &Trajectory<'_>) -> bool {
        let mut times = past.timeline.from..self.at;
        times.any(|time| past.at(time) == Some(cell))
    }

    /// The cells of a sequence that an agent has still to be at.
    pub(super) fn left_of<'c>(&self, cells: &'c [Cell], past: &Trajectory<'_>) -> &'c [Cell] {
        let mut left = cells;
        for time in past.timeline.from..self.at {
            while let [next, rest @ ..] = left
                && past.at(time) == Some(*next)
            {
                left = rest;
            }
        }
        left
    }

    /// For how many times on end an agent has just been at a cell, within some times; `None`
    /// where it has stayed there long enough already.
    pub(super) fn stayed(
        &self,
        cell: Cell,
        stay: u32,
        times: Times,
        past: &Trajectory<'_>,
    ) -> Option<u32> {
        let times = meant(times);
        let mut run = 0;
        for time in past.timeline.from..self.at {
            let is_there = times.contains(time) && past.at(time) == Some(cell);
            run = if is_there { run + 1 } else { 0 };
            if run > stay {
                return None;
            }
        }
        Some(run)
    }

    /// When the last move of an agent ends, and its direction.
    pub(super) fn last_move(&self, past: &Trajectory<'_>) -> Option<(u32, Option<Heading>)> {
        let mut cells = (past.timeline.from..self.at).rev();
        if let Whereabouts::Transit { from, to } = past.place(self.at) {
            return Some((self.at, Heading::of(from, to)));
        }
        let here = past.at(self.at)?;
        let last = cells.find(|&time| past.at(time) != Some(here))?;
        let from = match past.place(last) {
            Whereabouts::At(cell) => cell,
            Whereabouts::Transit { from, .. } => from,
            Whereabouts::Absent => return None,
        };
        Some((last + 1, Heading::of(from, here)))
    }

    pub(super) fn zone_has(&self, zone: &str, cell: Cell) -> bool {
        let mut zones = self.history.zones().iter();
        zones.any(|it| it.name == zone && it.has(cell))
    }

    /// When an agent has broken down, up to the time of the snapshot; in transit, that is
    /// when the change came.
    pub(super) fn breakdowns(&self, resumed: &Resumed<'_>) -> Vec<u32> {
        let held = resumed.timeline.held.iter();
        let held = held.filter(|(from, to)| from < to);
        let begins = held.map(|&(from, _)| match from.checked_sub(1) {
            Some(before) if self.is_in_transit(resumed, before) => before,
            _ => from,
        });
        begins.filter(|&begin| begin <= self.at).collect()
    }

    fn is_in_transit(&self, resumed: &Resumed<'_>, time: u32) -> bool {
        let place = resumed.past.as_ref().map(|past| past.place(time));
        time <= self.at && matches!(place, Some(Whereabouts::Transit { .. }))
    }

    /// Whether an agent was in a zone at a time, and has not left it up to the time of the
    /// snapshot.
    pub(super) fn is_kept_in(&self, zone: &str, begin: u32, resumed: &Resumed<'_>) -> bool {
        let is_in = |time: u32| {
            let place = match &resumed.past {
                Some(past) => past.place(time),
                None if time == self.at => Whereabouts::At(resumed.agent.start),
                None => Whereabouts::Absent,
            };
            match place {
                Whereabouts::At(cell) => self.zone_has(zone, cell),
                Whereabouts::Transit { from, to } => {
                    self.zone_has(zone, from) || self.zone_has(zone, to)
                }
                Whereabouts::Absent => false,
            }
        };
        begin <= self.at && (begin..=self.at).all(is_in)
    }
}
