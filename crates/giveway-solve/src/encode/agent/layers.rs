//! The agent is somewhere at each time: a clause for each small layer of its MDD.
//!
//! Successor clauses imply it, but unit propagation does not see it where ways fork
//! and join again: that all nodes of a layer but one are forbidden, so that this one
//! must be used, is learnt only after conflicts.

use std::collections::BTreeSet;

use super::MddEncoding;
use crate::{
    sat::{Clauses, Lit},
    single::NodeId,
};

/// The most nodes of a layer that has a clause.
const MOST_NODES: usize = 30;

impl MddEncoding {
    /// One of the nodes of each layer that has grown, or arrived before, under the
    /// deadline as it is now.
    pub(super) fn write_layers(&mut self, old: NodeId, deadline: u32, out: &mut impl Clauses) {
        let mut grown = BTreeSet::new();
        for id in old..self.mdd.size() {
            let time = self.mdd.node(id).time;
            let layer = time as usize;
            if self.layers.len() <= layer {
                self.layers.resize(layer + 1, Vec::new());
            }
            self.layers[layer].push(self.nodes[id as usize]);
            // An agent that vanishes on arrival is nowhere from then on; one whose rests are
            // written on would need all of them here.
            if self.stays && !self.rests_on || time <= self.optimum {
                grown.insert(layer);
            }
        }
        let Some(by) = self.by(deadline, out) else {
            return;
        };
        for layer in grown {
            let nodes = &self.layers[layer];
            if !(2..=MOST_NODES).contains(&nodes.len()) {
                continue;
            }
            let mut clause: Vec<Lit> = nodes.clone();
            if !self.rests_on {
                clause.extend(self.resting(layer as u32).map(|(_, rest)| rest));
            }
            clause.push(!by);
            out.clause(&clause);
        }
    }
}
