//! The states and steps of one agent.

use super::{
    Joint,
    event::{Event, follow},
    tally::Tally,
};
use crate::{
    single::{Mask, Place, State},
    terrain::Vertex,
};

/// The state of one agent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Single {
    /// On its way.
    Going {
        place: Place,
        mask: Mask,
        battery: u32,
        /// The time, as far as conditions on the agent look at it.
        clock: u32,
        /// The packed counters of the conditions on the agent.
        count: u32,
    },
    /// Arrived this very time step, under `vanish`: it still holds this vertex.
    Leaving(Vertex),
    /// Arrived for good; it rests at a vertex, or is gone.
    Arrived(Option<Vertex>),
}

/// A step of one agent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Move {
    pub(super) to: Single,
    /// The arc that is crossed in this step.
    pub(super) arc: Option<u32>,
    pub(super) cost: Tally,
}

impl Single {
    pub(super) const fn has_arrived(self) -> bool {
        matches!(self, Self::Leaving(_) | Self::Arrived(_))
    }
}

impl Joint<'_> {
    /// A state, and the arrival that it allows.
    pub(super) fn or_arrived(&self, i: usize, state: Single) -> Vec<Single> {
        let mut choices = vec![state];
        let task = self.task(i);
        if let Single::Going {
            place: Place::At(v),
            mask,
            clock,
            ..
        } = state
            && task.may_end(v, mask, clock)
            && clock <= task.not_after()
        {
            choices.push(if self.problem.rests(self.agents[i]) {
                Single::Arrived(Some(v))
            } else {
                Single::Leaving(v)
            });
        }
        choices
    }

    /// The vertex that an agent holds.
    pub(super) const fn stands(state: Single) -> Option<Vertex> {
        match state {
            Single::Going {
                place: Place::At(v),
                ..
            }
            | Single::Leaving(v)
            | Single::Arrived(Some(v)) => Some(v),
            _ => None,
        }
    }

    pub(super) fn moves(&self, i: usize, state: Single) -> Vec<Move> {
        let Single::Going {
            place,
            mask,
            battery,
            clock,
            count,
        } = state
        else {
            let rests = matches!(state, Single::Arrived(_));
            return vec![Move {
                to: if rests { state } else { Single::Arrived(None) },
                arc: None,
                cost: Tally::default(),
            }];
        };
        let mut moves = Vec::new();
        let task = self.task(i);
        let from = State {
            place,
            mask,
            battery,
        };
        let terrain = &self.problem.terrain;
        for charged in [false, true] {
            let charger = matches!(place, Place::At(u) if task.may_charge(terrain, u, Some(clock)));
            if charged && !(charger && task.reserve.is_some()) {
                continue;
            }
            task.onward(terrain, from, clock, charged, |step| {
                let event = Event {
                    from: place,
                    to: step.to.place,
                    charged,
                    penalty: task.penalty_at(terrain, place, clock),
                };
                let Some((count, mask)) = follow(task, count, [mask, step.to.mask], event) else {
                    return;
                };
                let last = task.last_time();
                if clock >= task.not_after() {
                    return;
                }
                let to = Single::Going {
                    place: step.to.place,
                    mask,
                    battery: step.to.battery,
                    clock: last.map_or(0, |last| (clock + 1).min(last.saturating_add(1))),
                    count,
                };
                let cost = self.costs(event);
                for to in self.or_arrived(i, to) {
                    let arc = step.arc;
                    moves.push(Move { to, arc, cost });
                }
            });
        }
        moves
    }
}
