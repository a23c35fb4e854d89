//! An agent's task over the graph of the map.

use std::rc::Rc;

use giveway_model::{Agent, Battery, Rules};

use super::{Hopeless, Place, State, TaskConstraint, has_to_be_at};
use crate::terrain::{Arc, Terrain, Vertex};

/// A set of visited waypoints, one bit each in the order of the agent's list;
/// after them the bit of a demand that has one.
pub type Mask = u32;

/// The largest number of waypoints that masks can hold, and that exact tables
/// over their subsets can bear.
pub const MAX_WAYPOINTS: usize = 20;

/// A battery, with the floor taken off: levels run from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reserve {
    /// The level after a charge: capacity less floor.
    pub full: u32,
    /// The level at time 0: initial less floor.
    pub initial: u32,
}

/// Where an agent may go.
#[derive(Clone, Debug, Default)]
pub enum Bounds {
    /// Anywhere.
    #[default]
    Free,
    /// Only to the vertices marked here.
    Within(Rc<Vec<bool>>),
    /// Only along these vertices, one after the other, whenever it likes. Its
    /// mask is then no set, but how far it has come.
    Along(Rc<Vec<Vertex>>),
}

/// What one agent has to do.
#[derive(Clone, Debug)]
pub struct Task {
    /// Where it is at time 0, or will be first.
    pub start: Vertex,
    /// Where it has to arrive.
    pub goal: Vertex,
    /// The waypoints; the i-th has bit i.
    pub waypoints: Vec<Vertex>,
    /// `None` is unlimited.
    pub reserve: Option<Reserve>,
    /// What a question asks of it beside the task.
    pub demand: Option<TaskConstraint>,
    /// It must not have arrived before this time.
    pub not_before: u32,
    /// Where it may go.
    pub bounds: Bounds,
    /// At time 0 it is half way along this arc, whose end is `start`.
    pub transit: Option<u32>,
    /// It begins no move before this time; it may rest at its goal, though.
    pub held: u32,
    /// What it adds to the sum of costs not to arrive at time 0.
    pub woken: u32,
    /// The waits that it adds not to arrive at time 0: it stood at its goal and
    /// had not arrived.
    pub stood: u32,
}

impl Task {
    /// The task of an agent.
    ///
    /// # Errors
    /// Where its battery begins below the floor or a cell is no vertex, so that no
    /// plan exists.
    pub fn new(agent: &Agent, rules: Rules, terrain: &Terrain) -> Result<Self, Hopeless> {
        let reserve = match agent.battery {
            None => None,
            Some(Battery { capacity, initial }) => {
                Some(Reserve::above(rules.battery_floor, capacity, initial)?)
            }
        };
        let waypoints: Result<Vec<Vertex>, Hopeless> = agent
            .waypoints
            .iter()
            .map(|&cell| has_to_be_at(cell, terrain))
            .collect();
        Ok(Self {
            start: has_to_be_at(agent.start, terrain)?,
            goal: has_to_be_at(agent.goal, terrain)?,
            waypoints: waypoints?,
            reserve,
            demand: None,
            not_before: 0,
            bounds: Bounds::Free,
            transit: None,
            held: 0,
            woken: 0,
            stood: 0,
        })
    }

    /// The number of bits of a mask.
    fn bits(&self) -> usize {
        let demanded = self.demand.as_ref().is_some_and(TaskConstraint::has_bit);
        self.waypoints.len() + usize::from(demanded)
    }

    /// The vertices that it has to go along, where it has.
    pub fn along(&self) -> Option<&[Vertex]> {
        match &self.bounds {
            Bounds::Along(path) => Some(path),
            _ => None,
        }
    }

    /// The set of all waypoints.
    pub fn all(&self) -> Mask {
        (self.masks() - 1) as Mask
    }

    /// The number of sets of waypoints.
    pub fn masks(&self) -> usize {
        self.along()
            .map_or(1 << self.bits(), |path| path.len().max(1))
    }

    /// The number of battery levels.
    pub fn levels(&self) -> usize {
        self.reserve
            .map_or(1, |r| r.full.max(r.initial) as usize + 1)
    }

    /// The number of counts by which its demand tells one way from another.
    pub fn counted(&self) -> usize {
        match self.demand {
            Some(TaskConstraint::Wait { steps, .. }) => steps as usize + 1,
            Some(TaskConstraint::Charge { .. }) => 2,
            _ => 1,
        }
    }

    /// The waypoint at a vertex, as a set of one; empty elsewhere.
    pub fn bit(&self, v: Vertex) -> Mask {
        if self.along().is_some() {
            return 0;
        }
        let found = self.waypoints.iter().position(|&w| w == v);
        found.map_or(0, |i| 1 << i)
    }

    /// Makes a vertex a waypoint, where it is none; the set of it alone.
    pub fn visit(&mut self, v: Vertex) -> Mask {
        if self.bit(v) == 0 {
            self.waypoints.push(v);
        }
        self.bit(v)
    }

    /// The waypoints visited at time 0.
    pub fn first_mask(&self) -> Mask {
        self.bit(self.start)
    }

    /// The battery level at time 0; 0 where it is unlimited.
    pub fn first_level(&self) -> u32 {
        let delay = self.delay();
        self.reserve.map_or(0, |r| r.initial.saturating_sub(delay))
    }

    /// The steps until it is at a vertex for the first time.
    pub fn delay(&self) -> u32 {
        u32::from(self.transit.is_some())
    }

    /// Where it is at time 0.
    pub fn first_place(&self) -> Place {
        self.transit.map_or(Place::At(self.start), Place::Along)
    }

    /// The last time at which what it may do differs from later ones.
    pub fn last_time(&self) -> Option<u32> {
        let demanded = self.demand.as_ref().and_then(TaskConstraint::last_time);
        demanded.max((self.held > 0).then_some(self.held))
    }

    /// Its mask once it has begun to cross an arc; `None` where that is not its
    /// way.
    pub fn depart(&self, mask: Mask, arc: &Arc, now: Option<u32>) -> Option<Mask> {
        match self.along() {
            Some(path) => {
                let next = path.get(mask as usize + 1);
                (next == Some(&arc.to)).then_some(mask + 1)
            }
            None => Some(mask | self.crossed(arc.id, now)),
        }
    }

    /// The bit that beginning to cross an arc sets; none for most arcs.
    pub fn crossed(&self, arc: u32, now: Option<u32>) -> Mask {
        match &self.demand {
            Some(demand) if demand.is_set_by(arc, now) => 1 << self.waypoints.len(),
            _ => 0,
        }
    }

    /// The bit of the demand; none where it has none.
    pub fn demanded_bit(&self) -> Mask {
        self.all() & !((1 << self.waypoints.len()) - 1)
    }

    /// Whether it may be at a vertex, the waypoints of the mask visited.
    pub fn may_stand(&self, v: Vertex, mask: Mask, now: Option<u32>) -> bool {
        if let Bounds::Within(tunnel) = &self.bounds
            && tunnel.get(v as usize) != Some(&true)
        {
            return false;
        }
        let demand = self.demand.as_ref();
        demand.is_none_or(|demand| demand.may_stand(v, mask, now))
    }

    /// Whether it may begin to cross an arc.
    pub fn may_cross(&self, arc: u32, now: Option<u32>) -> bool {
        let demand = self.demand.as_ref();
        now.is_none_or(|now| now >= self.held)
            && demand.is_none_or(|demand| demand.may_cross(arc, now))
    }

    /// Whether it may wait a step.
    pub fn may_wait(&self, v: Vertex, now: u32) -> bool {
        let demand = self.demand.as_ref();
        demand.is_none_or(|demand| demand.may_wait(v, now))
    }

    /// Whether it may charge at a vertex.
    pub fn may_charge(&self, terrain: &Terrain, v: Vertex, now: Option<u32>) -> bool {
        let demand = self.demand.as_ref();
        terrain.is_charger(v) && demand.is_none_or(|demand| demand.may_charge(v, now))
    }

    /// Whether the mask has what it must have from some time on.
    pub fn is_on_time(&self, mask: Mask, now: u32) -> bool {
        let from = self.demand.as_ref().and_then(TaskConstraint::set_from);
        from.is_none_or(|from| now < from || mask & self.demanded_bit() != 0)
    }

    /// Whether it is no more than to go from its start to its goal by way of its
    /// waypoints: without a battery, and nothing beside it asked for.
    pub fn is_plain(&self) -> bool {
        self.reserve.is_none()
            && self.demand.is_none()
            && self.transit.is_none()
            && matches!(self.bounds, Bounds::Free)
            && (self.held, self.not_before) == (0, 0)
    }

    /// The latest arrival that is allowed.
    pub fn not_after(&self) -> u32 {
        match self.demand {
            Some(TaskConstraint::ArriveBy(time)) => time,
            _ => u32::MAX,
        }
    }

    /// The state at time 0; `None` where the demand forbids it.
    pub fn first(&self) -> Option<State> {
        let mask = self.first_mask();
        let state = State {
            place: self.first_place(),
            mask,
            battery: self.first_level(),
        };
        if self.reserve.is_some_and(|r| r.initial < self.delay()) {
            return None;
        }
        self.may_stand(self.start, mask, Some(0)).then_some(state)
    }

    /// Whether being at a vertex with these waypoints visited is arriving.
    pub fn is_end(&self, v: Vertex, mask: Mask) -> bool {
        v == self.goal && mask == self.all()
    }

    /// The same task for counting moves: without a battery, and without what is
    /// forbidden, so that every move can be taken back.
    #[must_use]
    pub fn for_moves(&self) -> Self {
        Self {
            reserve: None,
            demand: self.demand.clone().filter(TaskConstraint::has_bit),
            ..self.clone()
        }
    }
}
