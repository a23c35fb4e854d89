//! One agent on its way when the world changes.

use std::collections::BTreeSet;

use giveway_model::change::What;
use giveway_model::{Agent, Cell};

use super::Held;

/// An agent as the change finds it.
pub(super) struct Robot {
    pub(super) agent: Agent,
    pub(super) is_old: bool,
    pub(super) first: Place,
    pub(super) level: u32,
    pub(super) held: u32,
    /// How long it has been at its goal, where it may stay there for good.
    pub(super) rested: u32,
    /// Of these the steps that are waits if it goes on.
    pub(super) stood: u32,
    pub(super) rest: Vec<Cell>,
    pub(super) old: Vec<Option<Cell>>,
    pub(super) charges: Vec<u32>,
    pub(super) tunnel: BTreeSet<Cell>,
    pub(super) by: Held,
}

/// Where an agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
    At(Cell),
    Between(Cell, Cell),
    /// Arrived for good at this cell.
    Done(Cell),
    Gone,
}

/// What its future depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct State {
    pub(super) place: Place,
    pub(super) seen: u32,
    pub(super) level: u32,
    pub(super) progress: usize,
    pub(super) held: u32,
    pub(super) same: bool,
}

/// One step of one agent.
#[derive(Clone, Copy)]
pub(super) struct Step {
    pub(super) to: State,
    pub(super) edge: Option<(Cell, Cell)>,
    /// Whether it takes time on the way; to be woken takes none.
    pub(super) time: u32,
    pub(super) steps: u32,
    pub(super) charges: u32,
    pub(super) moves: u32,
    pub(super) waits: u32,
    pub(super) disturbed: u32,
}

/// A level that never ends.
pub(super) const UNLIMITED: u32 = u32::MAX;

impl Robot {
    /// What a change means to the agent.
    pub(super) fn meet(&mut self, what: &What) {
        let me = self.agent.name.clone();
        match what {
            What::SetGoal { agent, cell } if *agent == me => {
                if self.agent.goal != Some(*cell) {
                    self.go_on();
                }
                self.agent.goal = Some(*cell);
            }
            What::AddWaypoint { agent, cell } if *agent == me => {
                self.agent.waypoints.push(*cell);
                self.go_on();
            }
            What::DropWaypoint { agent, cell } if *agent == me => {
                self.agent.waypoints.retain(|waypoint| waypoint != cell);
            }
            What::SetBattery { agent, level } if *agent == me => self.level = *level,
            What::DelayAgent { agent, steps } if *agent == me => {
                let transit = matches!(self.first, Place::Between(..));
                self.held = self.held.max(steps + u32::from(transit));
            }
            _ => {}
        }
    }

    /// It has something to do: it goes on from where it is.
    const fn go_on(&mut self) {
        (self.rested, self.stood) = (0, 0);
    }

    pub(super) fn enter(&self, mut state: State, cell: Cell) -> Vec<State> {
        for (i, waypoint) in self.agent.waypoints.iter().enumerate() {
            if *waypoint == cell {
                state.seen |= 1 << i;
            }
        }
        state.place = Place::At(cell);
        let mut states = vec![state];
        let all = state.seen.count_ones() as usize == self.agent.waypoints.len();
        let through = self.by != Held::Path || state.progress + 1 == self.rest.len();
        if self.agent.goal.is_none_or(|goal| goal == cell) && all && through {
            let place = Place::Done(cell);
            states.push(State {
                place,
                level: 0,
                held: 0,
                ..state
            });
        }
        states
    }

    /// A step to a state at a time, and whether it is the first that differs
    /// from the old plan.
    pub(super) fn step(&self, mut to: State, tick: u32) -> Step {
        let last = self.old.len().saturating_sub(1);
        let same = match self.old.get(tick as usize) {
            Some(Some(cell)) if (tick as usize) < last => to.place == Place::At(*cell),
            Some(None) => matches!(to.place, Place::Between(..)),
            _ => match to.place {
                Place::Done(cell) => self.old.last() == Some(&Some(cell)),
                Place::Gone => true,
                Place::At(_) | Place::Between(..) => false,
            },
        };
        let disturbed = u32::from(to.same && !same);
        to.same &= same;
        Step {
            to,
            edge: None,
            time: 0,
            steps: 0,
            charges: 0,
            moves: 0,
            waits: 0,
            disturbed,
        }
    }

    /// How far it has come on its path once it is at a cell next; `None` where
    /// it may not go there.
    pub(super) fn may_go(&self, state: State, v: Cell) -> Option<usize> {
        if state.held > 0 {
            return None;
        }
        match self.by {
            Held::Nothing => Some(0),
            Held::Tunnel(_) => self.tunnel.contains(&v).then_some(0),
            Held::Path => {
                let next = state.progress + 1;
                (self.rest.get(next) == Some(&v)).then_some(next)
            }
        }
    }
}
