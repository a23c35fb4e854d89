//! The number of events of one agent over time, in unary.
//!
//! The sequential counter of Sinz (2005), columns made as they are asked for
//! and rows as time goes on. An event may weigh one or two.

use crate::sat::{Clauses, Lit};

/// A counter of events.
#[derive(Default)]
pub(crate) struct EventCounter {
    /// By time: the literals "at least one" and "at least two".
    events: Vec<[Lit; 2]>,
    /// `columns[j].rows[t]`: more than j events up to time t.
    columns: Vec<Column>,
}

struct Column {
    rows: Vec<Lit>,
    /// More than j events at any time; stays the same as time goes on.
    total: Lit,
}

impl EventCounter {
    /// The literals of the events at a time: "at least one", "at least two".
    pub(crate) fn event(&mut self, time: u32, out: &mut impl Clauses) -> [Lit; 2] {
        while self.events.len() <= time as usize {
            let event = [out.fresh(), out.fresh()];
            out.clause(&[!event[1], event[0]]);
            self.events.push(event);
        }
        self.events[time as usize]
    }

    /// Appends the events of the next time, both literals given.
    pub(crate) fn append(&mut self, event: Lit) {
        self.events.push([event, event]);
    }

    /// The number of times that have events.
    pub(crate) fn times(&self) -> usize {
        self.events.len()
    }

    /// The literal "more than `j` events", true whenever there are.
    pub(crate) fn more_than(&mut self, j: usize, out: &mut impl Clauses) -> Lit {
        while self.columns.len() <= j {
            let total = out.fresh();
            if let Some(fewer) = self.columns.last() {
                out.clause(&[!total, fewer.total]);
            }
            self.columns.push(Column {
                rows: Vec::new(),
                total,
            });
        }
        self.extend(out);
        self.columns[j].total
    }

    /// Brings all columns up to the last time.
    pub(crate) fn extend(&mut self, out: &mut impl Clauses) {
        for j in 0..self.columns.len() {
            for time in self.columns[j].rows.len()..self.events.len() {
                self.write(j, time, out);
            }
        }
    }

    fn write(&mut self, j: usize, time: usize, out: &mut impl Clauses) {
        let row = out.fresh();
        let total = self.columns[j].total;
        let [one, two] = self.events[time];
        // More than j before, so more than j now.
        if let Some(before) = time.checked_sub(1) {
            out.clause(&[!self.columns[j].rows[before], row]);
        }
        // One event on top of more than j - 1 before, two on top of more than j - 2.
        for (weight, event) in [(1, one), (2, two)] {
            if weight == 2 && one == two {
                continue;
            }
            if j < weight {
                out.clause(&[!event, row]);
            } else if let Some(before) = time.checked_sub(1) {
                out.clause(&[!event, !self.columns[j - weight].rows[before], row]);
            }
        }
        out.clause(&[!row, total]);
        self.columns[j].rows.push(row);
    }
}
