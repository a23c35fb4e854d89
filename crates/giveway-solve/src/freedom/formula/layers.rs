//! Where one agent can be at each time, in plans that arrive in time.
//!
//! Unlike the MDDs of the search, which leave out what no better plan needs, the
//! layers hold *every* way from the start to the goal that ends by the cap: also over
//! the goal and back. Rules of one agent are kept, as its task follows them. Batteries are
//! left to the clauses.
//!
//! An agent arrives by entering its goal for the last time, so a spot tells whether it has
//! waited there. Each plan then has one way through the layers.

use std::collections::BTreeSet;

use crate::{
    budget::{Budget, Stop},
    problem::Problem,
    single::{Mask, Place, State, Task},
    terrain::Vertex,
};

/// Where an agent is at a time, and what it has done so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::freedom) enum Spot {
    /// It is on its way, or arrives now.
    Way {
        /// Where it is.
        place: Place,
        /// The waypoints visited, and what rules count.
        mask: Mask,
        /// Whether it has waited at a vertex where it may end.
        waits: bool,
    },
    /// It arrived before: it rests at a vertex, or is gone.
    Over(Option<Vertex>),
}

impl Spot {
    /// Where it is; `None` once it is gone.
    pub(in crate::freedom) const fn place(self) -> Option<Place> {
        match self {
            Self::Way { place, .. } => Some(place),
            Self::Over(Some(v)) => Some(Place::At(v)),
            Self::Over(None) => None,
        }
    }
}

/// An agent with its way from spot to spot.
pub(super) struct Steps<'a> {
    problem: &'a Problem,
    task: Task,
    rests: bool,
}

impl<'a> Steps<'a> {
    pub(super) fn new(problem: &'a Problem, agent: usize) -> Self {
        Self {
            problem,
            task: Task {
                reserve: None,
                ..problem.tasks[agent].clone()
            },
            rests: problem.rests(agent),
        }
    }

    /// The spot at time 0; `None` where a rule forbids it.
    fn first(&self) -> Option<Spot> {
        let State { place, mask, .. } = self.task.first()?;
        let waits = false;
        Some(Spot::Way { place, mask, waits })
    }

    /// Whether the agent may arrive at a spot at a time.
    pub(super) fn may_end(&self, spot: Spot, now: u32) -> bool {
        match spot {
            Spot::Way {
                place: Place::At(v),
                mask,
                waits: false,
            } => self.task.may_end(v, mask, now),
            Spot::Way { .. } | Spot::Over(_) => false,
        }
    }

    /// The spots one step after a spot.
    pub(super) fn onward(&self, spot: Spot, now: u32) -> Vec<Spot> {
        let Spot::Way { place, mask, .. } = spot else {
            return vec![spot];
        };
        let mut spots = Vec::new();
        let battery = 0; // unlimited here
        let from = State {
            place,
            mask,
            battery,
        };
        let terrain = &self.problem.terrain;
        self.task.onward(terrain, from, now, false, |step| {
            let State {
                place: to, mask, ..
            } = step.to;
            let may_end = matches!(to, Place::At(v) if self.task.may_rest_at(v));
            let waits = place == to && may_end;
            spots.push(Spot::Way {
                place: to,
                mask,
                waits,
            });
        });
        if let (Place::At(v), true) = (place, self.may_end(spot, now)) {
            spots.push(Spot::Over(self.rests.then_some(v)));
        }
        spots
    }
}

/// The spots of an agent at each time from 0 to its cap.
pub(super) fn layers(
    steps: &Steps,
    cap: u32,
    budget: &Budget,
) -> Result<Vec<BTreeSet<Spot>>, Stop> {
    let mut reached = vec![steps.first().into_iter().collect::<BTreeSet<Spot>>()];
    for time in 0..cap {
        let mut next = BTreeSet::new();
        for &spot in reached.last().into_iter().flatten() {
            budget.tick()?;
            next.extend(steps.onward(spot, time));
        }
        reached.push(next);
    }
    let mut later = BTreeSet::new();
    for (time, layer) in (0..=cap).rev().zip(reached.iter_mut().rev()) {
        for spot in std::mem::take(layer) {
            budget.tick()?;
            let goes_on = if time == cap {
                matches!(spot, Spot::Over(_)) || steps.may_end(spot, time)
            } else {
                steps.onward(spot, time).iter().any(|to| later.contains(to))
            };
            if goes_on {
                layer.insert(spot);
            }
        }
        later.clone_from(layer);
    }
    Ok(reached)
}
