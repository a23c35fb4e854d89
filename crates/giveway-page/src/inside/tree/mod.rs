//! The constraint tree from left to right: where each node stands, what it says, and
//! which nodes are folded.

mod boxes;

use std::collections::BTreeMap;

use giveway_solve::plan::TreeNode;

use super::by_hand::HandRun;
use super::{Method, TreeRun, by_hand};
use crate::State;

/// Larger trees show the path to the node that is chosen, and fold the rest.
const MOST: usize = 60;
/// So many nodes before the chosen one are shown of a path that is long.
const BEFORE: usize = 12;

/// The size of a node, and from one to the next, in pixels.
const SIZE: (f64, f64) = (152.0, 38.0);
const STEP: (f64, f64) = (186.0, 44.0);
/// The room around the tree: a form stands on the left edge of a node.
const MARGIN: (f64, f64) = (12.0, 6.0);

/// The tree as it is drawn, in pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TreeView {
    /// The nodes, each after its parent.
    pub nodes: Vec<NodeBox>,
    /// The `d` of the lines to nodes, and of those to the chosen one.
    pub lines: [String; 2],
    /// The branches that a split by hand would make, and the `d` of the lines to them.
    pub ghosts: Vec<NodeBox>,
    /// The `d` of the lines to them.
    pub ghost_lines: String,
    /// What is folded.
    pub folds: Vec<Fold>,
    /// How wide and high all of it is.
    pub size: (f64, f64),
}

/// A node as it is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NodeBox {
    /// Its number.
    pub id: u64,
    /// Its upper left corner.
    pub at: (f64, f64),
    /// Its cost; a dash where an agent has no path.
    pub cost: String,
    /// What it says, in two lines.
    pub lines: [String; 2],
    /// The robot that its constraint is about.
    pub agent: Option<usize>,
    /// Its class in the style sheet.
    pub class: &'static str,
    /// Whether it is the chosen one.
    pub is_chosen: bool,
    /// What is said of it.
    pub name: String,
    /// How deep it is, from 1.
    pub level: usize,
    /// Which one it is of how many children of its parent, from 1.
    pub place: (usize, usize),
    /// Whether its children are shown; `None` where it has none.
    pub is_expanded: Option<bool>,
}

/// Nodes that are folded.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    /// Where that is said: the middle of the left end.
    pub at: (f64, f64),
    /// How many.
    pub count: usize,
}

impl NodeBox {
    /// How wide and high it is, in pixels.
    pub const SIZE: (f64, f64) = SIZE;
}

/// The tree of the scene on the board; `None` where it is not looked at, or not known.
pub fn view(state: &State) -> Option<TreeView> {
    if !state.is_inside() || state.inside.method != Method::Tree {
        return None;
    }
    let mut drawn = if state.inside.by_hand.is_on {
        let run = state.hand_run()?;
        let mut drawn = Drawn::new(state, &run.tree, run.asked.node);
        drawn.by_hand = Some(run);
        drawn
    } else {
        let tree = state.looked()?.tree.as_ref()?.as_ref().ok()?;
        Drawn::new(state, tree, state.inside.node)
    };
    drawn.add(0, 0, (1, 1));
    let Drawn { mut view, rows, .. } = drawn;
    let all = view.nodes.iter().chain(&view.ghosts);
    let right = all.map(|node| node.at.0).fold(0.0, f64::max);
    let folds = if view.folds.is_empty() { 0.0 } else { 64.0 };
    view.size = (
        right + SIZE.0 + MARGIN.0 + folds,
        rows as f64 * STEP.1 + 2.0 * MARGIN.1,
    );
    Some(view)
}

/// A tree that is being drawn.
struct Drawn<'a> {
    state: &'a State,
    tree: &'a TreeRun,
    /// The search by hand that it is of.
    by_hand: Option<&'a HandRun>,
    chosen: u64,
    /// The nodes from the root to the chosen one.
    path: Vec<u64>,
    /// How many of them are folded after the root.
    skipped: usize,
    /// How many nodes each has below it, itself counted; of a large tree.
    sizes: Option<BTreeMap<u64, usize>>,
    /// The rows that are taken.
    rows: usize,
    view: TreeView,
}

impl<'a> Drawn<'a> {
    fn new(state: &'a State, tree: &'a TreeRun, chosen: u64) -> Self {
        let mut path: Vec<u64> = tree.lineage(chosen).iter().map(|node| node.id).collect();
        path.reverse();
        let is_large = tree.nodes.len() > MOST;
        let skipped = if is_large {
            path.len().saturating_sub(BEFORE + 2)
        } else {
            0
        };
        Self {
            state,
            tree,
            by_hand: None,
            chosen,
            path,
            skipped,
            sizes: is_large.then(|| sizes(&tree.nodes)),
            rows: 0,
            view: TreeView::default(),
        }
    }

    /// Adds a node and what is shown below it; its middle, from above.
    fn add(&mut self, id: u64, depth: usize, place: (usize, usize)) -> f64 {
        let Some(node) = self.tree.node(id) else {
            return 0.0;
        };
        let children = self.shown_below(id);
        let slot = self.view.nodes.len();
        let x = MARGIN.0 + depth as f64 * STEP.0;
        self.view
            .nodes
            .push(self.node_box(node, place, !children.is_empty()));
        let mut middles = Vec::new();
        let count = children.len();
        // After the root the path may go on further down.
        let next = depth + 1 + usize::from(id == 0 && self.skipped > 0);
        for (index, child) in children.into_iter().enumerate() {
            let place = match id {
                0 if self.skipped > 0 => (1, 1),
                _ => (index + 1, count),
            };
            middles.push((child, self.add(child, next, place)));
        }
        let middle = match middles.as_slice() {
            [] if id == self.chosen && self.sprout(node, x) => {
                MARGIN.1 + (self.rows as f64 - 1.0) * STEP.1
            }
            [] => {
                self.rows += 1;
                MARGIN.1 + (self.rows as f64 - 0.5) * STEP.1
            }
            [(_, only)] => *only,
            [(_, first), .., (_, last)] => f64::midpoint(*first, *last),
        };
        for (child, below) in middles {
            let is_on = self.path.contains(&child);
            let (from, to) = (x + SIZE.0, MARGIN.0 + next as f64 * STEP.0);
            self.view.lines[usize::from(is_on)] += &line((from, middle), (to, below));
        }
        self.view.nodes[slot].at = (x, middle - SIZE.1 / 2.0);
        self.view.nodes[slot].level = depth + 1;
        self.fold(id, (x + SIZE.0 + 8.0, middle));
        middle
    }

    /// Adds the branches that a split by hand would make of a node at this place, if any.
    fn sprout(&mut self, node: &TreeNode, x: f64) -> bool {
        let ghosts = match self.by_hand {
            Some(_) => by_hand::sprout(self.state, node.id),
            None => Vec::new(),
        };
        let count = ghosts.len();
        let (from, to) = (x + SIZE.0, x + STEP.0);
        let middle = MARGIN.1 + (self.rows as f64 + count as f64 / 2.0) * STEP.1;
        for ghost in ghosts {
            let below = MARGIN.1 + (self.rows as f64 + 0.5) * STEP.1;
            self.view.ghost_lines += &line((from, middle), (to, below));
            self.rows += 1;
            self.view.ghosts.push(NodeBox {
                at: (to, below - SIZE.1 / 2.0),
                cost: ghost.cost,
                lines: ghost.lines,
                agent: ghost.agent,
                class: if ghost.is_dead { "ghost dead" } else { "ghost" },
                ..NodeBox::default()
            });
        }
        count > 0
    }

    /// The children of a node that are shown: of a large tree only those along the
    /// path to the chosen node.
    fn shown_below(&self, id: u64) -> Vec<u64> {
        let children = self.tree.children(id);
        if self.sizes.is_none() {
            return children.to_vec();
        }
        if id == 0 && self.skipped > 0 {
            return self
                .path
                .get(1 + self.skipped)
                .copied()
                .into_iter()
                .collect();
        }
        if self.path.contains(&id) {
            children.to_vec()
        } else {
            Vec::new()
        }
    }

    /// Says how many nodes below a node are not shown.
    fn fold(&mut self, id: u64, at: (f64, f64)) {
        let Some(sizes) = &self.sizes else { return };
        let size = |id: &u64| sizes.get(id).copied().unwrap_or(1);
        let count = if id == 0 && self.skipped > 0 {
            let shown = self.path.get(1 + self.skipped);
            size(&0) - 1 - shown.map_or(0, size)
        } else if self.path.contains(&id) {
            0
        } else {
            size(&id) - 1
        };
        if count > 0 {
            self.view.folds.push(Fold { at, count });
        }
    }
}

/// The `d` of a line from a node to one on its right.
fn line((from, middle): (f64, f64), (to, below): (f64, f64)) -> String {
    let bend = f64::midpoint(from, to);
    format!("M{from} {middle}C{bend} {middle} {bend} {below} {to} {below}")
}

/// How many nodes each has below it, itself counted.
fn sizes(nodes: &[TreeNode]) -> BTreeMap<u64, usize> {
    let mut sizes: BTreeMap<u64, usize> = BTreeMap::new();
    // Children have greater numbers than their parents.
    for node in nodes.iter().rev() {
        let own = *sizes
            .entry(node.id)
            .and_modify(|size| *size += 1)
            .or_insert(1);
        if let Some(parent) = node.parent {
            *sizes.entry(parent).or_insert(0) += own;
        }
    }
    sizes
}
