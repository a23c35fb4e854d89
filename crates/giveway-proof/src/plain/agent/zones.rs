//! Where an agent is, as a rule of the scene's own counts it: in transit at both ends.

use std::collections::BTreeSet;

use giveway_model::condition::Times;
use giveway_model::constraint::{Heading, meant};
use giveway_model::{Cell, sorting};

use super::{Cnf, Lit, Walker};

/// A time of a rule. After the horizon all times are alike: every agent has arrived, and
/// rests or is gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::plain) enum Moment {
    /// A time up to the horizon.
    At(u32),
    /// All times after the horizon.
    After,
}

impl Moment {
    /// The moments of a rule's times. Who is anywhere after the horizon is there at its last
    /// time, too, so that the later times matter only where they are all that there is.
    pub(in crate::plain) fn of(times: Times, last: u32) -> Vec<Self> {
        let times = meant(times);
        if times.first() > last {
            return vec![Self::After];
        }
        (times.first()..=times.last().min(last))
            .map(Self::At)
            .collect()
    }

    /// The time by which the list of names calls it.
    pub(in crate::plain) const fn named(self, last: u32) -> u32 {
        match self {
            Self::At(time) => time,
            Self::After => last.saturating_add(1),
        }
    }
}

impl Walker<'_> {
    /// The number of the agent in the instance.
    pub(in crate::plain) const fn index(&self) -> usize {
        self.world.index
    }

    /// Its name.
    pub(in crate::plain) fn name(&self) -> &str {
        &self.agent.name
    }

    /// Where it faces at first.
    pub(in crate::plain) const fn heading(&self) -> Option<Heading> {
        self.agent.heading
    }

    /// Whether it stays where it arrives.
    pub(in crate::plain) fn keeps(&self) -> bool {
        self.world.instance.keeps(self.agent)
    }

    /// The cells that count for it at a moment, each with the literal that it does: the cell
    /// that it is at, or both ends of the edge over which it is in transit.
    pub(in crate::plain) fn touches(&self, moment: Moment) -> Vec<(Cell, Lit)> {
        let (time, is_after) = match moment {
            Moment::At(time) => (time, false),
            Moment::After => (self.world.last, true),
        };
        if is_after && !self.keeps() {
            return Vec::new();
        }
        let at = self.at.get(time as usize).into_iter().flatten();
        let at = at.map(|(&cell, &here)| (cell, here));
        let transit = self.transit.get(time as usize).into_iter().flatten();
        let ends = transit.flat_map(|(&(u, v), &half)| [(u, half), (v, half)]);
        at.chain(ends.filter(|_| !is_after)).collect()
    }

    /// The literals of which one holds where it is in a zone at a moment.
    pub(in crate::plain) fn inside(&self, zone: &BTreeSet<Cell>, moment: Moment) -> Vec<Lit> {
        let touches = self.touches(moment).into_iter();
        let inside = touches.filter(|(cell, _)| zone.contains(cell));
        sorting::set(inside.map(|(_, lit)| lit))
            .into_iter()
            .collect()
    }

    /// The cells where it may be at a time, each with its literal.
    pub(in crate::plain) fn cells(&self, time: u32) -> impl Iterator<Item = (Cell, Lit)> + '_ {
        let cells = self.at.get(time as usize).into_iter().flatten();
        cells.map(|(&cell, &here)| (cell, here))
    }

    /// The moves that begin at a time: from where, to where, and the literals that hold
    /// together where it makes one.
    pub(in crate::plain) fn moves_from(&self, begin: u32) -> Vec<(Cell, Cell, Vec<Lit>)> {
        let mut moves = Vec::new();
        let grid = self.world.instance.grid();
        for (u, here) in self.cells(begin) {
            for v in grid.neighbours(u) {
                if grid.is_slow_edge(u, v) {
                    let half = self.transit(u, v, begin.saturating_add(1));
                    moves.extend(half.map(|half| (u, v, vec![half])));
                } else {
                    let there = self.at(v, begin.saturating_add(1));
                    moves.extend(there.map(|there| (u, v, vec![here, there])));
                }
            }
        }
        moves
    }

    /// It begins no move at a time: it is at the same cell at the next one, or gone.
    pub(in crate::plain) fn stand(&self, cnf: &mut Cnf, time: u32) {
        let next = time.saturating_add(1);
        for (cell, here) in self.cells(time) {
            let stays = self.at(cell, next).into_iter().chain(self.gone(next));
            cnf.implies(&[here], stays);
        }
    }
}
