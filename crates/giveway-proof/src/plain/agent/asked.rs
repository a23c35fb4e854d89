//! The literals of one agent that others ask for: conditions, and agents that meet.

use giveway_model::Cell;
use giveway_model::condition::Times;

use super::{Cnf, Lit, Walker};

impl Walker<'_> {
    /// The literal that it is at a cell at a time, where it can be.
    pub(in crate::plain) fn at(&self, cell: Cell, time: u32) -> Option<Lit> {
        self.at.get(time as usize)?.get(&cell).copied()
    }

    /// The literal that it is half way of a slow move at a time, where it can be.
    pub(in crate::plain) fn transit(&self, u: Cell, v: Cell, time: u32) -> Option<Lit> {
        self.transit.get(time as usize)?.get(&(u, v)).copied()
    }

    /// The literal that it has vanished at a time, where agents vanish: it
    /// arrived before.
    pub(super) fn gone(&self, time: u32) -> Option<Lit> {
        if self.world.instance.keeps(self.agent) {
            return None;
        }
        self.done.get((time as usize).checked_sub(1)?).copied()
    }

    /// The last time.
    pub(in crate::plain) fn last(&self) -> u32 {
        self.world.last
    }

    /// The literal that it has arrived at a time or before; later than the last
    /// time it has in any case, as it has then.
    pub(in crate::plain) fn done_by(&self, time: u32) -> Option<Lit> {
        self.done.get(time.min(self.world.last) as usize).copied()
    }

    /// It does not stay at this cell in the end.
    pub(in crate::plain) fn exclude_rest(&self, cnf: &mut Cnf, cell: Cell) {
        match self.agent.goal {
            Some(goal) if self.world.instance.stays() && goal == cell => cnf.clause([]),
            Some(_) => {}
            None => {
                if let Some(there) = self.at(cell, self.world.last) {
                    cnf.clause([-there]);
                }
            }
        }
    }

    /// The literals that it is at a cell at one of some times.
    pub(in crate::plain) fn visits(&self, cell: Cell, times: Times) -> Vec<Lit> {
        let times = times.first()..=times.last().min(self.world.last);
        times.filter_map(|time| self.at(cell, time)).collect()
    }

    /// The literals that it charges, with their times.
    pub(in crate::plain) fn charging(&self) -> Vec<(Lit, u32)> {
        let charges = self.charge.iter().zip(0..);
        charges
            .filter_map(|(charge, time)| Some(((*charge)?, time)))
            .collect()
    }

    /// It does not wait at a cell for so many steps from a time on, before its
    /// arrival.
    pub(in crate::plain) fn exclude_wait(&self, cnf: &mut Cnf, cell: Cell, begin: u32, steps: u32) {
        let there: Option<Vec<Lit>> = (begin..=begin + steps)
            .map(|time| self.at(cell, time))
            .collect();
        if let Some(there) = there {
            cnf.implies(&there, [self.done[(begin + steps) as usize - 1]]);
        }
    }

    /// The literals of its moves from one cell to another at one of some times; all literals of an entry hold
    /// together.
    pub(in crate::plain) fn moves_between(
        &self,
        u: Cell,
        v: Cell,
        times: Times,
    ) -> Vec<(Vec<Lit>, u32)> {
        let grid = self.world.instance.grid();
        let mut moves = Vec::new();
        if !u.touches(v) {
            return moves;
        }
        for begin in (0..self.world.last).filter(|&begin| times.contains(begin)) {
            if grid.is_slow_edge(u, v) {
                let half = self.transit(u, v, begin + 1);
                moves.extend(half.map(|half| (vec![half], begin)));
            } else if let (Some(here), Some(there)) = (self.at(u, begin), self.at(v, begin + 1)) {
                moves.push((vec![here, there], begin));
            }
        }
        moves
    }

    /// The literals of its slow moves, over one edge either way or over any.
    pub(in crate::plain) fn slow_moves(
        &self,
        edge: Option<(Cell, Cell)>,
        times: Times,
    ) -> Vec<Lit> {
        let asked = |&(u, v): &(Cell, Cell)| edge.is_none_or(|e| e == (u, v) || e == (v, u));
        let halves = self.transit.iter().zip(0u32..);
        let begun = halves.filter(|(_, half)| times.contains(half.saturating_sub(1)));
        begun
            .flat_map(|(moves, _)| moves)
            .filter(|(edge, _)| asked(edge))
            .map(|(_, &half)| half)
            .collect()
    }
}
