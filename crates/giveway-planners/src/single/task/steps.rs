//! What an agent may do at a time, and what it pays for it.

use super::{Bounds, Mask, Penalty, Task};
use crate::{
    rules::touched,
    single::{Passage, Place},
    terrain::{Arc, Terrain, Vertex},
};

impl Task {
    /// The last time at which what it may do differs from later ones.
    pub fn last_time(&self) -> Option<u32> {
        let held = (self.earliest_move > 0).then_some(self.earliest_move);
        let late = self.penalties.iter().map(|penalty| match penalty {
            Penalty::Late { by, .. } => (*by > 0).then_some(*by),
            Penalty::Avoid(..) => None,
            Penalty::GoingOn(_) => Some(0),
        });
        let late = late.max().flatten();
        self.conditions.last_time().max(held).max(late)
    }

    /// The penalty of being at a place at a time before its arrival.
    pub fn penalty_at(&self, terrain: &Terrain, place: Place, now: u32) -> u32 {
        let each = self.penalties.iter().map(|penalty| match penalty {
            Penalty::Avoid(area, weight) => {
                let is_inside = touched(terrain, place).any(|v| area.has(v));
                if is_inside { *weight } else { 0 }
            }
            Penalty::Late { by, weight } if now >= *by => *weight,
            Penalty::GoingOn(cost) if now == 0 => *cost,
            Penalty::Late { .. } | Penalty::GoingOn(_) => 0,
        });
        each.fold(0, u32::saturating_add)
    }

    /// The penalty for the steps from a time up to an arrival, wherever they lead.
    pub fn penalty_of_time(&self, from: u32, arrival: u32) -> u32 {
        let each = self.penalties.iter().map(|penalty| match penalty {
            Penalty::Late { by, weight } => arrival
                .saturating_sub(from.max(*by))
                .saturating_mul(*weight),
            Penalty::GoingOn(cost) if from == 0 && arrival > 0 => *cost,
            Penalty::Avoid(..) | Penalty::GoingOn(_) => 0,
        });
        each.fold(0, u32::saturating_add)
    }

    /// All its weights.
    pub fn weights(&self) -> impl Iterator<Item = u32> + '_ {
        self.penalties.iter().map(|penalty| match penalty {
            Penalty::Avoid(_, weight) | Penalty::Late { weight, .. } | Penalty::GoingOn(weight) => {
                *weight
            }
        })
    }

    /// Its mask once it has begun to cross an arc; `None` where that is not its
    /// way.
    pub fn depart(&self, mask: Mask, arc: &Arc, now: Option<u32>) -> Option<Mask> {
        match self.along() {
            Some(path) => {
                let next = path.get(Self::set_of(mask) as usize + 1);
                (next == Some(&arc.to)).then_some(mask + 1)
            }
            None => Some(mask | self.crossed(arc.id, now)),
        }
    }

    /// A mask after a time step, by what is counted; `None` where the step is forbidden.
    pub fn counted(
        &self,
        terrain: &Terrain,
        mask: Mask,
        step: [Place; 2],
        now: u32,
    ) -> Option<Mask> {
        if self.conditions.counters.is_empty() {
            return Some(mask);
        }
        let [from, to] = step;
        let heading = match (from, to) {
            (Place::At(_), Place::Along(arc)) => terrain.heading(arc),
            (Place::At(u), Place::At(v)) => terrain.heading_between(u, v),
            (Place::Along(_), _) => None,
        };
        self.conditions.count(
            mask,
            Passage {
                from,
                to,
                heading,
                now,
            },
        )
    }

    /// The bits that beginning to cross an arc sets; none for most arcs.
    pub fn crossed(&self, arc: u32, now: Option<u32>) -> Mask {
        self.conditions.done_by(arc, now) << self.waypoints.len()
    }

    /// The bit of something that must be done, by its number.
    pub fn required_bit(&self, number: usize) -> Mask {
        1 << (self.waypoints.len() + number)
    }

    /// Whether it may be at a vertex, the waypoints of the mask visited.
    pub fn may_stand(&self, v: Vertex, mask: Mask, now: Option<u32>) -> bool {
        if let Bounds::Within(tunnel) = &self.bounds
            && tunnel.get(v as usize) != Some(&true)
        {
            return false;
        }
        self.conditions.may_stand(v, mask, now)
    }

    /// Whether it may begin to cross an arc.
    pub fn may_cross(&self, arc: u32, now: Option<u32>) -> bool {
        now.is_none_or(|now| now >= self.earliest_move) && self.conditions.may_cross(arc, now)
    }

    /// Whether it may charge at a vertex.
    pub fn may_charge(&self, terrain: &Terrain, v: Vertex, now: Option<u32>) -> bool {
        terrain.is_charger(v) && self.conditions.may_charge(v, now)
    }

    /// Whether what must be done before a time was done.
    pub fn is_on_time(&self, mask: Mask, now: u32) -> bool {
        let due = self.conditions.due(now) << self.waypoints.len();
        mask & due == due
    }

    /// Whether it is no more than to go from its start to its goal by way of its
    /// waypoints: without a battery, and nothing beside it asked for.
    pub fn is_plain(&self) -> bool {
        self.reserve.is_none()
            && self.conditions.is_empty()
            && self.penalties.is_empty()
            && self.transit.is_none()
            && matches!(self.bounds, Bounds::Free)
            && (self.earliest_move, self.not_before) == (0, 0)
    }

    /// The latest arrival that is allowed.
    pub fn not_after(&self) -> u32 {
        self.conditions.not_after()
    }
}
