//! A tree by hand as data, as the planner tells its own.

use std::rc::Rc;

use super::{Choice, Hand, Standing};
use crate::cbs::{Fate, Tree, TreeNode, choice::cardinality};

impl Hand<'_> {
    /// The tree as the planner tells its own. The turn of a node that was split is the number
    /// of its split, from 0; the plan that is proved is the last.
    pub fn tree(&self) -> Tree {
        let mut tree = Tree::default();
        for (number, own) in self.nodes.iter().enumerate() {
            let parent = own.parent.and_then(|parent| self.nodes.get(parent));
            let parent = parent.and_then(|parent| parent.node.as_ref());
            let walks = own.node.iter().flat_map(|node| node.walks_beside(parent));
            tree.add(TreeNode {
                id: number as u64,
                parent: own.parent.map(|parent| parent as u64),
                constraint: own.constraint,
                cost: own.cost,
                conflicts: own.conflicts.len(),
                walks: walks
                    .map(|(agent, walk)| (agent, Rc::clone(&walk)))
                    .collect(),
                fate: if own.cost.is_some() {
                    Fate::Open
                } else {
                    Fate::Dead
                },
            });
        }
        for (turn, &choice) in self.splits.iter().enumerate() {
            if let Some(fate) = self.fate(turn, choice) {
                tree.decide(choice.node as u64, fate);
            }
        }
        if let (Standing::Proved { .. }, Some(plan)) = (self.standing(), self.plan()) {
            let turn = self.splits.len() as u64;
            tree.decide(plan as u64, Fate::Best { turn, bypassed: 0 });
        }
        tree
    }

    fn fate(&self, turn: usize, choice: Choice) -> Option<Fate> {
        let own = self.nodes.get(choice.node)?;
        let conflict = *own.conflicts.get(choice.conflict)?;
        let ways = &own.node.as_ref()?.ways;
        Some(Fate::Split {
            turn: turn as u64,
            conflict,
            cardinality: cardinality(self.problem, &conflict, ways),
            bypassed: 0,
        })
    }
}
