//! The state of agents when an instance begins.
//!
//! No scene has start states: the rest of a running plan is an instance whose agents
//! are half way through their tasks ([`Snapshot`](crate::snapshot::Snapshot)). Where an
//! agent is, its battery level and the waypoints that it has still to visit stand in
//! its [`Agent`]; the start state has the rest.

use std::collections::BTreeMap;

use super::Instance;
use crate::constraint::TimedConstraint;
use crate::sorting::map;
use crate::{Agent, Assumption, Cell, Constraint, Grid};

/// The state of an agent at time 0; by default it has done nothing yet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StartState {
    /// The cell that it comes from, where at time 0 it is half way along a slow move:
    /// it is in transit then, and at its start at time 1.
    pub transit_from: Option<Cell>,
    /// The breakdowns that go on.
    pub breakdowns: Vec<Breakdown>,
    /// For how many time steps it has been at its goal with nothing left to do. If it
    /// stays there, it arrived so long before time 0; if it goes on, they count in the
    /// sum of costs.
    pub rested: u32,
    /// How many of these steps are waits if it goes on. It slept through the others.
    pub rested_awake: u32,
    /// How many wait steps on end at its start it made just before time 0, as far as
    /// they count for a condition on long waits.
    pub waits_begun: u32,
    /// Rules of the scene's own, by number, about a zone that it is in: they do not count
    /// it there until it has left.
    pub uncounted: Vec<usize>,
    /// Cells that are closed to it for what others did before time 0.
    pub closed_cells: Vec<ClosedCell>,
    /// How many time steps on end it has done before time 0 what a rule of the scene's own
    /// counts, by the number of the rule: waits in a zone, times at a cell.
    pub begun: BTreeMap<usize, u32>,
    /// For how many time steps it has stood since its last move.
    pub stood: u32,
    /// Rules about its arrival, by number, that forbid it to stay where it rested.
    pub must_go_on: Vec<usize>,
    /// What rules of the scene's own make it cost if it does not stay where it rested.
    pub penalty_if_it_goes_on: u32,
}

/// A cell that is closed to an agent for what others did before time 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClosedCell {
    /// The cell.
    pub cell: Cell,
    /// The last time at which it is closed; the largest number is for ever.
    pub until: u32,
    /// The number of the rule.
    pub rule: usize,
}

/// A breakdown: until its end, the agent begins no move.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Breakdown {
    /// The time at which it began, in steps of the whole plan.
    pub from: u32,
    /// The time of the whole plan from which the agent may go on.
    pub to: u32,
    /// The same end in the times of the instance, which begin at 0.
    pub held: u32,
}

/// The start state of an agent that has nothing behind it.
static AT_REST: StartState = StartState::nothing();

impl StartState {
    /// The state of an agent that has done nothing yet.
    pub(crate) const fn nothing() -> Self {
        Self {
            transit_from: None,
            breakdowns: Vec::new(),
            rested: 0,
            rested_awake: 0,
            waits_begun: 0,
            uncounted: Vec::new(),
            closed_cells: Vec::new(),
            begun: BTreeMap::new(),
            stood: 0,
            must_go_on: Vec::new(),
            penalty_if_it_goes_on: 0,
        }
    }

    /// The time before which the agent begins no move; 0 without a breakdown.
    pub fn not_before(&self) -> u32 {
        let ends = self.breakdowns.iter().map(|breakdown| breakdown.held);
        ends.max().unwrap_or(0)
    }

    /// How many time steps on end it has done what a rule counts, by its number.
    pub fn begun(&self, rule: usize) -> u32 {
        self.begun.get(&rule).copied().unwrap_or(0)
    }

    /// Gives rules other numbers; what a rule without one counts is left out.
    pub(super) fn renumber(&mut self, number: impl Fn(usize) -> Option<usize>) {
        let renumbered = |rules: &[usize]| rules.iter().filter_map(|&rule| number(rule)).collect();
        self.uncounted = renumbered(&self.uncounted);
        self.must_go_on = renumbered(&self.must_go_on);
        self.closed_cells.retain_mut(|closed| {
            let new = number(closed.rule);
            closed.rule = new.unwrap_or(closed.rule);
            new.is_some()
        });
        let begun = self.begun.iter();
        self.begun = map(begun.filter_map(|(&rule, &steps)| Some((number(rule)?, steps))));
    }
}

impl Instance {
    /// The same instance with another map and other rules, and with agents that are half way
    /// through their tasks; `as_written` are the rules in times of the whole plan. Two things that an instance promises may fail then: an agent in transit may
    /// share its start, and a goal or a waypoint may be an obstacle, so that there is no plan.
    pub(crate) fn resumed(
        &self,
        grid: Grid,
        agents: Vec<(Agent, StartState)>,
        (constraints, as_written): (Vec<Constraint>, &[TimedConstraint]),
        assumptions: Vec<Assumption>,
    ) -> Self {
        let states = agents.iter();
        let start_states = map(states.map(|(agent, state)| (agent.name.clone(), state.clone())));
        Self {
            name: self.name.clone(),
            grid,
            rules: self.rules,
            objective: self.objective.clone(),
            agents: agents.into_iter().map(|(agent, _)| agent).collect(),
            assumptions,
            zones: self.zones.clone(),
            units: self.units,
            constraints,
            as_written: as_written.into(),
            start_states,
        }
    }

    /// The state of an agent when the instance begins.
    pub fn start_state(&self, agent: &str) -> &StartState {
        self.start_states.get(agent).unwrap_or(&AT_REST)
    }

    /// The start state of an agent, to change it.
    pub fn start_state_mut(&mut self, agent: &str) -> &mut StartState {
        self.start_states.entry(agent.to_owned()).or_default()
    }
}
