//! The search backwards from the ends, state by state.

use giveway_model::constraint::Heading;

use super::{Label, Metric, stride};
use crate::{
    budget::{Budget, Stop},
    single::task::{Mask, Task},
    terrain::{Terrain, Vertex},
};

/// The search of a table.
pub(super) struct BackwardSearch<'a> {
    pub(super) task: &'a Task,
    pub(super) terrain: &'a Terrain,
    pub(super) metric: Metric,
    /// The directions that states tell apart.
    pub(super) headings: usize,
    /// The least need of a label settled so far, by state.
    pub(super) least_need: Vec<u32>,
    /// Labels to expand, by cost.
    pub(super) buckets: Vec<Vec<(Spot, u32)>>,
    pub(super) found: Vec<(u32, Label)>,
}

/// A vertex, the direction of the move by which it was entered, and a mask.
pub(super) type Spot = (Vertex, usize, Mask);

impl BackwardSearch<'_> {
    pub(super) fn run(&mut self, budget: &dyn Budget) -> Result<(), Stop> {
        for end in self.task.ends(self.terrain) {
            if self.task.may_stand(end, self.task.all(), None) {
                for heading in 0..self.headings {
                    self.push((end, heading, self.task.all()), 0, 0);
                }
            }
        }
        let mut cost = 0;
        while cost < self.buckets.len() {
            // First in, first out: among labels of one cost those with less
            // need come first, or nearly so, and few are settled twice.
            let mut next = 0;
            while let Some(&(spot, need)) = self.buckets[cost].get(next) {
                next += 1;
                budget.tick()?;
                let state = self.state(spot);
                if need < self.least_need[state] {
                    self.least_need[state] = need;
                    let cost = cost as u32;
                    self.found.push((state as u32, Label { cost, need }));
                    self.expand(spot, cost, need);
                }
            }
            self.buckets[cost] = Vec::new();
            cost += 1;
        }
        Ok(())
    }

    /// Pushes the states from which one move leads to a spot.
    fn expand(&mut self, (v, heading, mask): Spot, cost: u32, need: u32) {
        let terrain = self.terrain;
        if let Some(path) = self.task.along() {
            let before = mask.checked_sub(1);
            let u = before.and_then(|before| path.get(before as usize));
            let arc = terrain.arcs(v).iter().find(|arc| Some(&arc.to) == u);
            if let (Some(before), Some(arc)) = (before, arc)
                && self.task.may_cross(arc.id ^ 1, None)
                && self.task.may_stand(arc.to, before, None)
            {
                let cost = cost + self.metric.of_move(arc.slow);
                let before = (arc.to, heading, before);
                self.step_back(before, cost, need, 1 + u32::from(arc.slow));
            }
            return;
        }
        let bit = self.task.bit(v);
        for arc in terrain.arcs(v) {
            let u = arc.to;
            let forth = arc.id ^ 1;
            if !self.task.may_cross(forth, None) || !self.is_entered_by(forth, heading) {
                continue;
            }
            let cost = cost + self.metric.of_move(arc.slow);
            let steps = 1 + u32::from(arc.slow);
            let crossed = self.task.crossed(forth, None);
            if mask & crossed != crossed {
                continue; // whoever came that way has crossed the arc
            }
            // Each set of the bits may be new with this move.
            let bits = bit | crossed;
            let mut new: Mask = 0;
            loop {
                let before = mask & !new;
                // Being at u has visited u's own waypoint.
                let visited = before & self.task.bit(u) == self.task.bit(u);
                if visited && self.task.may_stand(u, before, None) {
                    for facing in 0..self.headings {
                        let cost = cost + self.turning(facing, heading);
                        self.step_back((u, facing, before), cost, need, steps);
                    }
                }
                if new == bits {
                    break;
                }
                new = new.wrapping_sub(bits) & bits;
            }
        }
    }

    /// Whether a move over an arc has a direction; any where states tell none apart.
    fn is_entered_by(&self, arc: u32, heading: usize) -> bool {
        self.headings == 1 || self.terrain.heading(arc).map(|it| it as usize) == Some(heading)
    }

    /// The steps of a turn from one direction to another.
    fn turning(&self, facing: usize, heading: usize) -> u32 {
        let direction = |number: usize| Heading::ALL.get(number);
        let turns = self.task.conditions.turns().filter(|_| self.headings > 1);
        let quarter = turns.map_or(0, |turns| turns.quarter);
        let both = direction(facing).zip(direction(heading));
        quarter.saturating_mul(both.map_or(0, |(from, to)| from.quarters_to(*to)))
    }

    fn step_back(&mut self, spot: Spot, cost: u32, need: u32, steps: u32) {
        let Some(reserve) = self.task.reserve else {
            self.push(spot, cost, 0);
            return;
        };
        if need + steps <= reserve.full {
            self.push(spot, cost, need + steps);
        }
        // A charge fills the battery for the next time step already.
        if self.task.may_charge(self.terrain, spot.0, None) && need + steps <= reserve.full + 1 {
            self.push(spot, cost + self.metric.of_charge(), 0);
        }
    }

    fn push(&mut self, spot: Spot, cost: u32, need: u32) {
        // Settled labels cost no more than this one, so less need must show.
        if need >= self.least_need[self.state(spot)] {
            return;
        }
        let bucket = cost as usize;
        if self.buckets.len() <= bucket {
            self.buckets.resize(bucket + 1, Vec::new());
        }
        self.buckets[bucket].push((spot, need));
    }

    fn state(&self, (v, heading, mask): Spot) -> usize {
        (v as usize * self.headings + heading) * stride(self.task) + mask as usize
    }
}
