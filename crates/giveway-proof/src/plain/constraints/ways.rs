//! Rules of moves.

use giveway_model::Cell;
use giveway_model::condition::Times;
use giveway_model::constraint::Heading;

use super::super::agent::Walker;
use super::super::{Cnf, Lit, Name};
use super::Writer;

impl Writer<'_> {
    /// None of the agents moves from a cell of the lane to the one before it.
    pub(super) fn one_way(&self, cnf: &mut Cnf, lane: &[Cell]) {
        for walker in &self.walkers {
            for pair in lane.windows(2) {
                let &[to, from] = pair else { continue };
                for (begins, _) in walker.moves_between(from, to, Times::default()) {
                    cnf.implies(&begins, []);
                }
            }
        }
    }

    /// Each of the agents begins no move before `from`.
    pub(super) fn depart(&self, cnf: &mut Cnf, from: u32) {
        for walker in &self.walkers {
            for time in 0..from.min(self.last()) {
                walker.stand(cnf, time);
            }
        }
    }

    /// Before a move an agent stood for at least `quarter` steps for each quarter turn from
    /// where it faces, which is the direction of its move before.
    pub(super) fn turns(&self, cnf: &mut Cnf, quarter: u32) {
        for walker in &self.walkers {
            let facing = self.facing(cnf, walker);
            for (time, facing) in (0..self.last()).zip(&facing) {
                for (from, to, begins) in walker.moves_from(time) {
                    let Some(next) = Heading::of(from, to) else {
                        continue;
                    };
                    for (&faces, heading) in facing.iter().zip(Heading::ALL) {
                        let steps = quarter.saturating_mul(heading.quarters_to(next));
                        let given = [begins.as_slice(), &[faces]].concat();
                        stood(cnf, walker, (from, time), steps, &given);
                    }
                    if self.is_full(cnf) {
                        return;
                    }
                }
            }
        }
    }

    /// For each time, the literals that an agent faces each direction. Before its first
    /// move it faces its heading, or none.
    fn facing(&self, cnf: &mut Cnf, walker: &Walker<'_>) -> Vec<[Lit; 4]> {
        let name = |heading, time| Name::Facing(self.index(), walker.index(), heading, time);
        let times = 0..=self.last();
        let facing: Vec<[Lit; 4]> = times
            .map(|time| Heading::ALL.map(|heading| cnf.variable(name(heading, time))))
            .collect();
        let faces = |heading: Heading, time: u32| {
            let now = facing.get(time as usize);
            now.and_then(|now| now.get(heading as usize).copied())
        };
        if let Some(heading) = walker.heading() {
            cnf.clause(faces(heading, 0));
        }
        let grid = self.instance.grid();
        for time in 0..self.last() {
            for (from, to, begins) in walker.moves_from(time) {
                let steps = if grid.is_slow_edge(from, to) { 2 } else { 1 };
                let then = Heading::of(from, to).and_then(|heading| faces(heading, time + steps));
                if let Some(then) = then {
                    cnf.implies(&begins, [then]);
                }
            }
            for (cell, here) in walker.cells(time) {
                let Some(still) = walker.at(cell, time + 1) else {
                    continue;
                };
                for heading in Heading::ALL {
                    if let (Some(faces), Some(then)) =
                        (faces(heading, time), faces(heading, time + 1))
                    {
                        cnf.implies(&[faces, here, still], [then]);
                    }
                }
            }
        }
        facing
    }
}

/// Given some literals, an agent that is at a cell at a time stood there for so many steps.
fn stood(cnf: &mut Cnf, walker: &Walker<'_>, (cell, time): (Cell, u32), steps: u32, given: &[Lit]) {
    if steps > time {
        cnf.implies(given, []);
        return;
    }
    for before in time - steps..time {
        cnf.implies(given, walker.at(cell, before));
    }
}
