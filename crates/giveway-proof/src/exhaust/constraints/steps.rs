//! What a step breaks, and what it costs.

use giveway_model::constraint::{ConstraintKind, Heading};
use giveway_model::{Cell, Cost};

use super::super::lone::{Lone, State, Step};
use super::{Record, Watched};

impl Watched<'_> {
    /// Notes the steps that begin at a time; whether the rule can still be kept.
    pub(super) fn leave(
        &self,
        before: &[State],
        steps: &[Step],
        time: u32,
        record: &mut Record,
    ) -> bool {
        let taken = |&agent: &usize| before.get(agent).copied().zip(steps.get(agent).copied());
        let mut taken = self.agents.iter().map(taken).enumerate();
        match (self.kind, record) {
            (ConstraintKind::OneWay { lane }, _) => {
                let against = |(from, to): (Cell, Cell)| {
                    let mut pairs = lane.windows(2);
                    pairs.any(|pair| pair == [to, from])
                };
                taken.all(|(_, it)| !it.and_then(|(_, step)| step.crosses).is_some_and(against))
            }
            (ConstraintKind::Depart { from }, _) => {
                time >= *from || taken.all(|(_, it)| !it.is_some_and(|(_, step)| moves(&step)))
            }
            (ConstraintKind::NoWaiting { most, .. }, Record::Counts(waits)) => {
                taken.zip(waits).all(|((_, it), waits)| {
                    let Some((from, step)) = it else { return true };
                    let here = Lone::cell(from).filter(|cell| self.area.contains(cell));
                    let waits_here = here.is_some() && step.spent[Cost::Waits as usize] > 0;
                    *waits = if waits_here { *waits + 1 } else { 0 };
                    *waits <= *most
                })
            }
            (ConstraintKind::Turns { quarter }, Record::Facing(facing)) => taken
                .zip(facing)
                .all(|((_, it), facing)| it.is_none_or(|(_, step)| turn(*quarter, &step, facing))),
            (
                ConstraintKind::Capacity { .. }
                | ConstraintKind::Closed { .. }
                | ConstraintKind::Gap { .. }
                | ConstraintKind::Apart { .. }
                | ConstraintKind::Sequence { .. }
                | ConstraintKind::Visit { .. }
                | ConstraintKind::Arrive { .. }
                | ConstraintKind::Late { .. }
                | ConstraintKind::Before { .. }
                | ConstraintKind::Avoid { .. }
                | ConstraintKind::NoWaiting { .. }
                | ConstraintKind::Turns { .. },
                _,
            ) => true,
        }
    }

    /// What the agents pay for a time, in which they are on their way.
    pub(super) fn penalty(&self, states: &[State], time: u32) -> u32 {
        let states = self.agents.iter().filter_map(|&agent| states.get(agent));
        let under_way = states.filter(|state| !state.has_arrived());
        let (paying, weight) = match self.kind {
            ConstraintKind::Avoid { weight, .. } => {
                let inside = under_way.filter(|&&state| self.is_inside(state));
                (inside.count(), *weight)
            }
            ConstraintKind::Late { by, weight } if time >= *by => (under_way.count(), *weight),
            ConstraintKind::Late { .. }
            | ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. } => (0, 0),
        };
        weight.saturating_mul(u32::try_from(paying).unwrap_or(u32::MAX))
    }
}

/// Whether a step begins a move.
fn moves(step: &Step) -> bool {
    step.spent[Cost::Moves as usize] > 0
}

/// Notes a step of an agent that turns; whether it has turned far enough for its move.
fn turn(quarter: u32, step: &Step, facing: &mut (Option<Heading>, u32)) -> bool {
    let (faces, stood) = *facing;
    if step.to.has_arrived() {
        // Nothing of it matters any more, but for the step itself.
        *facing = (None, 0);
    } else if moves(step) {
        let next = step.crosses.and_then(|(from, to)| Heading::of(from, to));
        *facing = (next, 0);
    } else if step.crosses.is_none() && faces.is_some() {
        *facing = (faces, (stood + 1).min(quarter.saturating_mul(2)));
    }
    let next = step.crosses.and_then(|(from, to)| Heading::of(from, to));
    let quarters = faces.zip(next).filter(|_| moves(step));
    let quarters = quarters.map_or(0, |(faces, next)| faces.quarters_to(next));
    stood >= quarter.saturating_mul(quarters)
}
