//! The rules of a scene's own on the rest of a plan.
//!
//! A rule becomes one in times from 0, with the same number. What was done already goes
//! into the rule where its kind can say it (the rest of a sequence; agents that still have
//! to visit a cell), and else into the agents' [start states](StartState). Rules that are
//! met, past or removed are off.

mod alone;
mod between;
mod progress;

use super::RunningAgent;
use crate::change::{History, Timeline, Trajectory};
use crate::condition::Times;
use crate::constraint::{ConstraintKind, MAX_NUMBER, TimedConstraint};
use crate::{Agent, Constraint, Plan, StartState};

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
                let left = self.still_to_visit(index, (*cell, *stay, *times), bound, agents);
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
                self.judge_rests((index, timed), *times, bound, agents);
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
                self.count_waits((index, timed), zone, bound, agents);
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
}

/// No time at all.
const NEVER: Times = Times {
    from: Some(1),
    to: Some(0),
};
