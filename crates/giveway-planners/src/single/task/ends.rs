//! Where and when an agent begins, and may end.

use super::{Automaton, Mask, Task};
use crate::{
    single::{Place, State},
    terrain::{Terrain, Vertex},
};

impl Task {
    /// The state at time 0; `None` where a condition forbids it.
    pub fn first(&self) -> Option<State> {
        let at = self.transit.is_none().then_some(self.start);
        let counts = self.conditions.first_counts(at)?;
        let mask = self.first_mask() | counts;
        let state = State {
            place: self.first_place(),
            mask,
            battery: self.first_level(),
        };
        if self.reserve.is_some_and(|r| r.initial < self.delay()) {
            return None;
        }
        let now = Some(self.delay());
        self.may_stand(self.start, mask, now).then_some(state)
    }

    /// Whether being at a vertex with these waypoints visited is arriving.
    pub fn is_end(&self, v: Vertex, mask: Mask) -> bool {
        self.may_rest_at(v) && Self::set_of(mask) == self.all()
    }

    /// Whether being at a vertex at a time with these waypoints visited is an arrival
    /// that is allowed.
    pub fn may_end(&self, v: Vertex, mask: Mask, now: u32) -> bool {
        let rests_elsewhere = |&(u, time): &(Vertex, u32)| u != v || now > time;
        self.is_end(v, mask)
            && now >= self.not_before
            && self.not_resting.iter().all(rests_elsewhere)
            && self.conditions.may_end(mask, v, now)
    }

    /// Whether a vertex is its goal; each is one of an agent without a goal.
    pub fn may_rest_at(&self, v: Vertex) -> bool {
        self.goal.is_none_or(|goal| goal == v)
    }

    /// The vertices at which it may end.
    pub fn ends(&self, terrain: &Terrain) -> Vec<Vertex> {
        match (self.goal, self.along()) {
            (Some(goal), _) => vec![goal],
            (None, Some(path)) => path.last().copied().into_iter().collect(),
            (None, None) => (0..terrain.size() as Vertex).collect(),
        }
    }

    /// Where it is once a walk of it is over, where it stays: its goal, or the end of
    /// the walk where it has none.
    pub fn end_of(&self, walk: &[Place]) -> Option<Place> {
        match self.goal {
            Some(goal) => Some(Place::At(goal)),
            None => walk.last().copied(),
        }
    }

    /// Whether the last step of a walk is one of rest: in it, the agent might as
    /// well have arrived.
    pub fn ends_with_rest(&self, walk: &[Place]) -> bool {
        matches!(walk, [.., before, Place::At(v)]
            if *before == Place::At(*v) && self.may_rest_at(*v))
    }

    /// The same task for counting moves: without a battery, and without what is
    /// forbidden, so that every move can be taken back.
    #[must_use]
    pub fn for_moves(&self) -> Self {
        Self {
            reserve: None,
            conditions: Automaton {
                required: self.conditions.required.clone(),
                ..Automaton::default()
            },
            ..self.clone()
        }
    }
}
