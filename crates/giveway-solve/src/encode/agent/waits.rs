//! Conditions that an agent does not wait so long.

use super::MddEncoding;
use crate::{
    sat::{Clauses, Lit},
    single::{Automaton, NodeId, Part, Place},
};

impl MddEncoding {
    /// No wait of so many steps on end: of every row of nodes at one vertex that
    /// a new node is part of, one is left out.
    pub(super) fn write_waits(&self, old: NodeId, conditions: &Automaton, out: &mut impl Clauses) {
        let waits = conditions.parts().filter_map(|part| match part {
            Part::LongWait(wait) => (wait.steps > 1).then_some(wait),
            // The MDD keeps to the first, clauses of the battery and of costs to the others.
            Part::Forbidden(_) | Part::Required(..) | Part::Limit(..) => None,
        });
        for wait in waits {
            let steps = wait.steps;
            for id in old..self.mdd.size() {
                let node = self.mdd.node(id);
                let Place::At(v) = node.place else { continue };
                let rows = (node.time.saturating_sub(steps)..=node.time).map(|it| (it, steps));
                // A wait that has begun before time 0 may go on for fewer.
                let begun = (wait.begun > 0).then_some((0, steps - wait.begun));
                for (first, steps) in rows.chain(begun) {
                    if !(first..first + steps).all(|time| wait.counts(v, time)) {
                        continue;
                    }
                    let row = (first..=first + steps)
                        .map(|time| self.mdd.find(time, node.place, node.mask));
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
}
