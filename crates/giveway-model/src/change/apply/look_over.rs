//! Faults that show only once everything of a time has changed: two agents at one cell, obstacles on agents,
//! goals that are shared.

use std::collections::BTreeMap;

use super::{Reason, Whereabouts, World, refuse};
use crate::{Cell, sorting};

/// An agent that is at a cell, or half way into it.
#[derive(Clone, Copy)]
pub(in super::super) struct Taken<'a> {
    pub(in super::super) name: &'a str,
    pub(in super::super) is_entering: bool,
}

impl World<'_> {
    /// Finds the faults that show only once everything has changed.
    pub(super) fn look_over(&mut self) {
        let mut taken: BTreeMap<Cell, Taken> = BTreeMap::new();
        let mut reasons: Vec<(usize, Reason)> = Vec::new();
        let (after, at) = (&self.after, self.at);
        let there = |name: &str| {
            let mut timelines = after.timelines.iter();
            timelines.any(|timeline| timeline.name() == name && timeline.until.is_none())
        };
        for trajectory in &self.trajectories {
            let name = trajectory.timeline.name();
            match trajectory.place(at) {
                Whereabouts::At(cell) if there(name) => {
                    let is_entering = false;
                    taken.insert(cell, Taken { name, is_entering });
                }
                Whereabouts::Transit { to: cell, .. } if there(name) => {
                    let is_entering = true;
                    taken.entry(cell).or_insert(Taken { name, is_entering });
                }
                _ => {}
            }
        }
        for (index, name, cell) in &self.placed {
            let placed = Taken {
                name,
                is_entering: false,
            };
            if let Some(other) = taken.insert(*cell, placed) {
                reasons.push((*index, refuse::occupied(name, *cell, other, at)));
            }
        }
        for (&cell, &index) in &self.obstacles {
            if let Some(&other) = taken.get(&cell) {
                reasons.push((index, refuse::obstacle_on(cell, other, at)));
            }
        }
        for &(index, cell) in &self.aimed {
            // An obstacle of the same time is one on somebody's goal.
            if !self.grid.is_vertex(cell) && !self.obstacles.contains_key(&cell) {
                reasons.push((index, refuse::in_obstacle(cell)));
            }
        }
        if after.stays() {
            let mut goals: BTreeMap<Cell, &str> = BTreeMap::new();
            let timelines = after.timelines.iter();
            for timeline in timelines.filter(|timeline| timeline.until.is_none()) {
                let Some(goal) = timeline.goal() else {
                    continue;
                };
                if let Some(other) = goals.insert(goal, timeline.name()) {
                    let changed = self.aimed.iter().rev();
                    let index = changed
                        .filter(|(_, cell)| *cell == goal)
                        .map(|&(index, _)| index)
                        .next();
                    let reason = refuse::shared_goal(goal, other, timeline.name());
                    reasons.push((index.unwrap_or(0), reason));
                }
            }
        }
        sorting::sort_by_key(&mut reasons, |(index, _)| *index);
        for (index, reason) in reasons {
            self.refuse(index, reason);
        }
    }
}
