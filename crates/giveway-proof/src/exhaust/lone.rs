//! One agent, from state to state.

use giveway_model::{Agent, Cell, Cost, Instance};

use super::Spent;

/// Where an agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
    /// At a cell, not arrived yet.
    At(Cell),
    /// Half way of a slow move.
    Half(Cell, Cell),
    /// At this cell, for good, or where it vanishes for the last time.
    Arrived(Cell),
    /// Vanished from its goal.
    Gone,
}

/// All that matters of one agent for what comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct State {
    place: Place,
    /// The waypoints that it has seen, a bit each.
    seen: u64,
    /// The level of its battery; 0 without one, and after its arrival.
    level: u32,
}

impl State {
    pub(super) fn has_arrived(self) -> bool {
        matches!(self.place, Place::Arrived(_) | Place::Gone)
    }
}

/// The step of one agent from one time to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) to: State,
    /// The edge that it is on meanwhile, and in which direction.
    pub(super) crosses: Option<(Cell, Cell)>,
    pub(super) spent: Spent,
}

/// One agent and its rules.
pub(super) struct Lone<'a> {
    instance: &'a Instance,
    agent: &'a Agent,
    /// Whether charges are counted: else it may as well charge wherever it can,
    /// since a fuller battery forbids nothing.
    thrifty: bool,
}

impl<'a> Lone<'a> {
    /// `None` where it has more waypoints than a state can hold.
    pub(super) fn new(instance: &'a Instance, agent: usize, thrifty: bool) -> Option<Self> {
        let agent = instance.agents().get(agent)?;
        (agent.waypoints.len() < 64).then_some(Self {
            instance,
            agent,
            thrifty,
        })
    }

    /// The cell that a state takes up.
    pub(super) const fn cell(state: State) -> Option<Cell> {
        match state.place {
            Place::At(cell) | Place::Arrived(cell) => Some(cell),
            Place::Half(..) | Place::Gone => None,
        }
    }

    /// The cells that count for a zone or a distance: in transit both ends of the edge.
    pub(super) fn touches(state: State) -> impl Iterator<Item = Cell> {
        let cells = match state.place {
            Place::At(cell) | Place::Arrived(cell) => [Some(cell), None],
            Place::Half(u, v) => [Some(u), Some(v)],
            Place::Gone => [None, None],
        };
        cells.into_iter().flatten()
    }

    /// The states at time 0, as steps from nowhere.
    pub(super) fn begin(&self) -> Vec<Step> {
        let level = self.agent.battery.map_or(0, |battery| battery.initial);
        let mut steps = Vec::new();
        if self.agent.battery.is_none() || level >= self.floor() {
            self.come(
                &mut steps,
                Spent::default(),
                None,
                self.agent.start,
                0,
                level,
            );
        }
        steps
    }

    /// Everything that it can do from a state.
    pub(super) fn steps(&self, state: State) -> Vec<Step> {
        let mut steps = Vec::new();
        match state.place {
            Place::Arrived(_) | Place::Gone => {
                let place = if self.instance.keeps(self.agent) {
                    state.place
                } else {
                    Place::Gone
                };
                steps.push(Step {
                    to: State { place, ..state },
                    crosses: None,
                    spent: Spent::default(),
                });
            }
            Place::Half(u, v) => {
                if let Some(level) = self.drained(state.level) {
                    let spent = spend(&[]);
                    self.come(&mut steps, spent, Some((u, v)), v, state.seen, level);
                }
            }
            Place::At(u) => {
                let can_charge = self.agent.battery.is_some() && self.instance.grid().is_charger(u);
                if !can_charge || self.thrifty {
                    self.leave(&mut steps, state, u, self.drained(state.level), &[]);
                }
                if can_charge {
                    let full = self.agent.battery.map(|battery| battery.capacity);
                    let full = full.filter(|&level| level >= self.floor());
                    self.leave(&mut steps, state, u, full, &[Cost::Charges]);
                }
            }
        }
        steps
    }

    /// All ways to go on from a cell, with this level at the next time.
    fn leave(
        &self,
        steps: &mut Vec<Step>,
        state: State,
        u: Cell,
        level: Option<u32>,
        charge: &[Cost],
    ) {
        let Some(level) = level else { return };
        let grid = self.instance.grid();
        let with = |cost| spend(&[charge, &[cost]].concat());
        self.come(steps, with(Cost::Waits), None, u, state.seen, level);
        for v in grid.neighbours(u) {
            if grid.is_slow_edge(u, v) {
                let to = State {
                    place: Place::Half(u, v),
                    seen: state.seen,
                    level,
                };
                let crosses = Some((u, v));
                let spent = with(Cost::Moves);
                steps.push(Step { to, crosses, spent });
            } else {
                let spent = with(Cost::Moves);
                self.come(steps, spent, Some((u, v)), v, state.seen, level);
            }
        }
    }

    /// Being at a cell at the next time: where it may, it can also arrive there.
    fn come(
        &self,
        steps: &mut Vec<Step>,
        spent: Spent,
        crosses: Option<(Cell, Cell)>,
        cell: Cell,
        seen: u64,
        level: u32,
    ) {
        let waypoints = &self.agent.waypoints;
        let here = waypoints.iter().position(|&waypoint| waypoint == cell);
        let seen = here.map_or(seen, |i| seen | 1 << i);
        let to = State {
            place: Place::At(cell),
            seen,
            level,
        };
        steps.push(Step { to, crosses, spent });
        let may_rest = self.agent.goal.is_none_or(|goal| goal == cell);
        if may_rest && seen.count_ones() as usize == waypoints.len() {
            let to = State {
                place: Place::Arrived(cell),
                seen: 0,
                level: 0,
            };
            steps.push(Step { to, crosses, spent });
        }
    }

    fn floor(&self) -> u32 {
        self.instance.rules().battery_floor
    }

    /// The level after a step without a charge; `None` where it is too low.
    fn drained(&self, level: u32) -> Option<u32> {
        if self.agent.battery.is_none() {
            return Some(0);
        }
        level.checked_sub(1).filter(|&level| level >= self.floor())
    }
}

/// The costs of a step before the arrival, beside one of time.
fn spend(costs: &[Cost]) -> Spent {
    let mut spent = Spent::default();
    for cost in [Cost::Makespan, Cost::SumOfCosts].iter().chain(costs) {
        spent[*cost as usize] += 1;
    }
    spent
}
