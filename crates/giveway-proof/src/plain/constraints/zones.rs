//! Rules of a zone.

use std::collections::BTreeSet;

use giveway_model::Cell;
use giveway_model::condition::Times;

use super::super::agent::Moment;
use super::super::{Cnf, Lit, Name, count};
use super::Writer;

impl Writer<'_> {
    /// At each of these times at most `most` of the agents are in the zone.
    pub(super) fn capacity(&self, cnf: &mut Cnf, area: &BTreeSet<Cell>, most: u32, times: Times) {
        let most = most as usize;
        for moment in Moment::of(times, self.last()) {
            let mut agents = Vec::new();
            for walker in &self.walkers {
                let inside = walker.inside(area, moment);
                if !inside.is_empty() {
                    agents.push((walker.index(), inside));
                }
            }
            if agents.len() <= most {
                continue;
            }
            let time = moment.named(self.last());
            let mut counted: Vec<Vec<Lit>> = Vec::new();
            for (agent, inside) in agents {
                let is_in = cnf.variable(Name::Inside(self.index(), agent, time));
                for lit in inside {
                    cnf.implies(&[lit], [is_in]);
                }
                counted.push(vec![is_in]);
            }
            let name = |n| Name::Crowd(self.index(), n, time);
            count::at_most(cnf, &name, &counted, false, most, self.limit);
            if self.is_full(cnf) {
                return;
            }
        }
    }

    /// At none of these times is one of the agents in the zone.
    pub(super) fn closed(&self, cnf: &mut Cnf, area: &BTreeSet<Cell>, times: Times) {
        for moment in Moment::of(times, self.last()) {
            for walker in &self.walkers {
                for lit in walker.inside(area, moment) {
                    cnf.clause([-lit]);
                }
            }
        }
    }

    /// None of the agents makes more than `most` wait steps on end at a cell of the zone
    /// before its arrival.
    pub(super) fn no_waiting(&self, cnf: &mut Cnf, area: &BTreeSet<Cell>, most: u32) {
        let steps = most.saturating_add(1);
        for begin in 0..=self.last() {
            if begin.saturating_add(steps) > self.last() {
                return;
            }
            for walker in &self.walkers {
                for &cell in area {
                    walker.exclude_wait(cnf, cell, begin, steps);
                }
            }
        }
    }
}
