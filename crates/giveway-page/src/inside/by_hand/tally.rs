//! What a tree took: nodes, splits, the first plan, dead ends.

use giveway_solve::plan::{NodeFate, TreeNode};

/// What a tree took.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tally {
    /// All nodes, dead ends among them.
    pub(crate) nodes: u64,
    /// The nodes that were split.
    pub(crate) splits: u64,
    /// How many nodes there were when the first plan was among them.
    pub(crate) first_plan: Option<u64>,
    /// The nodes in which a robot has no way.
    pub(crate) dead_ends: u64,
    /// The cost of its best plan.
    pub(crate) cost: Option<u32>,
}

impl Tally {
    /// What these nodes took, and so many that were not told.
    pub(crate) fn of(nodes: &[TreeNode], left_out: u64) -> Self {
        let all = nodes.len() as u64 + left_out;
        let count = |is: fn(&NodeFate) -> bool| nodes.iter().filter(|node| is(&node.fate)).count();
        let plans = nodes.iter().filter_map(|node| match node.fate {
            // By bypass a node becomes a plan when it is opened.
            NodeFate::Best { .. } if node.conflicts > 0 => Some((all, node.cost?)),
            NodeFate::Open | NodeFate::Best { .. } if node.conflicts == 0 => {
                Some((made_with(node.id), node.cost?))
            }
            _ => None,
        });
        let plans: Vec<(u64, u32)> = plans.collect();
        Self {
            nodes: all,
            splits: count(|fate| matches!(fate, NodeFate::Split { .. })) as u64,
            first_plan: plans.iter().map(|(made, _)| *made).min(),
            dead_ends: count(|fate| matches!(fate, NodeFate::Dead)) as u64,
            cost: plans.iter().map(|(_, cost)| *cost).min(),
        }
    }
}

/// How many nodes there are once this one is made: two come at a time.
const fn made_with(id: u64) -> u64 {
    id.div_ceil(2) * 2 + 1
}

#[cfg(test)]
mod tests {
    use super::made_with;

    #[test]
    fn two_nodes_come_at_a_time() {
        assert_eq!([0, 1, 2, 3, 4].map(made_with), [1, 3, 3, 5, 5]);
    }
}
