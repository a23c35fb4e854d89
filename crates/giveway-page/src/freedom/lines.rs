//! The ways of robots over all best plans: solid where every one of them goes there at
//! the same time, dotted where there is a choice.

use std::fmt::Write;

use giveway_model::{Cell, sorting};
use giveway_solve::freedom::{Known, Visit};

use crate::State;
use crate::board::{CELL, Way};

/// The lines of a robot, as SVG path data; an empty path draws nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// Its index in the scene.
    pub agent: usize,
    /// Where every best plan leads it at the same time.
    pub must: String,
    /// Where no best plan but this one does.
    pub only: String,
    /// Where some best plan does.
    pub may: String,
    /// Where this plan does, and it is open whether every one does.
    pub open: String,
}

/// What is known of an edge, the strongest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Must,
    Only,
    Open,
    May,
}

/// The lines; none where nothing is laid over the plan, or nothing is known yet.
pub fn lines(state: &State) -> Vec<Lines> {
    let told = state.freedom().and_then(|freedom| freedom.told.as_deref());
    let Some((told, backbone)) = told.and_then(|told| Some((told, told.backbone.as_ref()?))) else {
        return Vec::new();
    };
    let agents = state.document.agents();
    let of = |(agent, who): (usize, &giveway_model::Agent)| {
        let visits = backbone.get(&who.name).map_or(&[][..], Vec::as_slice);
        let mut edges = own(visits);
        let ways = told
            .plans
            .iter()
            .filter_map(|plans| plans.ways.get(&who.name));
        let steps = ways.flat_map(|ways| &ways.steps);
        edges.extend(steps.map(|step| (edge(step.from, step.to), Kind::May)));
        sorting::sort(&mut edges);
        edges.dedup_by_key(|(edge, _)| *edge);
        let offset = Way::offset(agent, agents.len());
        let path = |of: Kind| {
            let mut path = String::new();
            for ((from, to), _) in edges.iter().filter(|(_, kind)| *kind == of) {
                if from != to {
                    let ((x, y), (u, v)) = (place(*from, offset), place(*to, offset));
                    // Writing to a string cannot fail.
                    let _ = write!(path, "M{x} {y}L{u} {v}");
                }
            }
            path
        };
        Lines {
            agent,
            must: path(Kind::Must),
            only: path(Kind::Only),
            may: path(Kind::May),
            open: path(Kind::Open),
        }
    };
    agents.iter().enumerate().map(of).collect()
}

/// The edges of this plan.
fn own(visits: &[Visit]) -> Vec<((Cell, Cell), Kind)> {
    let mut edges = Vec::new();
    let mut last: Option<(usize, Cell)> = None;
    for (at, visit) in visits.iter().enumerate() {
        let Some(cell) = visit.cell else { continue };
        if let Some((from, before)) = last {
            let visits = &visits[from..=at];
            let is_only = visits.iter().any(|visit| visit.only.is_proved());
            let kind = match known(visits) {
                Known::Yes => Kind::Must,
                Known::No if is_only => Kind::Only,
                Known::No => Kind::May,
                Known::Open => Kind::Open,
            };
            edges.push((edge(before, cell), kind));
        }
        last = Some((at, cell));
    }
    edges
}

/// Whether every best plan has all of these visits.
pub(super) fn known(visits: &[Visit]) -> Known {
    let has = |known: Known| visits.iter().any(|visit| visit.always == known);
    if has(Known::No) {
        Known::No
    } else if has(Known::Open) {
        Known::Open
    } else {
        Known::Yes
    }
}

/// Both ways are one line.
fn edge(a: Cell, b: Cell) -> (Cell, Cell) {
    if a <= b { (a, b) } else { (b, a) }
}

fn place(cell: Cell, offset: f64) -> (f64, f64) {
    let middle = |n: u32| ((f64::from(n) + 0.5) * CELL + offset).round();
    (middle(cell.x), middle(cell.y))
}
