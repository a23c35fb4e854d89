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
         <rect class=\"floor\" width=\"{width}\" height=\"{height}\"/>\
         <path class=\"wall\" d=\"{}\"/>",
        walls(grid)
    );
    let agents = audited.instance.agents();
    for agent in agents
        .iter()
        .take(if agents.len() <= ROBOTS { ROBOTS } else { 0 })
    {
        let (start, goal) = (agent.start, agent.goal);
        let _ = write!(
            svg,
            "<circle class=\"start\" cx=\"{}.5\" cy=\"{}.5\" r=\".28\"/>\
             <rect class=\"goal\" x=\"{}.25\" y=\"{}.25\" width=\".5\" height=\".5\"/>",
            start.x, start.y, goal.x, goal.y
        );
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

/// All cells that cannot be entered, a rectangle for each run of a row.
fn walls(grid: &Grid) -> String {
    let mut path = String::new();
    for y in 0..grid.height() {
        let is_wall = |x: u32| x < grid.width() && !grid.is_vertex(Cell::new(x, y));
        let mut x = 0;
        while x < grid.width() {
            let from = x;
            while is_wall(x) {
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
