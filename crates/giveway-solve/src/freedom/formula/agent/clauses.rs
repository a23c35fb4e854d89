//! The clauses of one agent: arrivals, one place at a time, steps, charges.

use std::collections::BTreeMap;

use super::AgentCode;
use crate::{
    encode::at_most_one::AtMostOne,
    freedom::formula::layers::{Spot, Steps},
    problem::Problem,
    sat::{Clauses, Lit},
    single::{Place, Reserve},
};

impl AgentCode {
    /// It has arrived by a time when it is at rest, or gone, one step later.
    pub(super) fn write_arrivals(&mut self, spots: &[BTreeMap<Spot, Lit>], out: &mut impl Clauses) {
        let layers = spots.iter().skip(1).take(self.cap as usize);
        self.by = layers
            .map(|layer| {
                let over = layer
                    .iter()
                    .filter(|(spot, _)| matches!(spot, Spot::Over(_)));
                let over: Vec<Lit> = over.map(|(_, &lit)| lit).collect();
                one_of(&over, out)
            })
            .collect();
    }

    /// It is at exactly one spot at a time.
    pub(super) fn write_layer(&mut self, layer: &BTreeMap<Spot, Lit>, out: &mut impl Clauses) {
        let somewhere: Vec<Lit> = layer.values().copied().collect();
        let mut alone = AtMostOne::default();
        for &lit in &somewhere {
            alone.add(lit, out);
        }
        out.clause(&somewhere);
        let mut by_place: BTreeMap<Place, Vec<Lit>> = BTreeMap::new();
        for (spot, &lit) in layer {
            if let Some(place) = spot.place() {
                by_place.entry(place).or_default().push(lit);
            }
        }
        let places = by_place.into_iter();
        let places = places.map(|(place, lits)| (place, one_of(&lits, out)));
        self.places.push(places.collect());
    }

    /// From each spot it goes on to one that follows; and it comes from one that goes
    /// before.
    pub(super) fn write_steps(
        steps: &Steps,
        time: u32,
        spots: &[BTreeMap<Spot, Lit>],
        out: &mut impl Clauses,
    ) {
        let [here, next] = spots else { return };
        let mut before: BTreeMap<Lit, Vec<Lit>> = BTreeMap::new();
        for (&spot, &lit) in here {
            let mut clause = vec![!lit];
            for to in steps.onward(spot, time) {
                if let Some(&there) = next.get(&to) {
                    clause.push(there);
                    before.entry(there).or_default().push(lit);
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
    pub(super) fn write_charges(
        &mut self,
        problem: &Problem,
        agent: usize,
        out: &mut impl Clauses,
    ) {
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
        // After a charge at s the next one has to be at most at s + 1 + full.
        let later = (full + 1..self.cap).map(|last| (last - full, last));
        for (first, last) in std::iter::once((0, initial)).chain(later) {
            let charges = self.charges.range(first..=last).map(|(_, &lit)| lit);
            let mut clause: Vec<Lit> = charges.collect();
            clause.push(self.by(last));
            out.clause(&clause);
        }
    }
}

/// A literal that holds just when one of some does.
fn one_of(lits: &[Lit], out: &mut impl Clauses) -> Lit {
    if let [one] = lits {
        return *one;
    }
    let any = out.fresh();
    for &lit in lits {
        out.clause(&[!lit, any]);
    }
    let mut clause = vec![!any];
    clause.extend(lits);
    out.clause(&clause);
    any
}
