//! Batteries without counters: a charge in every window.
//!
//! A full battery lasts `full` steps after the charge, which itself takes none
//! away: charged at s, the next charge or the arrival is at s + full + 1 at the
//! latest. So in any `full + 1` consecutive times there is a charge, or the
//! agent has arrived by the last of them. The first window is as long as the
//! battery lasts at time 0. (Compare the windows of the electric vehicle
//! problems.)
//!
//! Several nodes of one time may be true, and only some of them be on the agent's
//! path. So a charge excludes all nodes of its time that are not at a charger: the
//! path then passes one that is. That is cheaper than to let all nodes of a time
//! exclude each other, and does the same. Only where a charge at *one* charger is
//! required do they exclude each other.

use std::collections::BTreeMap;

use giveway_model::sorting::map;

use crate::{
    sat::{Clauses, Lit},
    single::Reserve,
};

/// The charges of one agent: a literal for each time.
pub(crate) struct BatteryCode {
    reserve: Reserve,
    /// `charges[t]`: it charges at time t.
    charges: Vec<Lit>,
    /// Nodes at chargers, by time.
    places: Vec<Vec<Lit>>,
    /// Nodes that are not at chargers, with their times, which no clause excludes yet.
    elsewhere: Vec<(u32, Lit)>,
    /// The first time whose window is not written yet; windows are named by
    /// their last time.
    next_window: u32,
    /// Charges that must be made, by number.
    required: BTreeMap<usize, RequiredCharge>,
}

/// A charge at one charger, at any time.
#[derive(Default)]
struct RequiredCharge {
    /// Nodes there that have no literal in `charges` yet.
    nodes: Vec<(u32, Lit)>,
    /// It charges there, one literal a node.
    charges: Vec<Lit>,
}

impl BatteryCode {
    /// The charges of an agent, among them the required ones of these numbers.
    pub(crate) fn new(reserve: Reserve, required: impl Iterator<Item = usize>) -> Self {
        Self {
            reserve,
            charges: Vec::new(),
            places: Vec::new(),
            elsewhere: Vec::new(),
            next_window: reserve.initial,
            required: map(required.map(|number| (number, RequiredCharge::default()))),
        }
    }

    /// A node at the charger at which a charge is required. (Where it may be the
    /// arrival, at which nobody charges, the agent has left the charger before,
    /// and a charge then costs the same.)
    pub(crate) fn require(&mut self, number: usize, time: u32, node: Lit) {
        let required = self.required.entry(number).or_default();
        required.nodes.push((time, node));
    }

    /// The charge literals, by time.
    pub(crate) fn charges(&self) -> &[Lit] {
        &self.charges
    }

    /// A node at a charger.
    pub(crate) fn place(&mut self, time: u32, node: Lit) {
        let time = time as usize;
        if self.places.len() <= time {
            self.places.resize(time + 1, Vec::new());
        }
        self.places[time].push(node);
    }

    /// A node that is not at a charger.
    pub(crate) fn elsewhere(&mut self, time: u32, node: Lit) {
        self.elsewhere.push((time, node));
    }

    /// Writes what a later deadline needs. `by(d)` is the literal "arrived by
    /// d", `None` where that is false, and `by(deadline)` is assumed.
    pub(crate) fn grow<C: Clauses>(
        &mut self,
        deadline: u32,
        mut by: impl FnMut(u32, &mut C) -> Option<Lit>,
        out: &mut C,
    ) {
        while self.charges.len() < deadline as usize {
            self.charges.push(out.fresh());
        }
        // Later deadlines may add places, so "a charge is at a charger" holds
        // only under this one.
        let guard = by(deadline, out).map(|lit| !lit);
        for (time, &charge) in self.charges.iter().enumerate() {
            let mut clause = vec![!charge];
            clause.extend(self.places.get(time).into_iter().flatten());
            clause.extend(guard);
            out.clause(&clause);
        }
        let charges = &self.charges;
        self.elsewhere.retain(|&(time, node)| {
            let Some(&charge) = charges.get(time as usize) else {
                return true;
            };
            out.clause(&[!charge, !node]);
            false
        });
        for RequiredCharge { nodes, charges } in self.required.values_mut() {
            nodes.retain(|&(time, node)| {
                let Some(&charge) = self.charges.get(time as usize) else {
                    return true;
                };
                let both = out.fresh();
                out.clause(&[!both, node]);
                out.clause(&[!both, charge]);
                charges.push(both);
                false
            });
            let mut clause = charges.clone();
            clause.extend(guard);
            out.clause(&clause);
        }
        // A window that ends at the deadline or later asks for nothing.
        while self.next_window < deadline {
            let last = self.next_window;
            let length = self.reserve.full + 1;
            let first = (last + 1).saturating_sub(length);
            let mut clause: Vec<Lit> = self.charges[first as usize..=last as usize].to_vec();
            clause.extend(by(last, out));
            out.clause(&clause);
            self.next_window += 1;
            if last == self.reserve.initial {
                self.next_window = self.next_window.max(length);
            }
        }
    }
}
