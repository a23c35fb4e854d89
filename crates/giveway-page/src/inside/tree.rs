//! The constraint tree from left to right: where each node stands, what it says, and
//! which nodes are folded.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use giveway_model::tr;
use giveway_solve::plan::{NodeFate, TreeNode, words};

use super::{Method, TreeRun, index};
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
    /// What is folded.
    pub folds: Vec<Fold>,
    /// How wide and high all of it is.
    pub size: (f64, f64),
}

/// A node as it is drawn.
#[derive(Clone, Debug, PartialEq)]
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
    let tree = state.looked()?.tree.as_ref()?.as_ref().ok()?;
    let mut drawn = Drawn::new(state, tree, state.inside.node);
    drawn.add(0, 0, (1, 1));
    let Drawn { mut view, rows, .. } = drawn;
    let right = view.nodes.iter().map(|node| node.at.0).fold(0.0, f64::max);
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
            let bend = f64::midpoint(from, to);
            let line = &mut self.view.lines[usize::from(is_on)];
            // Writing to a string cannot fail.
            let _ = write!(
                line,
                "M{from} {middle}C{bend} {middle} {bend} {below} {to} {below}"
            );
        }
        self.view.nodes[slot].at = (x, middle - SIZE.1 / 2.0);
        self.view.nodes[slot].level = depth + 1;
        self.fold(id, (x + SIZE.0 + 8.0, middle));
        middle
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

    fn node_box(&self, node: &TreeNode, place: (usize, usize), has_children: bool) -> NodeBox {
        let lines = lines(node);
        let is_chosen = node.id == self.chosen;
        let class = match node.fate {
            NodeFate::Open => "open",
            NodeFate::Dead => "open dead",
            NodeFate::Split { .. } => "split",
            NodeFate::Best { .. } => "sol",
        };
        let constraint = node.constraint.as_ref();
        let asks = constraint.map(|constraint| format!(", {}", words::constraint(constraint)));
        let cost = node
            .cost
            .map_or("\u{2013}".to_owned(), |cost| cost.to_string());
        // What is seen is what is said, and a little more.
        let said = match lines[0].strip_suffix(':') {
            Some(first) => format!("{first}: {}", lines[1]),
            None => lines.join(", "),
        };
        let what = node
            .cost
            .map_or_else(String::new, |cost| tr!("Cost {cost}: ", cost));
        NodeBox {
            id: node.id,
            at: (0.0, 0.0),
            cost,
            lines,
            agent: constraint.and_then(|asked| index(self.state, words::subject(asked))),
            class,
            is_chosen,
            name: format!("{what}{said}{}", asks.unwrap_or_default()),
            level: 1,
            place,
            is_expanded: (!self.tree.children(node.id).is_empty()).then_some(has_children),
        }
    }
}

/// What a node says, in two lines.
fn lines(node: &TreeNode) -> [String; 2] {
    match &node.fate {
        NodeFate::Split { conflict, .. } => words::conflict_lines(conflict),
        NodeFate::Best { .. } => [
            tr!("No conflict:").to_owned(),
            tr!("the best plan").to_owned(),
        ],
        NodeFate::Dead => [
            tr!("No way:").to_owned(),
            tr!("it cannot be kept").to_owned(),
        ],
        NodeFate::Open => {
            let count = match node.conflicts {
                0 => tr!("No conflict").to_owned(),
                more => tr!("{n} conflict" | "{n} conflicts" % more),
            };
            [count, tr!("never opened").to_owned()]
        }
    }
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
