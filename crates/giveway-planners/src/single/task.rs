//! An agent's task over the graph of the map.

mod ends;
mod steps;

use std::rc::Rc;

use giveway_model::{Agent, Battery, Rules, StartState};

use super::{Area, Automaton, Counter, NoPlanAlone, Place, has_to_be_at};
use crate::terrain::{Terrain, Vertex};

/// How far an agent has come: a set of visited waypoints, one bit each in the order of the
/// agent's list; after them one for each thing that a condition asks for; and from bit
/// [`COUNTS`] on what is counted on the way.
pub type Mask = u64;

/// The bits of masks that tables know.
pub(super) const COUNTS: u32 = 24;

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

/// What costs an agent a penalty.
#[derive(Clone, Debug)]
pub enum Penalty {
    /// Each time in an area before its arrival costs so much.
    Avoid(Area, u32),
    /// Each step that it arrives after a time costs so much.
    Late {
        /// The time.
        by: u32,
        /// The cost of a step.
        weight: u32,
    },
    /// Not to arrive at time 0 costs so much: it leaves where it rested before.
    GoingOn(u32),
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

/// The task of one agent.
#[derive(Clone, Debug)]
pub struct Task {
    /// Where it is at time 0, or will be first.
    pub start: Vertex,
    /// Where it has to arrive; `None` where it may rest at any vertex.
    pub goal: Option<Vertex>,
    /// The waypoints; the i-th has bit i.
    pub waypoints: Vec<Vertex>,
    /// `None` is unlimited.
    pub reserve: Option<Reserve>,
    /// The conditions on it beside the task.
    pub conditions: Automaton,
    /// It must not have arrived before this time.
    pub not_before: u32,
    /// It does not rest at these vertices by these times: only of an agent without a
    /// goal, which may rest elsewhere meanwhile.
    pub not_resting: Vec<(Vertex, u32)>,
    /// What costs it a penalty.
    pub penalties: Vec<Penalty>,
    /// Where it may go.
    pub bounds: Bounds,
    /// At time 0 it is half way along this arc, whose end is `start`.
    pub transit: Option<u32>,
    /// It begins no move before this time; it may rest at its goal, though.
    pub earliest_move: u32,
    /// The sum of costs of an agent that does not arrive at time 0: it left its goal.
    pub cost_if_it_leaves_goal: u32,
    /// The waits of an agent that does not arrive at time 0: it stood at its goal and had not arrived.
    pub waits_if_it_leaves_goal: u32,
    /// The wait steps on end at `start` that it made just before time 0, as far as they
    /// count for conditions on long waits.
    pub waits_begun: u32,
}

impl Task {
    /// The task of an agent.
    ///
    /// # Errors
    /// Where its battery begins below the floor or a cell is no vertex, so that no
    /// plan exists.
    pub fn new(agent: &Agent, rules: Rules, terrain: &Terrain) -> Result<Self, NoPlanAlone> {
        let reserve = match agent.battery {
            None => None,
            Some(Battery { capacity, initial }) => {
                Some(Reserve::above(rules.battery_floor, capacity, initial)?)
            }
        };
        let waypoints: Result<Vec<Vertex>, NoPlanAlone> = agent
            .waypoints
            .iter()
            .map(|&cell| has_to_be_at(cell, terrain))
            .collect();
        Ok(Self {
            start: has_to_be_at(agent.start, terrain)?,
            goal: agent
                .goal
                .map(|goal| has_to_be_at(goal, terrain))
                .transpose()?,
            waypoints: waypoints?,
            reserve,
            conditions: Automaton::default(),
            not_before: 0,
            not_resting: Vec::new(),
            penalties: Vec::new(),
            bounds: Bounds::Free,
            transit: None,
            earliest_move: 0,
            cost_if_it_leaves_goal: 0,
            waits_if_it_leaves_goal: 0,
            waits_begun: 0,
        })
    }

    /// The task of an agent that begins with something behind it, and may go only where
    /// its bounds let it.
    ///
    /// # Errors
    /// As [`Task::new`], but that an agent which arrived before time 0 needs no battery
    /// as long as it stays.
    pub fn resumed(
        agent: &Agent,
        state: &StartState,
        bounds: Bounds,
        rules: Rules,
        terrain: &mut Terrain,
    ) -> Result<Self, NoPlanAlone> {
        // An agent that is held to a path that leads on has to go on.
        let may_stay =
            state.rested > 0 && !matches!(&bounds, Bounds::Along(path) if path.len() > 1);
        let is_below = |battery: Battery| battery.initial < rules.battery_floor;
        let mut task = if may_stay && agent.battery.is_some_and(is_below) {
            let start = has_to_be_at(agent.start, terrain)?;
            let at_rest = Agent {
                battery: None,
                ..agent.clone()
            };
            Self {
                bounds: Bounds::Along(vec![start].into()),
                ..Self::new(&at_rest, rules, terrain)?
            }
        } else {
            Self {
                bounds,
                ..Self::new(agent, rules, terrain)?
            }
        };
        if matches!(task.bounds, Bounds::Along(_)) {
            task.waypoints.clear();
        }
        if let Some(from) = state.transit_from {
            task.transit = Some(terrain.transit(terrain.vertex(from), task.start));
        }
        if may_stay {
            (task.cost_if_it_leaves_goal, task.waits_if_it_leaves_goal) =
                (state.rested, state.rested_awake);
        }
        Ok(Self {
            earliest_move: state.not_before(),
            waits_begun: state.waits_begun,
            ..task
        })
    }

    /// The number of bits of a mask.
    pub fn bits(&self) -> usize {
        self.waypoints.len() + self.conditions.required.len()
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

    /// The waypoint at a vertex, as a set of one; empty elsewhere.
    pub fn bit(&self, v: Vertex) -> Mask {
        if self.waypoints.is_empty() || self.along().is_some() {
            return 0;
        }
        let found = self.waypoints.iter().position(|&w| w == v);
        found.map_or(0, |i| 1 << i)
    }

    /// Whether it has been at a vertex that it has to visit, or of which it is noted.
    pub fn has_been(&self, mask: Mask, v: Vertex) -> bool {
        let mut counts = self.conditions.counts_in(mask);
        let noted = counts.find(|&(counter, _)| *counter == Counter::Visited(v));
        noted.map_or_else(|| self.bit(v) & mask != 0, |(_, count)| count > 0)
    }

    /// Whether others wait for it to be somewhere where it has not been.
    pub fn is_awaited(&self, mask: Mask) -> bool {
        let mut counts = self.conditions.counts_in(mask);
        counts.any(|(counter, count)| matches!(counter, Counter::Visited(_)) && count == 0)
    }

    /// Whether a rule does not count it in its zone, where it has been there at all times up
    /// to the last one, of which the mask is.
    pub fn is_uncounted(&self, mask: Mask, rule: usize) -> bool {
        let mut counts = self.conditions.counts_in(mask);
        counts.any(|(counter, count)| match counter {
            Counter::Left(left) => left.rule == rule && count == 0,
            Counter::LongWait(_)
            | Counter::Sequence(_)
            | Counter::Stay(_)
            | Counter::Turns(_)
            | Counter::Entry(_)
            | Counter::Visited(_)
            | Counter::Order(..) => false,
        })
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

    /// The bits of a mask that tables know.
    pub const fn set_of(mask: Mask) -> Mask {
        mask & ((1 << COUNTS) - 1)
    }

    /// Where it is at time 0.
    pub fn first_place(&self) -> Place {
        self.transit.map_or(Place::At(self.start), Place::Along)
    }
}
