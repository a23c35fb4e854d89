//! What the places of agents break, and what they have done by being there.

use giveway_model::Cell;
use giveway_model::constraint::{ConstraintKind, meant};

use super::super::lone::{Lone, State, Step};
use super::{Record, Watched};

impl Watched<'_> {
    /// Notes where the agents come to at a time; whether the rule can still be kept.
    pub(super) fn come(
        &self,
        before: Option<&[State]>,
        steps: &[Step],
        time: u32,
        record: &mut Record,
    ) -> bool {
        let state = |&agent: &usize| steps.get(agent).map(|step| step.to);
        let states: Vec<State> = self.agents.iter().filter_map(state).collect();
        let cell = |agent: usize| steps.get(agent).and_then(|step| Lone::cell(step.to));
        match (self.kind, record) {
            (ConstraintKind::Capacity { most, times, .. }, _) => {
                let inside = states.iter().filter(|&&state| self.is_inside(state));
                !meant(*times).contains(time) || inside.count() <= *most as usize
            }
            (ConstraintKind::Closed { times, .. }, _) => {
                let mut states = states.iter();
                !meant(*times).contains(time) || !states.any(|&state| self.is_inside(state))
            }
            (ConstraintKind::Apart { distance, times }, _) => {
                !meant(*times).contains(time) || are_apart(&states, *distance)
            }
            (ConstraintKind::Gap { steps }, Record::Visitors(visitors)) => {
                visitors.retain(|_, (_, age)| {
                    *age += 1;
                    *age <= *steps
                });
                let here = self.agents.iter();
                let here = here.filter_map(|&agent| Some((agent, cell(agent)?)));
                let mut here = here.map(|(agent, cell)| {
                    visitors
                        .insert(cell, (agent, 0))
                        .is_none_or(|(last, _)| last == agent)
                });
                here.all(|is_free| is_free)
            }
            (ConstraintKind::Sequence { cells, .. }, Record::Counts(done)) => {
                for (&agent, done) in self.agents.iter().zip(done) {
                    let here = cell(agent);
                    while here.is_some() && cells.get(*done as usize).copied() == here {
                        *done += 1;
                    }
                }
                true
            }
            (
                ConstraintKind::Visit {
                    cell: at,
                    stay,
                    times,
                },
                Record::Counts(runs),
            ) => {
                let is_then = meant(*times).contains(time);
                for (&agent, run) in self.agents.iter().zip(runs) {
                    if *run <= *stay {
                        let there = is_then && cell(agent) == Some(*at);
                        *run = if there { *run + 1 } else { 0 };
                    }
                }
                true
            }
            (ConstraintKind::Arrive { times }, _) => self.agents.iter().all(|&agent| {
                let from = before.and_then(|before| before.get(agent));
                let has_come = steps.get(agent).is_some_and(|step| step.to.has_arrived())
                    && !from.is_some_and(|from| from.has_arrived());
                !has_come || meant(*times).contains(time)
            }),
            (ConstraintKind::Before { first, second }, Record::Been(been)) => {
                let Some((one, other)) = self.pair else {
                    return true;
                };
                let is_early = cell(other) == Some(second.cell) && !*been;
                *been |= cell(one) == Some(first.cell);
                !is_early
            }
            (
                ConstraintKind::OneWay { .. }
                | ConstraintKind::Late { .. }
                | ConstraintKind::Depart { .. }
                | ConstraintKind::NoWaiting { .. }
                | ConstraintKind::Turns { .. }
                | ConstraintKind::Avoid { .. }
                | ConstraintKind::Gap { .. }
                | ConstraintKind::Sequence { .. }
                | ConstraintKind::Visit { .. }
                | ConstraintKind::Before { .. },
                _,
            ) => true,
        }
    }

    /// Whether what the rule demands has been done.
    pub(super) fn is_done(&self, record: &Record) -> bool {
        match (self.kind, record) {
            (ConstraintKind::Sequence { cells, .. }, Record::Counts(done)) => {
                done.iter().all(|&done| done as usize == cells.len())
            }
            (ConstraintKind::Visit { stay, .. }, Record::Counts(runs)) => {
                runs.iter().all(|run| run > stay)
            }
            (
                ConstraintKind::Capacity { .. }
                | ConstraintKind::Closed { .. }
                | ConstraintKind::OneWay { .. }
                | ConstraintKind::Gap { .. }
                | ConstraintKind::Apart { .. }
                | ConstraintKind::Arrive { .. }
                | ConstraintKind::Late { .. }
                | ConstraintKind::Depart { .. }
                | ConstraintKind::Before { .. }
                | ConstraintKind::NoWaiting { .. }
                | ConstraintKind::Turns { .. }
                | ConstraintKind::Avoid { .. }
                | ConstraintKind::Sequence { .. }
                | ConstraintKind::Visit { .. },
                _,
            ) => true,
        }
    }
}

/// Whether any two agents have at least a distance.
fn are_apart(states: &[State], distance: u32) -> bool {
    let touches: Vec<Vec<Cell>> = states
        .iter()
        .map(|&it| Lone::touches(it).collect())
        .collect();
    touches.iter().enumerate().all(|(i, cells)| {
        let others = touches.iter().take(i).flatten();
        let mut pairs = others.flat_map(|other| cells.iter().map(move |cell| (cell, other)));
        pairs.all(|(a, b)| a.x.abs_diff(b.x) + a.y.abs_diff(b.y) >= distance)
    })
}
