//! One agent in clauses: a model has exactly one of its ways, with its charges.
//!
//! Variables are the spots of its [`layers`], "at this place at this time", "charges
//! at this time" and "arrived by this time". All of them are determined by the way
//! and its charges, so that two models differ just when the plans do.

use std::collections::BTreeMap;

use super::{
    layers::{Spot, is_end, layers, onward},
    way::Way,
};
use crate::{
    budget::{Budget, Stop},
    encode::at_most_one::AtMostOne,
    problem::Problem,
    sat::{Clauses, Lit, Sat},
    single::{Place, Reserve, Task},
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
        let layers = layers(problem, agent, cap, budget)?;
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
        code.write_arrivals(problem, agent, &spots, out);
        for time in 0..=cap {
            budget.check()?;
            code.write_layer(time, &spots, out);
            code.write_steps(problem, agent, time, &spots, out);
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

    /// When it has arrived: where it stays, it is at its goal from then on, all
    /// waypoints visited; where it vanishes, that is a choice.
    fn write_arrivals(
        &mut self,
        problem: &Problem,
        agent: usize,
        spots: &[BTreeMap<Spot, Lit>],
        out: &mut Sat,
    ) {
        let task = &problem.tasks[agent];
        self.by = (0..self.cap).map(|_| out.fresh()).collect();
        let Some(goal) = self.goal else {
            self.write_rests(task, spots, out);
            return;
        };
        let end: Spot = (goal, task.all());
        for time in 0..self.cap {
            let (by, next) = (self.by(time), self.by(time + 1));
            out.clause(&[!by, next]);
            let here = spots[time as usize].get(&end).copied();
            match (self.stays, here) {
                (true, None) => out.clause(&[!by]),
                (true, Some(here)) => {
                    out.clause(&[!by, here]);
                    out.clause(&[by, !here, !next]);
                }
                (false, here) => {
                    let mut clause = vec![!by, self.gone(time)];
                    clause.extend(here);
                    out.clause(&clause);
                }
            }
        }
        if self.stays {
            return;
        }
        // Who waits at its goal before it is gone has arrived when that wait began.
        for time in 1..=self.cap {
            let at = |time: u32| spots[time as usize].get(&end).copied();
            if let (Some(before), Some(here)) = (at(time - 1), at(time)) {
                out.clause(&[!before, !here, !self.by(time)]);
            }
        }
    }

    /// When it has arrived, where it rests anywhere: it is at one vertex from then on,
    /// all waypoints visited.
    fn write_rests(&self, task: &Task, spots: &[BTreeMap<Spot, Lit>], out: &mut Sat) {
        for time in 0..self.cap {
            let (by, next) = (self.by(time), self.by(time + 1));
            out.clause(&[!by, next]);
            let mut somewhere = vec![!by];
            for (spot, &here) in &spots[time as usize] {
                if !is_end(task, *spot) {
                    continue;
                }
                somewhere.push(here);
                match spots[time as usize + 1].get(spot) {
                    Some(&still) => {
                        out.clause(&[!by, !here, still]);
                        out.clause(&[by, !here, !still, !next]);
                    }
                    None => out.clause(&[!by, !here]),
                }
            }
            out.clause(&somewhere);
        }
    }

    /// It is at exactly one spot at a time, or gone.
    fn write_layer(&mut self, time: u32, spots: &[BTreeMap<Spot, Lit>], out: &mut Sat) {
        let layer = &spots[time as usize];
        let mut somewhere: Vec<Lit> = layer.values().copied().collect();
        if !self.stays && time > 0 {
            somewhere.push(self.gone(time));
        }
        let mut alone = AtMostOne::default();
        for &lit in &somewhere {
            alone.add(lit, out);
        }
        out.clause(&somewhere);
        let mut by_place: BTreeMap<Place, Vec<Lit>> = BTreeMap::new();
        for (&(place, _), &lit) in layer {
            by_place.entry(place).or_default().push(lit);
        }
        let mut places = BTreeMap::new();
        for (place, lits) in by_place {
            let at = match lits.as_slice() {
                [one] => *one,
                several => {
                    let at = out.fresh();
                    for &lit in several {
                        out.clause(&[!lit, at]);
                    }
                    let mut clause = vec![!at];
                    clause.extend(several);
                    out.clause(&clause);
                    at
                }
            };
            places.insert(place, at);
        }
        self.places.push(places);
    }

    /// From each spot it goes on to one that follows, or is gone; and it comes from
    /// one that goes before.
    fn write_steps(
        &self,
        problem: &Problem,
        agent: usize,
        time: u32,
        spots: &[BTreeMap<Spot, Lit>],
        out: &mut Sat,
    ) {
        let task = &problem.tasks[agent];
        let next = spots.get(time as usize + 1);
        let mut before: BTreeMap<Lit, Vec<Lit>> = BTreeMap::new();
        for (&spot, &lit) in &spots[time as usize] {
            let mut clause = vec![!lit];
            for to in onward(problem, task, spot) {
                if let Some(&there) = next.and_then(|next| next.get(&to)) {
                    clause.push(there);
                    before.entry(there).or_default().push(lit);
                }
            }
            if is_end(task, spot) {
                if self.stays && time == self.cap {
                    continue;
                }
                if !self.stays {
                    clause.push(self.gone(time + 1));
                }
            }
            out.clause(&clause);
        }
        for (there, from) in before {
            let mut clause = vec![!there];
            clause.extend(from);
            out.clause(&clause);
        }
    }

    /// Charges at chargers before the arrival; and in each window of times that a
    /// battery lasts for, a charge or the arrival.
    fn write_charges(&mut self, problem: &Problem, agent: usize, out: &mut Sat) {
        let task = &problem.tasks[agent];
        let Some(Reserve { full, initial }) = task.reserve else {
            return;
        };
        for time in 0..self.cap {
            let places = self.places[time as usize].iter();
            let chargers: Vec<Lit> = places
                .filter(|(place, _)| {
                    matches!(place, Place::At(v)
                        if task.may_charge(&problem.terrain, *v, Some(time)))
                })
                .map(|(_, &lit)| lit)
                .collect();
            if chargers.is_empty() {
                continue;
            }
            let charge = out.fresh();
            let mut clause = vec![!charge];
            clause.extend(chargers);
            out.clause(&clause);
            out.clause(&[!charge, !self.by(time)]);
            self.charges.insert(time, charge);
        }
        // A charge at s lasts up to s + 1 + full, where the next one may be.
        let later = (full + 1..self.cap).map(|last| (last - full, last));
        for (first, last) in std::iter::once((0, initial)).chain(later) {
            let charges = self.charges.range(first..=last).map(|(_, &lit)| lit);
            let mut clause: Vec<Lit> = charges.collect();
            clause.push(self.by(last));
            out.clause(&clause);
        }
    }
}
