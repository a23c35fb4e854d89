//! Rules of what an agent has to do.

use giveway_model::Cell;
use giveway_model::condition::Times;
use giveway_model::constraint::meant;

use super::super::agent::Walker;
use super::super::{Cnf, Lit, Name};
use super::Writer;

impl Writer<'_> {
    /// The agent is at these cells in this order.
    pub(super) fn sequence(&self, cnf: &mut Cnf, cells: &[Cell]) {
        for walker in &self.walkers {
            // Of the first n cells, at each time, whether they are done.
            let mut done_before: Option<Vec<Lit>> = None;
            for (number, &cell) in (1..).zip(cells) {
                let mut done = Vec::new();
                for time in 0..=self.last() {
                    let name = Name::Reached(self.index(), walker.index(), number, time);
                    let now = cnf.variable(name);
                    let before = done.last().copied();
                    cnf.implies(&[now], before.into_iter().chain(walker.at(cell, time)));
                    if let Some(earlier) = &done_before {
                        cnf.implies(&[now], earlier.get(time as usize).copied());
                    }
                    done.push(now);
                }
                done_before = Some(done);
                if self.is_full(cnf) {
                    return;
                }
            }
            if let Some(done) = done_before {
                cnf.clause(done.last().copied());
            }
        }
    }

    /// Each of the agents is at the cell for `stay` steps on end, within these times.
    pub(super) fn visit(&self, cnf: &mut Cnf, cell: Cell, stay: u32, times: Times) {
        let times = meant(times);
        for walker in &self.walkers {
            let mut visits = Vec::new();
            // Who is there after the last time is so at all later times; the first is enough.
            let end = times.last().min(self.last().max(times.first()));
            for begin in times.first()..=end {
                visits.extend(self.stays(cnf, walker, cell, (begin, stay), times));
                if self.is_full(cnf) {
                    return;
                }
            }
            cnf.clause(visits);
        }
    }

    /// A literal that an agent is at a cell from a time on for so many steps; none where it
    /// cannot be.
    fn stays(
        &self,
        cnf: &mut Cnf,
        walker: &Walker<'_>,
        cell: Cell,
        (begin, stay): (u32, u32),
        times: Times,
    ) -> Option<Lit> {
        let end = begin.saturating_add(stay);
        let rests = end > self.last();
        if end > times.last() || rests && !walker.keeps() {
            return None;
        }
        // After the last time it is where it is then.
        let (first, last) = (begin.min(self.last()), end.min(self.last()));
        let there: Option<Vec<Lit>> = (first..=last).map(|time| walker.at(cell, time)).collect();
        let there = there?;
        let stays = cnf.variable(Name::Stays(self.index(), walker.index(), begin));
        for lit in there {
            cnf.implies(&[stays], [lit]);
        }
        Some(stays)
    }

    /// Each of the agents arrives at one of these times.
    pub(super) fn arrive(&self, cnf: &mut Cnf, times: Times) {
        let times = meant(times);
        for walker in &self.walkers {
            if let Some(by) = times.to {
                cnf.clause(walker.done_by(by));
            }
            if let Some(too_early) = times.first().checked_sub(1) {
                // No plan here arrives after the last time.
                cnf.clause(walker.done_by(too_early).map(|done| -done));
            }
        }
    }
}
