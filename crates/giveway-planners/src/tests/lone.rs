//! One agent by the rules, a time step at a time; nothing clever.
//!
//! It reads the instance and shares nothing with the search but names.

use std::collections::BTreeMap;

use giveway_model::{Agent, Cell, Grid, Instance};

use crate::{
    single::{Metric, Place},
    terrain::Terrain,
};

/// Where the agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Spot {
    At(Cell),
    /// In transit from one cell to another.
    Amid(Cell, Cell),
}

impl Spot {
    /// The spot as the search names it.
    pub(crate) fn place(self, terrain: &Terrain) -> Place {
        let vertex = |cell| terrain.vertex(cell).unwrap();
        match self {
            Self::At(cell) => Place::At(vertex(cell)),
            Self::Amid(u, v) => {
                let mut arcs = terrain.arcs(vertex(u)).iter();
                Place::Along(arcs.find(|arc| arc.to == vertex(v)).unwrap().id)
            }
        }
    }
}

/// All that matters for what the agent can do next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct State {
    pub spot: Spot,
    /// The waypoints visited, a bit each in the order of the agent's list.
    pub visited: u32,
    /// The battery level, as the rules count it; `None` is unlimited.
    pub level: Option<u32>,
}

/// One agent of an instance.
pub(crate) struct Lone<'i> {
    grid: &'i Grid,
    agent: &'i Agent,
    floor: u32,
}

impl<'i> Lone<'i> {
    pub(crate) fn new(instance: &'i Instance, agent: usize) -> Self {
        Self {
            grid: instance.grid(),
            agent: &instance.agents()[agent],
            floor: instance.rules().battery_floor,
        }
    }

    /// The state at time 0; `None` if the battery begins below the floor.
    pub(crate) fn start(&self) -> Option<State> {
        let level = self.agent.battery.map(|battery| battery.initial);
        let begun = level.is_none_or(|level| level >= self.floor);
        begun.then_some(State {
            spot: Spot::At(self.agent.start),
            visited: self.waypoint(self.agent.start),
            level,
        })
    }

    /// Whether the task can end in a state.
    pub(crate) fn is_end(&self, state: &State) -> bool {
        let all = (1 << self.agent.waypoints.len()) - 1;
        state.spot == Spot::At(self.agent.goal_or_start()) && state.visited == all
    }

    /// Every state one step later, with the charges and moves of the step.
    pub(crate) fn onward(&self, state: &State) -> Vec<(State, [u32; 2])> {
        let mut onward = Vec::new();
        for (level, charges) in self.levels_after(state) {
            let mut push = |spot, moves| {
                let here = match spot {
                    Spot::At(cell) => self.waypoint(cell),
                    Spot::Amid(..) => 0,
                };
                let visited = state.visited | here;
                let to = State {
                    spot,
                    visited,
                    level,
                };
                onward.push((to, [charges, moves]));
            };
            match state.spot {
                Spot::Amid(_, v) => push(Spot::At(v), 0),
                Spot::At(u) => {
                    push(Spot::At(u), 0);
                    for v in self.grid.neighbours(u) {
                        let slow = self.grid.is_slow(u) && self.grid.is_slow(v);
                        push(if slow { Spot::Amid(u, v) } else { Spot::At(v) }, 1);
                    }
                }
            }
        }
        onward
    }

    /// The levels that may be one step later, and the charges for them.
    fn levels_after(&self, state: &State) -> Vec<(Option<u32>, u32)> {
        let Some((battery, level)) = self.agent.battery.zip(state.level) else {
            return vec![(None, 0)];
        };
        let mut after = Vec::new();
        if level > self.floor {
            after.push((Some(level - 1), 0));
        }
        let charger = matches!(state.spot, Spot::At(cell) if self.grid.is_charger(cell));
        if charger && battery.capacity >= self.floor {
            after.push((Some(battery.capacity), 1));
        }
        after
    }

    fn waypoint(&self, cell: Cell) -> u32 {
        let found = self.agent.waypoints.iter().position(|&w| w == cell);
        found.map_or(0, |i| 1 << i)
    }

    /// All states that could be, reachable or not.
    pub(crate) fn states(&self) -> Vec<State> {
        let levels: Vec<Option<u32>> = match self.agent.battery {
            None => vec![None],
            Some(battery) => (self.floor..=battery.capacity).map(Some).collect(),
        };
        let mut states = Vec::new();
        for (u, _) in self.grid.cells().filter(|(_, g)| g.is_vertex()) {
            let mut spots = vec![(Spot::At(u), self.waypoint(u))];
            let amid = self.grid.neighbours(u);
            spots.extend(amid.map(|v| (Spot::Amid(u, v), 0)));
            for (spot, here) in spots {
                let visited = (0..1 << self.agent.waypoints.len()).filter(|v| v & here == here);
                for visited in visited {
                    states.extend(levels.iter().map(|&level| State {
                        spot,
                        visited,
                        level,
                    }));
                }
            }
        }
        states
    }

    /// What each state still has to pay; those without an end are left out.
    /// Said again and again to the states before, until nothing changes.
    pub(crate) fn cost_to_go(&self, metric: Metric) -> BTreeMap<State, u32> {
        let states = self.states();
        let ends = states.iter().filter(|state| self.is_end(state));
        let mut cost_to_go: BTreeMap<State, u32> = ends.map(|&state| (state, 0)).collect();
        loop {
            let mut changed = false;
            for state in &states {
                let onward = self.onward(state).into_iter();
                let best = onward.filter_map(|(to, [charges, moves])| {
                    let toll = match metric {
                        Metric::Time => 1,
                        Metric::Charges => charges,
                        Metric::Moves => moves,
                    };
                    Some(toll + cost_to_go.get(&to)?)
                });
                let Some(best) = best.min() else { continue };
                if cost_to_go.get(state).is_none_or(|&known| best < known) {
                    cost_to_go.insert(*state, best);
                    changed = true;
                }
            }
            if !changed {
                return cost_to_go;
            }
        }
    }

    /// Whether spots, one a time step, are a way to do the task.
    pub(crate) fn can_follow(&self, spots: &[Spot]) -> bool {
        let Some((first, rest)) = spots.split_first() else {
            return false;
        };
        let mut states: Vec<State> = self.start().into_iter().collect();
        states.retain(|state| state.spot == *first);
        for spot in rest {
            let onward = states.iter().flat_map(|state| self.onward(state));
            states = onward
                .map(|(to, _)| to)
                .filter(|to| to.spot == *spot)
                .collect();
            states.sort_unstable();
            states.dedup();
        }
        states.iter().any(|state| self.is_end(state))
    }
}
