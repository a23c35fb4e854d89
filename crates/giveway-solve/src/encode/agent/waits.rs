//! A question's demand that an agent does not wait so long.

use super::MddEncoding;
use crate::{
    sat::{Clauses, Lit},
    single::{NodeId, Place, TaskConstraint},
};

impl MddEncoding {
    /// No wait of so many steps on end: of every row of nodes at one vertex that
    /// a new node is part of, one is left out.
    pub(super) fn write_waits(&self, old: NodeId, demand: &TaskConstraint, out: &mut impl Clauses) {
        let TaskConstraint::Wait {
            steps: steps @ 2.., ..
        } = *demand
        else {
            return;
        };
        for id in old..self.mdd.size() {
            let node = self.mdd.node(id);
            let Place::At(v) = node.place else { continue };
            for first in node.time.saturating_sub(steps)..=node.time {
                if !(first..first + steps).all(|time| demand.counts_wait(v, time)) {
                    continue;
                }
                let row =
                    (first..=first + steps).map(|time| self.mdd.find(time, node.place, node.mask));
                let Some(row) = row.collect::<Option<Vec<NodeId>>>() else {
                    continue;
                };
                if row.iter().all(|&other| other <= id) {
                    let clause: Vec<Lit> = row.iter().map(|&other| !self.node(other)).collect();
                    out.clause(&clause);
                }
            }
        }
    }
}
