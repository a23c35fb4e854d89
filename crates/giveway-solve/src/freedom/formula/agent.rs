//! One agent in clauses: a model has exactly one of its ways, with its charges.
//!
//! Variables are the spots of its [`layers`], "at this place at this time", "charges
//! at this time" and "arrived by this time". All of them are determined by the way
//! and its charges, so that two models differ in them just when the plans do.

mod clauses;

use std::collections::BTreeMap;

use super::{
    layers::{Spot, Steps, layers},
    way::Way,
};
use crate::{
    budget::{Budget, Stop},
    problem::Problem,
    sat::{Clauses, Lit, Sat},
    single::Place,
};

/// One agent inside the formula.
pub(super) struct AgentCode {
    stays: bool,
    /// Where it arrives; `None` where it may rest at any vertex.
    goal: Option<Place>,
    /// A literal that always holds.
    truth: Lit,
    pub(super) cap: u32,
    /// By time: the literal of each place.
    pub(super) places: Vec<BTreeMap<Place, Lit>>,
    /// `by[t]`: arrived by time t, for times before the cap.
    by: Vec<Lit>,
    /// By time: the literal of a charge, where one is possible.
    pub(super) charges: BTreeMap<u32, Lit>,
}

impl AgentCode {
    /// Writes an agent that arrives by its cap.
    pub(super) fn new(
        problem: &Problem,
        agent: usize,
        (cap, truth): (u32, Lit),
        budget: &Budget,
        out: &mut Sat,
    ) -> Result<Self, Stop> {
        let steps = Steps::new(problem, agent);
        let layers = layers(&steps, cap, budget)?;
        let mut spots: Vec<BTreeMap<Spot, Lit>> = Vec::with_capacity(layers.len());
        for layer in layers {
            budget.check()?;
            let spot = |spot| (spot, out.fresh());
            spots.push(layer.into_iter().map(spot).collect());
        }
        let mut code = Self {
            stays: problem.rests(agent),
            goal: problem.tasks[agent].goal.map(Place::At),
            truth,
            cap,
            places: Vec::new(),
            by: Vec::new(),
            charges: BTreeMap::new(),
        };
        code.write_arrivals(&spots, out);
        for layer in &spots {
            budget.check()?;
            code.write_layer(layer, out);
        }
        for (pair, time) in spots.windows(2).zip(0..) {
            budget.check()?;
            Self::write_steps(&steps, time, pair, out);
        }
        code.write_charges(problem, agent, out);
        Ok(code)
    }

    /// "Arrived by a time".
    pub(super) fn by(&self, time: u32) -> Lit {
        self.by.get(time as usize).copied().unwrap_or(self.truth)
    }

    /// "Gone before a time", where agents vanish.
    fn gone(&self, time: u32) -> Lit {
        time.checked_sub(1)
            .map_or(!self.truth, |before| self.by(before))
    }

    /// The literal of a way's entry at a time; `None` where it cannot be there.
    pub(super) fn entry(&self, way: &Way, time: u32) -> Option<Lit> {
        match way.at(time) {
            Some(place) => self.at(time, place),
            None if self.stays => self.at(time, self.goal.or(way.places.last().copied())?),
            None => Some(self.gone(time)),
        }
    }

    /// The time up to its cap at which it is where it is at a time, of an agent that
    /// rests anywhere; any other is at its goal after its cap, or gone.
    fn settled(&self, time: u32) -> u32 {
        if self.stays && self.goal.is_none() {
            time.min(self.cap)
        } else {
            time
        }
    }

    /// "At this place at this time".
    pub(super) fn at(&self, time: u32, place: Place) -> Option<Lit> {
        let time = self.settled(time);
        if time > self.cap {
            return (self.stays && Some(place) == self.goal).then_some(self.truth);
        }
        self.places.get(time as usize)?.get(&place).copied()
    }

    /// Where it may be at a time, with literals.
    pub(super) fn places_at(&self, time: u32) -> Vec<(Place, Lit)> {
        match self.places.get(self.settled(time) as usize) {
            Some(places) => places.iter().map(|(&place, &lit)| (place, lit)).collect(),
            None if self.stays => self
                .goal
                .map(|goal| (goal, self.truth))
                .into_iter()
                .collect(),
            None => Vec::new(),
        }
    }

    /// Whether nothing but one place is possible at a time.
    pub(super) fn is_fixed(&self, time: u32) -> bool {
        let layer = self.places.get(self.settled(time) as usize);
        layer.is_none_or(|places| places.len() == 1 && (self.stays || time == 0))
    }

    /// The way of a model.
    pub(super) fn way(&self, is_true: impl Fn(Lit) -> bool) -> Way {
        let mut way = Way::default();
        for (time, places) in self.places.iter().enumerate() {
            let here = places.iter().find(|&(_, &lit)| is_true(lit));
            let Some((&place, _)) = here else { break };
            way.places.push(place);
            if is_true(self.by(time as u32)) {
                break;
            }
        }
        let charges = self.charges.iter().filter(|&(_, &lit)| is_true(lit));
        way.charges = charges.map(|(&time, _)| time).collect();
        way
    }
}
