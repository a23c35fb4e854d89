//! An agent's task over the graph of the map.

use giveway_model::{Agent, Rules};

use crate::terrain::{Terrain, Vertex};

/// A set of visited waypoints, one bit each in the order of the agent's list.
pub(crate) type Mask = u32;

/// The largest number of waypoints that masks can hold, and that exact tables
/// over their subsets can bear.
pub(crate) const MAX_WAYPOINTS: usize = 20;

/// A battery, with the floor taken off: levels run from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Reserve {
    /// The level after a charge: capacity less floor.
    pub(crate) full: u32,
    /// The level at time 0: initial less floor.
    pub(crate) initial: u32,
}

/// What one agent has to do.
#[derive(Clone, Debug)]
pub(crate) struct Task {
    pub(crate) start: Vertex,
    pub(crate) goal: Vertex,
    /// The waypoints; the i-th has bit i.
    pub(crate) waypoints: Vec<Vertex>,
    /// `None` is unlimited.
    pub(crate) reserve: Option<Reserve>,
}

impl Task {
    /// The task of an agent; `None` where its battery begins below the floor
    /// or a cell is no vertex, so that no plan exists.
    pub(crate) fn new(agent: &Agent, rules: Rules, terrain: &Terrain) -> Option<Self> {
        let reserve = match agent.battery {
            None => None,
            Some(battery) => Some(Reserve {
                full: battery.capacity.checked_sub(rules.battery_floor)?,
                initial: battery.initial.checked_sub(rules.battery_floor)?,
            }),
        };
        let waypoints: Option<Vec<Vertex>> =
            agent.waypoints.iter().map(|&w| terrain.vertex(w)).collect();
        Some(Self {
            start: terrain.vertex(agent.start)?,
            goal: terrain.vertex(agent.goal)?,
            waypoints: waypoints?,
            reserve,
        })
    }

    /// The set of all waypoints.
    pub(crate) const fn all(&self) -> Mask {
        (1 << self.waypoints.len()) - 1
    }

    /// The number of sets of waypoints.
    pub(crate) const fn masks(&self) -> usize {
        1 << self.waypoints.len()
    }

    /// The waypoint at a vertex, as a set of one; empty elsewhere.
    pub(crate) fn bit(&self, v: Vertex) -> Mask {
        let found = self.waypoints.iter().position(|&w| w == v);
        found.map_or(0, |i| 1 << i)
    }

    /// The waypoints visited at time 0.
    pub(crate) fn first_mask(&self) -> Mask {
        self.bit(self.start)
    }

    /// The battery level at time 0; 0 where it is unlimited.
    pub(crate) fn first_level(&self) -> u32 {
        self.reserve.map_or(0, |r| r.initial)
    }

    /// Whether being at a vertex with these waypoints visited is arriving.
    pub(crate) const fn is_end(&self, v: Vertex, mask: Mask) -> bool {
        v == self.goal && mask == self.all()
    }

    /// The best level after `steps` more steps, one or two, begun at a vertex
    /// with a level, charging there if that is possible; `None` where the
    /// battery would fall below its floor.
    pub(crate) fn level_after(
        &self,
        terrain: &Terrain,
        from: Vertex,
        level: u32,
        steps: u32,
    ) -> Option<u32> {
        match self.reserve {
            None => Some(0),
            Some(reserve) if terrain.is_charger(from) => (reserve.full + 1).checked_sub(steps),
            Some(_) => level.checked_sub(steps),
        }
    }
}
