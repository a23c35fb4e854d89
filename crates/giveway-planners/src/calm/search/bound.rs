//! What a walk by way of a label drives at least.

use super::Search;
use crate::calm::{Driving, allowance::Allowance, label::Label};
use crate::local::OtherAgents;
use crate::single::{Place, State};

impl<O: OtherAgents> Search<'_, O> {
    /// The least driving of a walk by way of a label; `None` where it cannot be what is
    /// searched for.
    pub(super) fn bound(&self, label: &Label) -> Option<Driving> {
        let State {
            place,
            mask,
            battery,
        } = label.state;
        let (v, delay) = match place {
            Place::At(v) => (v, 0),
            Place::Along(arc) => (self.problem.terrain.ends(arc).1, 1),
        };
        let cost_to_go = &self.problem.cost_to_go[self.query.agent];
        // All of these steps are in motion: alone, waiting is of no use.
        let rest = cost_to_go.from(v, mask | self.task.bit(v), battery)? + delay;
        let arrival = (label.time + rest).max(self.earliest);
        let motion = label.driving.motion + rest;
        let bound = Driving {
            motion,
            waits: arrival - motion,
            ..label.driving
        };
        let Allowance {
            latest,
            charges,
            moves,
            waits,
        } = self.query.allowance;
        let least_moves = label.moves + (rest - delay).div_ceil(self.steps_of_a_move);
        let keeps = arrival <= latest
            && charges.is_none_or(|most| label.charges <= most)
            && moves.is_none_or(|most| least_moves <= most)
            && waits.is_none_or(|most| label.driving.waits <= most)
            && self.query.calmer_than.is_none_or(|most| bound < most);
        keeps.then_some(bound)
    }
}
