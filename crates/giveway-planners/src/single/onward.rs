//! The states of an agent on its way, and the steps that begin in one.

use super::{Place, Task, task::Mask};
use crate::terrain::{Terrain, Vertex};

/// The state of an agent on its way, with the best battery level that it may
/// have there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct State {
    /// Where it is.
    pub place: Place,
    /// The waypoints visited.
    pub mask: Mask,
    /// 0 where it is unlimited. Half way along a slow arc it is the level on
    /// arrival.
    pub battery: u32,
}

impl State {
    /// The vertex at which it is, or will be next, and the steps until then.
    pub(crate) fn next_vertex(&self, terrain: &Terrain) -> (Vertex, u32) {
        match self.place {
            Place::At(v) => (v, 0),
            Place::Along(arc) => (terrain.ends(arc).1, 1),
        }
    }
}

/// One time step of an agent.
#[derive(Clone, Copy, Debug)]
pub struct Onward {
    /// The state that it leads to.
    pub to: State,
    /// The arc that is crossed in this step.
    pub arc: Option<u32>,
}

impl Task {
    /// The steps that begin in a state at a time, charging or not. Charging is
    /// what gives the best levels.
    pub fn onward(
        &self,
        terrain: &Terrain,
        from: State,
        now: u32,
        charging: bool,
        mut take: impl FnMut(Onward),
    ) {
        let mut go = |place, mask, battery: Option<u32>, arc| {
            let Some(battery) = battery else { return };
            let Some(mask) = self.counted(terrain, mask, [from.place, place], now) else {
                return;
            };
            let stands = match place {
                Place::At(v) => self.may_stand(v, mask, Some(now + 1)),
                Place::Along(_) => true,
            };
            if stands && self.is_on_time(mask, now + 1) {
                let to = State {
                    place,
                    mask,
                    battery,
                };
                take(Onward { to, arc });
            }
        };
        match from.place {
            Place::Along(arc) => {
                let (_, v) = terrain.ends(arc);
                let mask = from.mask | self.bit(v);
                go(Place::At(v), mask, Some(from.battery), Some(arc));
            }
            Place::At(u) => {
                let charges = charging && self.may_charge(terrain, u, Some(now));
                let after = |steps| self.level_after(from.battery, steps, charges);
                go(Place::At(u), from.mask, after(1), None);
                for arc in terrain.arcs(u) {
                    if !self.may_cross(arc.id, Some(now)) {
                        continue;
                    }
                    let Some(mask) = self.depart(from.mask, arc, Some(now)) else {
                        continue;
                    };
                    if arc.slow {
                        go(Place::Along(arc.id), mask, after(2), Some(arc.id));
                    } else {
                        let mask = mask | self.bit(arc.to);
                        go(Place::At(arc.to), mask, after(1), Some(arc.id));
                    }
                }
            }
        }
    }

    /// The level after `steps` more steps, one or two, begun with a level,
    /// charging first or not; `None` where it would fall below the floor.
    fn level_after(&self, level: u32, steps: u32, charges: bool) -> Option<u32> {
        match self.reserve {
            None => Some(0),
            Some(reserve) if charges => (reserve.full + 1).checked_sub(steps),
            Some(_) => level.checked_sub(steps),
        }
    }
}
