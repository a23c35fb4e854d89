//! What one agent may do: its states, and what may follow each in one step.

use giveway_model::{Agent, Battery, Cell};

use super::contrast::{Asked, Memory};
use super::price::Price;
use super::world::World;

/// Where an agent is at an integer time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Place {
    /// At a vertex, and not arrived for good.
    At(Cell),
    /// In transit on a slow edge.
    Between(Cell, Cell),
    /// Arrived for good: it holds this cell. An agent that vanishes does so at the
    /// time of its arrival only.
    Arrived(Cell),
    /// Vanished.
    Gone,
}

/// All that matters of an agent's past.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct State {
    pub(crate) place: Place,
    /// One bit for each waypoint that it has visited.
    seen: u32,
    level: Level,
    /// What it remembers for a question; nothing any more after its arrival.
    pub(crate) memory: Memory,
    /// The time, as long as the agent is broken down; 0 after its arrival.
    clock: u32,
}

/// How full the battery of an agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    /// It has no battery, or does not need it any more after its arrival.
    Unlimited,
    /// The level, in time steps.
    Left(u32),
}

/// What may follow in one step of time.
pub(super) struct Next {
    /// The state at the end of the step.
    pub(super) state: State,
    /// The edge on which the agent is during the step, from and to.
    pub(super) edge: Option<(Cell, Cell)>,
    /// What the step costs.
    pub(super) price: Price,
}

/// What an agent may do.
pub(super) struct Law<'a> {
    pub(super) world: &'a World,
    pub(super) agent: &'a Agent,
    /// The level below which no battery may fall.
    pub(super) floor: u32,
    /// Whether it stays where it arrives.
    pub(super) stays: bool,
    /// What a question asks of the agent beside its task.
    pub(super) asked: Option<Asked>,
    /// The time before which the agent begins no move.
    pub(super) held: u32,
    /// The cell from which it comes half way along a slow move at time 0.
    pub(super) transit: Option<Cell>,
}

impl Law<'_> {
    /// The states possible at time 0.
    pub(super) fn first(&self) -> Vec<State> {
        let level = match self.agent.battery {
            None => Level::Unlimited,
            Some(battery) if battery.initial < self.floor => return Vec::new(),
            Some(battery) => Level::Left(battery.initial),
        };
        let memory = self.asked.as_ref().map(Asked::first).unwrap_or_default();
        if let Some(from) = self.transit {
            return vec![State {
                place: Place::Between(from, self.agent.start),
                seen: 0,
                level,
                memory,
                clock: 0,
            }];
        }
        self.on_entering(self.agent.start, 0, level, memory, 0)
    }

    /// The states possible for an agent that comes to a vertex. When its task is
    /// done there, it may have arrived for good, or may yet go on. There is no
    /// third way, to wait first and to have arrived later: its arrival would be
    /// the beginning of that wait.
    fn on_entering(
        &self,
        cell: Cell,
        seen: u32,
        level: Level,
        memory: Memory,
        clock: u32,
    ) -> Vec<State> {
        let entered = match &self.asked {
            Some(asked) => asked.enter(memory, cell),
            None => Some(memory),
        };
        let Some(memory) = entered else {
            return Vec::new();
        };
        let mut seen = seen;
        for (i, &waypoint) in self.agent.waypoints.iter().enumerate() {
            if waypoint == cell {
                seen |= 1 << i;
            }
        }
        let mut states = vec![State {
            place: Place::At(cell),
            seen,
            level,
            memory,
            clock,
        }];
        let all_seen = seen.count_ones() as usize == self.agent.waypoints.len();
        let may = self
            .asked
            .as_ref()
            .is_none_or(|a| a.may_arrive(memory, cell));
        let may_rest = self.agent.goal.is_none_or(|goal| goal == cell);
        if may_rest && all_seen && may {
            states.push(State {
                place: Place::Arrived(cell),
                seen,
                level: Level::Unlimited,
                memory: Memory::default(),
                clock: 0,
            });
        }
        states
    }

    /// The level after a step without a charge; `None` where it would fall below
    /// the floor.
    fn spend(&self, level: Level) -> Option<Level> {
        match level {
            Level::Unlimited => Some(Level::Unlimited),
            Level::Left(left) if left > self.floor => Some(Level::Left(left - 1)),
            Level::Left(_) => None,
        }
    }

    /// The levels possible after a step that begins at a vertex, and whether it
    /// takes a charge.
    fn levels_after(&self, cell: Cell, level: Level) -> Vec<(Level, bool)> {
        let mut after = Vec::new();
        if let Some(left) = self.spend(level) {
            after.push((left, false));
        }
        if let Some(Battery { capacity, .. }) = self.agent.battery
            && self.world.is_charger(cell)
            && capacity >= self.floor
        {
            after.push((Level::Left(capacity), true));
        }
        after
    }

    /// Everything that may follow a state.
    pub(super) fn steps(&self, state: State) -> Vec<Next> {
        match state.place {
            Place::At(cell) => self.steps_from_vertex(cell, state),
            Place::Between(u, v) => self.steps_in_transit(u, v, state),
            Place::Arrived(_) | Place::Gone => {
                let place = if self.stays { state.place } else { Place::Gone };
                vec![Next {
                    state: State { place, ..state },
                    edge: None,
                    price: Price::default(),
                }]
            }
        }
    }

    /// The agent waits, or moves to a neighbour, or begins a slow move; in each
    /// case it may charge, where it can.
    fn steps_from_vertex(&self, u: Cell, state: State) -> Vec<Next> {
        let seen = state.seen;
        let clock = (state.clock + 1).min(self.held);
        let mut found = Vec::new();
        for (level, charged) in self.levels_after(u, state.level) {
            let price = Price {
                steps: 1,
                charges: u32::from(charged),
                ..Price::default()
            };
            if let Some(memory) = self.remember(state.memory, u, None, charged) {
                found.push(Next {
                    state: State {
                        level,
                        memory,
                        clock,
                        ..state
                    },
                    edge: None,
                    price: Price { waits: 1, ..price },
                });
            }
            if state.clock < self.held {
                continue;
            }
            for v in self.world.neighbours(u) {
                let Some(memory) = self.remember(state.memory, u, Some(v), charged) else {
                    continue;
                };
                let reached = if self.world.is_slow(u, v) {
                    vec![State {
                        place: Place::Between(u, v),
                        seen,
                        level,
                        memory,
                        clock,
                    }]
                } else {
                    self.on_entering(v, seen, level, memory, clock)
                };
                found.extend(reached.into_iter().map(|state| Next {
                    state,
                    edge: Some((u, v)),
                    price: Price { moves: 1, ..price },
                }));
            }
        }
        found
    }

    /// What it remembers once it has left a vertex, or waited there; `None`
    /// where that is not what is asked for.
    fn remember(&self, memory: Memory, u: Cell, v: Option<Cell>, charges: bool) -> Option<Memory> {
        let Some(asked) = &self.asked else {
            return Some(memory);
        };
        let slow = v.is_some_and(|v| self.world.is_slow(u, v));
        let memory = asked.leave(memory, u, v, charges, slow)?;
        match v {
            Some(_) => Some(memory),
            None => asked.enter(memory, u),
        }
    }

    /// The second half of a slow move: no charge, no stopping, no turning.
    fn steps_in_transit(&self, u: Cell, v: Cell, state: State) -> Vec<Next> {
        let Some(level) = self.spend(state.level) else {
            return Vec::new();
        };
        let memory = match &self.asked {
            Some(asked) => asked.later(state.memory),
            None => state.memory,
        };
        let clock = (state.clock + 1).min(self.held);
        let reached = self.on_entering(v, state.seen, level, memory, clock);
        let each = reached.into_iter().map(|state| Next {
            state,
            edge: Some((u, v)),
            price: Price {
                steps: 1,
                ..Price::default()
            },
        });
        each.collect()
    }
}
