//! What the steps of one agent cost in all, where steps cost different amounts.
//!
//! The sequential counter of Sinz (2005) with weights (Hölldobler, Manthey and
//! Steinke 2012): a column for each amount that is asked about, and for those that are
//! less than it by a weight.

use std::collections::{BTreeMap, BTreeSet};

use crate::sat::{Clauses, Lit};

/// A counter of weighted events, in units.
#[derive(Default)]
pub(crate) struct WeightedCounter {
    /// By time: the literals "at least so much", by amount.
    events: Vec<BTreeMap<u32, Lit>>,
    /// By amount `j`: "more than `j` up to a time".
    columns: BTreeMap<u32, Column>,
}

struct Column {
    rows: Vec<Lit>,
    /// More than that at any time; stays the same as time goes on.
    total: Lit,
    /// The events that rows know so far, by time.
    known: BTreeSet<(u32, u32)>,
}

impl WeightedCounter {
    /// The literal of an event of a weight at a time.
    pub(crate) fn event(&mut self, time: u32, weight: u32, out: &mut impl Clauses) -> Lit {
        while self.events.len() <= time as usize {
            self.events.push(BTreeMap::new());
        }
        let events = &mut self.events[time as usize];
        *events.entry(weight).or_insert_with(|| out.fresh())
    }

    /// The literal "more than `j`", true whenever that is so.
    pub(crate) fn more_than(&mut self, j: u32, out: &mut impl Clauses) -> Lit {
        self.columns.entry(j).or_insert_with(|| Column {
            rows: Vec::new(),
            total: out.fresh(),
            known: BTreeSet::new(),
        });
        self.extend(out);
        self.columns[&j].total
    }

    /// Makes all columns know all events.
    pub(crate) fn extend(&mut self, out: &mut impl Clauses) {
        let weights: BTreeSet<u32> = self
            .events
            .iter()
            .flat_map(BTreeMap::keys)
            .copied()
            .collect();
        let mut open: Vec<u32> = self.columns.keys().copied().collect();
        while let Some(j) = open.pop() {
            for weight in &weights {
                if let Some(less) = j.checked_sub(*weight)
                    && !self.columns.contains_key(&less)
                {
                    let column = Column {
                        rows: Vec::new(),
                        total: out.fresh(),
                        known: BTreeSet::new(),
                    };
                    self.columns.insert(less, column);
                    open.push(less);
                }
            }
        }
        let amounts: Vec<u32> = self.columns.keys().copied().collect();
        for j in amounts {
            self.extend_rows(j, out);
        }
        for j in self.columns.keys().copied().collect::<Vec<u32>>() {
            self.write(j, out);
        }
    }

    /// Gives a column a row for each time.
    fn extend_rows(&mut self, j: u32, out: &mut impl Clauses) {
        let times = self.events.len();
        let Some(column) = self.columns.get_mut(&j) else {
            return;
        };
        while column.rows.len() < times {
            let row = out.fresh();
            if let Some(&before) = column.rows.last() {
                out.clause(&[!before, row]);
            }
            out.clause(&[!row, column.total]);
            column.rows.push(row);
        }
    }

    /// Writes what the events that are new to a column make of it.
    fn write(&mut self, j: u32, out: &mut impl Clauses) {
        let mut known = BTreeSet::new();
        let column = &self.columns[&j];
        for (time, events) in self.events.iter().enumerate() {
            let row = column.rows[time];
            for (&weight, &event) in events {
                let key = (time as u32, weight);
                if column.known.contains(&key) {
                    continue;
                }
                known.insert(key);
                match j.checked_sub(weight) {
                    None => out.clause(&[!event, row]),
                    Some(less) => {
                        let before = time.checked_sub(1);
                        if let Some(before) = before
                            && let Some(less) = self.columns.get(&less)
                        {
                            out.clause(&[!event, !less.rows[before], row]);
                        }
                    }
                }
            }
        }
        if let Some(column) = self.columns.get_mut(&j) {
            column.known.extend(known);
        }
    }
}
