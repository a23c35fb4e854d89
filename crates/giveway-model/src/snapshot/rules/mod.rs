//! The rules of a scene's own on the rest of a plan.
//!
//! A rule becomes one in times from 0, with the same number. What was done already goes
//! into the rule where its kind can say it (the rest of a sequence; agents that still have
//! to visit a cell), and else into the agents' [start states](StartState). Rules that are
//! met, past or removed are off.

mod progress;

use std::collections::BTreeMap;

use super::RunningAgent;
use crate::change::{History, Timeline, Trajectory};
use crate::check::{penalty_until, waits_on_end};
use crate::condition::{Times, Visit};
use crate::constraint::{ConstraintKind, MAX_NUMBER, TimedConstraint, meant};
use crate::{Agent, Cell, ClosedCell, Constraint, Plan, StartState};

/// An agent of the rest, as it is being made.
pub(super) struct Resumed<'a> {
    pub(super) timeline: &'a Timeline,
    /// Its trajectory up to the time of the snapshot; `None` of one that appears then.
    pub(super) past: Option<Trajectory<'a>>,
    pub(super) agent: Agent,
    pub(super) state: StartState,
    pub(super) running: RunningAgent,
}

/// The rules at the time of a snapshot.
pub(super) struct RestOfRules<'a> {
    pub(super) at: u32,
    pub(super) past: &'a History,
    pub(super) history: &'a History,
    pub(super) plan: &'a Plan,
    /// The trajectories of agents that are gone.
    gone: Vec<Trajectory<'a>>,
}

impl<'a> RestOfRules<'a> {
    pub(super) fn new(
        at: u32,
        (past, history): (&'a History, &'a History),
        plan: &'a Plan,
        agents: &[Resumed<'a>],
    ) -> Self {
        let is_there = |name: &str| agents.iter().any(|it| it.agent.name == name);
        let timelines = history.timelines().iter();
        let gone = timelines.filter(|timeline| !is_there(timeline.name()));
        Self {
            at,
            past,
            history,
            plan,
            gone: gone
                .filter_map(|timeline| Trajectory::of(history, timeline, plan))
                .collect(),
        }
    }

    /// The rules of the rest; what they cannot say goes into the states of the agents.
    pub(super) fn rewrite(&self, agents: &mut [Resumed<'a>]) -> Vec<Constraint> {
        for resumed in agents.iter_mut() {
            self.turn(resumed);
            self.pay(resumed);
        }
        let rules = self.history.constraints().iter().enumerate();
        let rules = rules.map(|(index, timed)| {
            let names: Vec<&str> = agents.iter().map(|it| it.agent.name.as_str()).collect();
            let number = |name: &str| names.iter().position(|other| *other == name);
            let all = || (0..names.len()).collect();
            let constraint = &timed.constraint;
            let is_there = timed.is_there(self.at);
            let bound = constraint
                .in_force_among(index, &number, all)
                .filter(|_| is_there)
                .map(|rule| rule.agents);
            let kind = match bound {
                Some(bound) => self.rest(index, timed, &bound, agents),
                None => self.without_first(index, timed, agents),
            };
            match kind {
                Some((kind, named)) => Constraint {
                    kind,
                    agents: named.or_else(|| constraint.agents.clone()),
                    ..constraint.clone()
                },
                None => Constraint {
                    off: true,
                    ..constraint.clone()
                },
            }
        });
        rules.collect()
    }

    /// A rule on the rest, and its agents where they are others; `None` where nothing is
    /// left of it.
    fn rest(
        &self,
        index: usize,
        timed: &TimedConstraint,
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) -> Option<(ConstraintKind, Option<Vec<String>>)> {
        let kind = &timed.constraint.kind;
        let rest = match kind {
            ConstraintKind::Capacity { zone, times, most } => {
                let times = self.shift(*times)?;
                self.do_not_count((index, timed), zone, bound, agents);
                ConstraintKind::Capacity {
                    zone: zone.clone(),
                    most: *most,
                    times,
                }
            }
            ConstraintKind::Closed { zone, times } => {
                let times = self.shift(*times)?;
                self.do_not_count((index, timed), zone, bound, agents);
                ConstraintKind::Closed {
                    zone: zone.clone(),
                    times,
                }
            }
            ConstraintKind::Gap { steps } => {
                self.close_behind((index, timed), *steps, bound, agents);
                kind.clone()
            }
            ConstraintKind::Apart { distance, times } => ConstraintKind::Apart {
                distance: *distance,
                times: self.shift(*times)?,
            },
            ConstraintKind::Sequence { agent, cells } => {
                let past = bound.iter().find_map(|&it| agents.get(it)?.past);
                let left = past.map_or(&cells[..], |past| self.left_of(cells, &past));
                if left.is_empty() {
                    return None;
                }
                ConstraintKind::Sequence {
                    agent: agent.clone(),
                    cells: left.to_vec(),
                }
            }
            ConstraintKind::Visit { cell, stay, times } => {
                let mut left = Vec::new();
                for &number in bound {
                    let Some(resumed) = agents.get_mut(number) else {
                        continue;
                    };
                    let past = resumed.past;
                    let run = past.map_or(Some(0), |past| self.stayed(*cell, *stay, *times, &past));
                    let Some(run) = run else { continue };
                    left.push(resumed.agent.name.clone());
                    if run > 0 {
                        resumed.state.begun.insert(index, run);
                    }
                }
                if left.is_empty() {
                    return None;
                }
                let rest = ConstraintKind::Visit {
                    cell: *cell,
                    stay: *stay,
                    times: self.shift(*times).unwrap_or(NEVER),
                };
                return Some((rest, Some(left)));
            }
            ConstraintKind::Arrive { times } => {
                for &number in bound {
                    if let Some(Resumed { state, .. }) = agents.get_mut(number) {
                        let arrival = self.at - state.rested;
                        let is_judged = timed.since.is_none_or(|since| since <= arrival);
                        let is_met = meant(*times).contains(arrival);
                        state.must_go_on |= state.rested > 0 && is_judged && !is_met;
                    }
                }
                ConstraintKind::Arrive {
                    times: self.shift(*times).unwrap_or(NEVER),
                }
            }
            ConstraintKind::Late { by, weight } => ConstraintKind::Late {
                by: by.saturating_sub(self.at),
                weight: *weight,
            },
            ConstraintKind::Depart { from } => ConstraintKind::Depart {
                from: from.checked_sub(self.at).filter(|&from| from > 0)?,
            },
            ConstraintKind::Before { first, .. } => {
                let mut firsts = agents.iter().filter(|it| it.agent.name == first.agent);
                let past = firsts.find_map(|it| it.past);
                if past.is_some_and(|past| self.has_been(first.cell, &past)) {
                    return None;
                }
                kind.clone()
            }
            ConstraintKind::NoWaiting { zone, .. } => {
                let has = |cell: Cell| self.zone_has(zone, cell);
                for &number in bound {
                    if let Some(resumed) = agents.get_mut(number)
                        && let Some(past) = resumed.past
                        && has(resumed.agent.start)
                    {
                        let since = timed.since.unwrap_or(0);
                        let run = waits_on_end(self.past, &past, (since, self.at));
                        resumed.state.begun.insert(index, run);
                    }
                }
                kind.clone()
            }
            ConstraintKind::OneWay { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => kind.clone(),
        };
        Some((rest, None))
    }

    /// Times from the time of the snapshot on; `None` where they are past.
    fn shift(&self, times: Times) -> Option<Times> {
        let to = match times.to.filter(|&to| to < MAX_NUMBER) {
            Some(to) => Some(to.checked_sub(self.at)?),
            None => None,
        };
        let from = times.from.map(|from| from.saturating_sub(self.at));
        Some(Times { from, to })
    }

    /// A precedence whose first agent has vanished: where it never was at its cell, that of
    /// the second is closed for ever.
    fn without_first(
        &self,
        index: usize,
        timed: &TimedConstraint,
        agents: &mut [Resumed<'a>],
    ) -> Option<(ConstraintKind, Option<Vec<String>>)> {
        let ConstraintKind::Before { first, second } = &timed.constraint.kind else {
            return None;
        };
        let since = timed.since.unwrap_or(0);
        let mut gone = self.gone.iter();
        let gone = gone.find(|it| it.timeline.name() == first.agent)?;
        let is_bound = timed.is_there(self.at)
            && !timed.constraint.off
            && !gone.is_removed()
            && gone.end() >= since;
        if is_bound && !self.has_been(first.cell, gone) {
            let Visit { agent, cell } = second;
            let mut agents = agents.iter_mut();
            let second = agents.find(|it| it.agent.name == *agent)?;
            second.state.closed_cells.push(ClosedCell {
                cell: *cell,
                until: u32::MAX,
                rule: index,
            });
        }
        None
    }

    /// Closes the cells that agents have just left to the others.
    fn close_behind(
        &self,
        (index, timed): (usize, &TimedConstraint),
        steps: u32,
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) {
        let since = timed.since.unwrap_or(0);
        let is_named = |name: &str| {
            let names = timed.constraint.agents.as_ref();
            names.is_none_or(|names| names.iter().any(|it| it == name))
        };
        let there = bound.iter().filter_map(|&number| agents.get(number)?.past);
        let gone = self.gone.iter().copied();
        let gone = gone.filter(|it| is_named(it.timeline.name()) && it.end() >= since);
        // Each cell with those who were there, each with the last time.
        let mut left: BTreeMap<Cell, BTreeMap<String, u32>> = BTreeMap::new();
        for past in there.chain(gone) {
            for time in self.at.saturating_sub(steps)..self.at {
                if let Some(cell) = past.at(time) {
                    let visitors = left.entry(cell).or_default();
                    visitors.insert(past.timeline.name().to_owned(), time);
                }
            }
        }
        for &number in bound {
            let Some(resumed) = agents.get_mut(number) else {
                continue;
            };
            for (&cell, visitors) in &left {
                let others = visitors
                    .iter()
                    .filter(|(name, _)| **name != resumed.agent.name);
                let last = others.map(|(_, &time)| time).max();
                if let Some(until) = last.and_then(|last| (last + steps).checked_sub(self.at)) {
                    resumed.state.closed_cells.push(ClosedCell {
                        cell,
                        until,
                        rule: index,
                    });
                }
            }
        }
    }

    /// Notes the agents that a rule about a zone does not count until they have left it.
    fn do_not_count(
        &self,
        (index, timed): (usize, &TimedConstraint),
        zone: &str,
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) {
        for &number in bound {
            let Some(resumed) = agents.get_mut(number) else {
                continue;
            };
            let breakdowns = self.breakdowns(resumed);
            let mut begins = timed.since.into_iter().chain(breakdowns);
            if begins.any(|begin| self.is_kept_in(zone, begin, resumed)) {
                resumed.state.uncounted.push(index);
            }
        }
    }

    /// Where an agent faces, and for how long it has stood.
    fn turn(&self, resumed: &mut Resumed<'a>) {
        let Some(past) = &resumed.past else { return };
        let last = self.last_move(past);
        if let Some((_, heading)) = last {
            resumed.agent.heading = heading;
        }
        let since = last.map_or(resumed.timeline.from, |(end, _)| end);
        resumed.state.stood = self.at.saturating_sub(since);
    }

    /// What an agent has paid already, and what it pays if it does not stay where it rested.
    fn pay(&self, resumed: &mut Resumed<'a>) {
        let name = resumed.timeline.name();
        if resumed.past.is_none() {
            let rules = self.history.constraints().iter();
            let rules = rules.filter(|it| it.is_there(self.at) && !it.constraint.off);
            let late = rules.filter_map(|timed| {
                let Constraint { kind, agents, .. } = &timed.constraint;
                let ConstraintKind::Late { by, weight } = kind else {
                    return None;
                };
                let is_bound = agents
                    .as_ref()
                    .is_none_or(|names| names.iter().any(|it| it == name));
                let from = timed.since.unwrap_or(0).max(*by);
                let late = self.at.saturating_sub(from).saturating_mul(*weight);
                is_bound.then_some(late)
            });
            resumed.running.spent.penalty = late.fold(0, u32::saturating_add);
            return;
        }
        let until = |time| penalty_until(self.past, self.plan, name, time);
        let spent = until(self.at - resumed.state.rested);
        resumed.running.spent.penalty = spent;
        resumed.state.penalty_if_it_goes_on = until(self.at).saturating_sub(spent);
    }
}

/// No time at all.
const NEVER: Times = Times {
    from: Some(1),
    to: Some(0),
};
