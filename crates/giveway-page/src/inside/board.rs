//! What is drawn over the map of the step that is looked at.

use giveway_model::{Cell, check, tr};
use giveway_solve::plan::{NodeFate, ToldConflict, ToldConstraint};

use super::{Method, TreeRun, by_hand, crowd, index, proof, steps};
use crate::State;
use crate::board::{CELL, ConflictPlace, middle};

/// What is drawn over the map, in units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlay {
    /// The cells where robots can be.
    pub shades: Vec<Shade>,
    /// Where robots get into each other's way.
    pub meetings: Vec<Meeting>,
    /// What a node forbids or asks.
    pub bans: Vec<Ban>,
    /// Where there is a conflict.
    pub bursts: Vec<ConflictPlace>,
    /// Where a robot has no way on: the cell, and what is said of it.
    pub stuck: Option<(Cell, String)>,
    /// The robots that the step is about; all are as ever where there is none.
    pub lit: Option<Vec<usize>>,
}

/// The cells where a robot can be.
#[derive(Clone, Debug, PartialEq)]
pub struct Shade {
    /// The robot, by its index.
    pub agent: usize,
    /// The `d` of its outline.
    pub path: String,
}

/// Where two robots get into each other's way.
#[derive(Clone, Debug, PartialEq)]
pub struct Meeting {
    /// The middle.
    pub at: (f64, f64),
    /// Whether what is said of it stands on its left.
    pub is_left: bool,
    /// What is said of it.
    pub text: String,
}

/// What a node forbids a robot, or asks of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Ban {
    /// The robot, by its index.
    pub agent: usize,
    /// The cell; `None` for a move.
    pub cell: Option<Cell>,
    /// From where to where, for a move.
    pub line: Option<[(f64, f64); 2]>,
    /// Whether the robot has to be there; else it may not.
    pub is_asked: bool,
    /// The middle of what is said of it.
    pub label: (f64, f64),
    /// What is said of it: `not at 3`.
    pub text: String,
}

/// How far the label of a cell is from its middle, in units.
const UP: f64 = 51.0;

/// What is drawn; nothing where nothing is looked at.
pub fn overlay(state: &State) -> Overlay {
    let mut overlay = Overlay::default();
    if !state.is_inside() || state.has_gesture() {
        return overlay;
    }
    match state.inside.method {
        Method::Proof => proof::overlay(&mut overlay, state),
        Method::Tree => in_tree(&mut overlay, state),
        Method::Orders => in_order(&mut overlay, state),
        Method::Pibt => crowd::in_pibt(&mut overlay, state),
        Method::Lacam => crowd::in_lacam(&mut overlay, state),
    }
    overlay
}

pub(crate) fn between([a, b]: [Cell; 2]) -> (f64, f64) {
    let ((x, y), (u, v)) = (middle(a), middle(b));
    (f64::midpoint(x, u), f64::midpoint(y, v))
}

fn in_tree(overlay: &mut Overlay, state: &State) {
    if state.is_by_hand() {
        if let Some((tree, node, place)) = by_hand::marks(state) {
            overlay.bans = bans(state, tree, node);
            overlay.bursts.extend(place);
        }
        return;
    }
    let looked = state.looked();
    let Some(Ok(tree)) = looked.and_then(|looked| looked.tree.as_ref()) else {
        return;
    };
    let Some(node) = tree.node(state.inside.node) else {
        return;
    };
    overlay.bans = bans(state, tree, state.inside.node);
    match &node.fate {
        NodeFate::Split { conflict, .. } => overlay.bursts.push(place(conflict)),
        NodeFate::Open => overlay.bursts.extend(first_conflict(state)),
        _ => {}
    }
}

pub(crate) const fn place(conflict: &ToldConflict) -> ConflictPlace {
    match *conflict {
        ToldConflict::Vertex { cell, .. } | ToldConflict::Target { cell, .. } => {
            ConflictPlace::Cell(cell)
        }
        ToldConflict::Swap { edge, .. } => ConflictPlace::Edge(edge),
    }
}

/// The first conflict of the plan that is shown, where it was not told.
fn first_conflict(state: &State) -> Option<ConflictPlace> {
    let answer = state.inside_plan()?;
    let instance = answer.draft.instance().ok()?;
    let report = check::check(instance, answer.plan()?);
    ConflictPlace::of(report.violations.first()?)
}

/// What the nodes from one up to the root ask, the newest on a place above the others.
fn bans(state: &State, tree: &TreeRun, node: u64) -> Vec<Ban> {
    let mut bans: Vec<Ban> = Vec::new();
    let line = tree.lineage(node);
    for constraint in line.iter().filter_map(|node| node.constraint.as_ref()) {
        let Some(mut ban) = ban(state, constraint) else {
            continue;
        };
        let same = bans
            .iter()
            .filter(|other| other.cell == ban.cell && other.line == ban.line);
        let count = same.count();
        // Labels of one place stand below each other.
        ban.label.1 += 38.0 * count as f64;
        bans.push(ban);
    }
    bans.reverse();
    bans
}

fn ban(state: &State, constraint: &ToldConstraint) -> Option<Ban> {
    let at_cell = |agent: &str, cell: Cell, is_asked: bool, text: String| {
        let (x, y) = middle(cell);
        // Where the map ends above it, it stands on the lower edge.
        let up = if y < CELL { UP } else { -UP };
        Some(Ban {
            agent: index(state, agent)?,
            cell: Some(cell),
            line: None,
            is_asked,
            label: (x, y + up),
            text,
        })
    };
    let on_edge = |agent: &str, edge: [Cell; 2], is_asked: bool, text: String| {
        let (x, y) = between(edge);
        let is_across = edge[0].y == edge[1].y;
        let up = if y < CELL { UP } else { -UP };
        Some(Ban {
            agent: index(state, agent)?,
            cell: None,
            line: Some(edge.map(middle)),
            is_asked,
            label: (x, if is_across { y + up } else { y }),
            text,
        })
    };
    let goal = |agent: &str| {
        let agents = state.document.agents().iter();
        let mut own = agents.filter(|other| other.name == agent);
        own.next().and_then(|agent| agent.goal)
    };
    match constraint {
        ToldConstraint::NotAt { agent, cell, time } => {
            at_cell(agent, *cell, false, tr!("not at {time}", time))
        }
        ToldConstraint::At { agent, cell, time } => {
            at_cell(agent, *cell, true, tr!("at {time}", time))
        }
        ToldConstraint::NotAlong { agent, edge, time } => {
            on_edge(agent, *edge, false, tr!("not at {time}", time))
        }
        ToldConstraint::Along { agent, edge, time } => {
            on_edge(agent, *edge, true, tr!("at {time}", time))
        }
        ToldConstraint::ArriveAfter { agent, time } => {
            at_cell(agent, goal(agent)?, false, tr!("after {time}", time))
        }
        ToldConstraint::ArriveBy { agent, time } => {
            at_cell(agent, goal(agent)?, true, tr!("by {time}", time))
        }
    }
}

fn in_order(overlay: &mut Overlay, state: &State) {
    let looked = state.looked();
    let Some(run) = looked.and_then(|looked| looked.orders.get(state.inside.order)) else {
        return;
    };
    let Some((at, ..)) = steps::place(state) else {
        return;
    };
    let shown = run.told.order.iter().take(at);
    overlay.lit =
        (at < run.told.order.len()).then(|| shown.filter_map(|name| index(state, name)).collect());
    let end = run.told.furthest.last().copied().flatten();
    if let Some(cell) = end.filter(|_| at > run.told.planned.len()) {
        let last = run.told.furthest.len() - 1;
        let text = if run.told.dead_end {
            tr!("stuck at {time}", time = last + 1)
        } else {
            tr!("no way on").to_owned()
        };
        overlay.stuck = Some((cell, text));
    }
}
