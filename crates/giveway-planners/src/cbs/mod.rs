//! Conflict-based search (CBS): walks planned apart, and a tree of constraints.
//!
//! Sharon et al., "Conflict-based search for optimal multi-agent pathfinding"
//! (2012; 2015). Each node of the tree has a shortest walk of each agent by its
//! constraints. A node whose walks conflict is split in two, the cheapest node
//! first; so the first without a conflict is a best plan. Cardinal conflicts
//! first and bypass are ICBS (Boyarski et al. 2015), the split is disjoint (Li et
//! al. 2019). A scene without a plan is searched for ever, or up to the budget.

mod aim;
pub mod by_hand;
mod choice;
mod conflict;
mod constraint;
mod mdd;
mod node;
mod rulebook;
#[cfg(test)]
mod tests;
mod trace;

use std::cmp::Reverse;
use std::collections::BTreeMap;

pub use aim::{CbsCost, LowerBound, Proved};
pub use choice::Cardinality;
pub use conflict::{Conflict, ConflictKind, Party};
pub use constraint::{Constraint, Rule};
pub use trace::{Fate, Tree, TreeNode};

use crate::{
    budget::{Budget, MemoryUse, Stop},
    problem::Problem,
    walk::Walk,
};
use node::Node;

/// How conflict-based search ended.
#[derive(Debug)]
#[expect(
    missing_docs,
    reason = "the sentence of a variant says what its fields are"
)]
pub enum Ended {
    /// With a best plan.
    Best { walks: Vec<Walk>, proved: Proved },
    /// Nothing is left to look at up to the horizon.
    Horizon { bound: LowerBound },
    /// Early.
    Stopped { stop: Stop, bound: LowerBound },
}

/// The result of a search.
#[derive(Debug)]
pub struct Outcome {
    /// How it ended.
    pub ended: Ended,
    /// The nodes taken out of the open list.
    pub taken: u64,
    /// The constraint tree, where it was asked for.
    pub tree: Option<Tree>,
}

/// Looks for a plan of least cost, no walk longer than the horizon.
pub fn search(
    problem: &Problem,
    aim: CbsCost,
    horizon: u32,
    traced: bool,
    budget: &dyn Budget,
) -> Outcome {
    let mut search = Search {
        problem,
        aim,
        horizon,
        open: BTreeMap::new(),
        made: 0,
        taken: 0,
        least: 0,
        tree: traced.then(Tree::default),
    };
    let ended = search.run(budget);
    let bound = |open| LowerBound::new(problem, aim, open, horizon);
    let ended = match ended {
        Ok(Some(walks)) => Ended::Best {
            walks,
            proved: Proved::new(problem, aim, search.least, horizon),
        },
        Ok(None) => Ended::Horizon { bound: bound(None) },
        Err(stop) => Ended::Stopped {
            stop,
            bound: bound(Some(search.least)),
        },
    };
    Outcome {
        ended,
        taken: search.taken,
        tree: search.tree,
    }
}

/// Cost, then the number of conflicts, then the newest first.
type Key = (u32, usize, Reverse<u64>);

struct Search<'p> {
    problem: &'p Problem,
    aim: CbsCost,
    horizon: u32,
    open: BTreeMap<Key, (Node, MemoryUse)>,
    /// The nodes made, and those taken out.
    made: u64,
    taken: u64,
    /// The cost of the node last taken out: no plan costs less.
    least: u32,
    tree: Option<Tree>,
}

impl Search<'_> {
    fn run(&mut self, budget: &dyn Budget) -> Result<Option<Vec<Walk>>, Stop> {
        self.least = self
            .aim
            .of_arrivals(self.problem, self.problem.optima.iter().copied());
        budget.check()?;
        let root = Node::root(self.problem, self.horizon, budget)?;
        self.push(root, None, budget);
        while let Some(((cost, _, Reverse(id)), (node, _))) = self.open.pop_first() {
            self.least = cost;
            budget.check()?;
            let turn = self.taken;
            self.taken += 1;
            if let Some(walks) = self.expand(node, id, turn, budget)? {
                return Ok(Some(walks));
            }
        }
        Ok(None)
    }

    /// Splits a node, unless its walks are a plan, or become one by those of
    /// children that cost no more.
    fn expand(
        &mut self,
        mut node: Node,
        id: u64,
        turn: u64,
        budget: &dyn Budget,
    ) -> Result<Option<Vec<Walk>>, Stop> {
        let problem = self.problem;
        let mut bypassed = 0;
        loop {
            let chosen = choice::choose(problem, &node.conflicts, &node.ways);
            let Some((&conflict, cardinality)) = chosen else {
                self.decide(id, Fate::Best { turn, bypassed });
                let walks = node.ways.iter().enumerate();
                let arrived =
                    |(agent, way): (usize, &node::Way)| arrived(problem, agent, &way.walk);
                return Ok(Some(walks.map(arrived).collect()));
            };
            let mut children = Vec::new();
            for constraint in conflict.split() {
                let child = node.child(problem, constraint, self.horizon, budget)?;
                children.push((constraint, child));
            }
            let calmer = children.iter_mut().find_map(|(_, child)| {
                let fewer = |child: &Node| child.conflicts.len() < node.conflicts.len();
                let as_soon = |child: &Node| child.arrivals().eq(node.arrivals());
                child.take_if(|child| fewer(child) && as_soon(child))
            });
            if let Some(child) = calmer {
                // It keeps all constraints of the node, too.
                if let Some(tree) = &mut self.tree {
                    tree.bypass(id, child.walks_beside(Some(&node)));
                }
                node.ways = child.ways;
                node.conflicts = child.conflicts;
                bypassed += 1;
                continue;
            }
            let fate = Fate::Split {
                turn,
                conflict,
                cardinality,
                bypassed,
            };
            self.decide(id, fate);
            for (constraint, child) in children {
                self.push(child, Some((id, constraint, &node)), budget);
            }
            return Ok(None);
        }
    }

    /// Opens a node, where it has walks.
    fn push(
        &mut self,
        node: Option<Node>,
        from: Option<(u64, Constraint, &Node)>,
        budget: &dyn Budget,
    ) {
        let id = self.made;
        self.made += 1;
        let cost = node
            .as_ref()
            .map(|node| self.aim.of_arrivals(self.problem, node.arrivals()));
        let conflicts = node.as_ref().map_or(0, |node| node.conflicts.len());
        let parent = from.map(|(.., parent)| parent);
        if let Some(tree) = &mut self.tree {
            tree.add(TreeNode {
                id,
                parent: from.map(|(parent, ..)| parent),
                constraint: from.map(|(_, constraint, _)| constraint),
                cost,
                conflicts,
                walks: node
                    .iter()
                    .flat_map(|node| node.walks_beside(parent))
                    .collect(),
                fate: if cost.is_some() {
                    Fate::Open
                } else {
                    Fate::Dead
                },
            });
        }
        if let Some((cost, node)) = cost.zip(node) {
            let held = budget.hold(node.bytes());
            self.open
                .insert((cost, conflicts, Reverse(id)), (node, held));
        }
    }

    fn decide(&mut self, id: u64, fate: Fate) {
        if let Some(tree) = &mut self.tree {
            tree.decide(id, fate);
        }
    }
}

/// A walk up to its arrival: without the waits at the goal at its end, in which
/// the agent might as well have arrived.
fn arrived(problem: &Problem, agent: usize, walk: &Walk) -> Walk {
    let mut walk = walk.clone();
    while problem.tasks[agent].ends_with_rest(&walk) {
        walk.pop();
    }
    walk
}
