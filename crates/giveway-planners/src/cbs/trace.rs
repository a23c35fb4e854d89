//! The constraint tree as data, for whoever wants to see how CBS went.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::{Cardinality, Conflict, Constraint};
use crate::{AgentId, walk::Walk};

/// Nodes that a tree tells at most.
const MOST: usize = 1_000;

/// The fate of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(
    missing_docs,
    reason = "the sentence of a variant says what its fields are"
)]
pub enum Fate {
    /// It waits in the open list.
    Open,
    /// Some agent has no walk that keeps its constraints.
    Dead,
    /// It was taken out as the n-th, from 0, and split at a conflict, after it
    /// took so many times the walks of a child that cost no more (bypass).
    Split {
        turn: u64,
        conflict: Conflict,
        cardinality: Cardinality,
        bypassed: u32,
    },
    /// It was taken out as the n-th and is the answer.
    Best { turn: u64, bypassed: u32 },
}

/// A node of the tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TreeNode {
    /// Its number, in the order in which nodes were made.
    pub id: u64,
    /// The node that it is a child of; `None` for the root.
    pub parent: Option<u64>,
    /// Its own constraint, beside those of its ancestors.
    pub constraint: Option<Constraint>,
    /// The cost of its walks, which no plan that keeps its constraints is below;
    /// `None` where it has no walks.
    pub cost: Option<u32>,
    /// How many conflicts its walks have, as they were made.
    pub conflicts: usize,
    /// The walks that its parent has not; all of the root. Those of a node that was
    /// split are the ones that have the conflict.
    pub walks: BTreeMap<AgentId, Rc<Walk>>,
    /// Its fate.
    pub fate: Fate,
}

/// The first nodes of a constraint tree.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tree {
    /// The nodes, by number.
    pub nodes: Vec<TreeNode>,
    /// How many more there were.
    pub left_out: u64,
}

impl Tree {
    pub(super) fn add(&mut self, node: TreeNode) {
        if self.nodes.len() < MOST {
            self.nodes.push(node);
        } else {
            self.left_out += 1;
        }
    }

    pub(super) fn decide(&mut self, id: u64, fate: Fate) {
        if let Some(node) = self.nodes.get_mut(id as usize) {
            node.fate = fate;
        }
    }

    /// Notes that a node has other walks now.
    pub(super) fn bypass(&mut self, id: u64, walks: impl IntoIterator<Item = (AgentId, Rc<Walk>)>) {
        if let Some(node) = self.nodes.get_mut(id as usize) {
            node.walks.extend(walks);
        }
    }
}
