//! The map of a report as a drawing, with the places where rules are broken.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use giveway_model::{Cell, Grid};

use super::{Audited, TOLD};

/// More robots are not drawn: their marks would hide the map.
const ROBOTS: usize = 400;

/// The drawing. Its colours are classes of the page that it stands in.
pub(super) fn map(audited: &Audited) -> String {
    let grid = audited.instance.grid();
    let (width, height) = (grid.width(), grid.height());
    let mut svg = format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"The map\">\
         <defs><pattern id=\"hatch\" width=\".25\" height=\".25\" patternUnits=\"userSpaceOnUse\" \
         patternTransform=\"rotate(45)\"><path class=\"hatch\" d=\"M.125 0v.25\"/></pattern></defs>\
         <rect class=\"floor\" width=\"{width}\" height=\"{height}\"/>\
         <path class=\"slow\" d=\"{}\"/><path class=\"wall\" d=\"{}\"/>",
        runs(grid, |cell| grid.is_slow(cell)),
        runs(grid, |cell| !grid.is_vertex(cell))
    );
    for cell in cells(grid).filter(|&cell| grid.is_charger(cell)) {
        let _ = write!(
            svg,
            "<rect class=\"charger\" x=\"{}.06\" y=\"{}.06\" width=\".88\" height=\".88\" rx=\".12\"/>\
             <path class=\"bolt\" d=\"M{}.55 {}.16l-.25 .38h.2l-.06 .3 .26-.4h-.2z\"/>",
            cell.x, cell.y, cell.x, cell.y
        );
    }
    let agents = audited.instance.agents();
    for agent in agents
        .iter()
        .take(if agents.len() <= ROBOTS { ROBOTS } else { 0 })
    {
        let start = agent.start;
        let _ = write!(
            svg,
            "<circle class=\"start\" cx=\"{}.5\" cy=\"{}.5\" r=\".28\"/>",
            start.x, start.y
        );
        if let Some(goal) = agent.goal {
            let _ = write!(
                svg,
                "<rect class=\"goal\" x=\"{}.25\" y=\"{}.25\" width=\".5\" height=\".5\"/>",
                goal.x, goal.y
            );
        }
    }
    for cell in broken(audited) {
        let _ = write!(
            svg,
            "<rect class=\"broken\" x=\"{}\" y=\"{}\" width=\"1\" height=\"1\"/>",
            cell.x, cell.y
        );
    }
    svg.push_str("</svg>");
    svg
}

/// All cells of a grid, row by row.
fn cells(grid: &Grid) -> impl Iterator<Item = Cell> {
    let (width, height) = (grid.width(), grid.height());
    (0..height).flat_map(move |y| (0..width).map(move |x| Cell::new(x, y)))
}

/// The cells of one kind, a rectangle for each run of a row.
fn runs(grid: &Grid, is_one: impl Fn(Cell) -> bool) -> String {
    let mut path = String::new();
    for y in 0..grid.height() {
        let is_one = |x: u32| x < grid.width() && is_one(Cell::new(x, y));
        let mut x = 0;
        while x < grid.width() {
            let from = x;
            while is_one(x) {
                x += 1;
            }
            if x > from {
                let _ = write!(path, "M{from} {y}h{n}v1h-{n}z", n = x - from);
            } else {
                x += 1;
            }
        }
    }
    path
}

/// The cells of the violations that are told, as far as they are on the map.
fn broken(audited: &Audited) -> BTreeSet<Cell> {
    let grid = audited.instance.grid();
    let told = audited.answer.violations.iter().take(TOLD);
    let cells = told.flat_map(|it| it.cell.into_iter().chain(it.edge.into_iter().flatten()));
    cells.filter(|cell| grid.ground(*cell).is_some()).collect()
}
