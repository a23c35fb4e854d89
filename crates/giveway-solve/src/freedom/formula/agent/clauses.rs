//! The clauses of one agent: arrivals, one place at a time, steps, charges.

use std::collections::BTreeMap;

use super::AgentCode;
use crate::{
    encode::at_most_one::AtMostOne,
    freedom::formula::layers::{Spot, is_end, onward},
    problem::Problem,
    sat::{Clauses, Lit, Sat},
    single::{Place, Reserve, Task},
};

impl AgentCode {
    /// When it has arrived: where it stays, it is at its goal from then on, all
    /// waypoints visited; where it vanishes, that is a choice.
    pub(super) fn write_arrivals(
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
        // An agent that waits at its goal until it vanishes has arrived when that wait began.
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
    pub(super) fn write_layer(&mut self, time: u32, spots: &[BTreeMap<Spot, Lit>], out: &mut Sat) {
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
    pub(super) fn write_steps(
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
    pub(super) fn write_charges(&mut self, problem: &Problem, agent: usize, out: &mut Sat) {
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
