//! Rows and columns of the floor come or go.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cell, Grid, Zone};

use super::places::{rectangle, remap};
use super::scene::free;
use super::{Axis, Lost, Reshape, Sketch};

impl Sketch {
    /// Adds rows and columns, or takes them away. All that the scene names goes along; what a
    /// robot has on a cell that is gone moves to the nearest free one, or is taken away.
    pub(super) fn grow(&mut self, reshape: Reshape, lost: Lost) {
        let size = reshape.size(&self.grid);
        let mut grid = free(size.0, size.1);
        for (cell, ground) in self.grid.cells() {
            if let Some(cell) = reshape.moved(cell, size) {
                grid.set_ground(cell, ground);
            }
        }
        let old = std::mem::replace(&mut self.grid, grid);
        let to = |cell: Cell| reshape.moved(cell, size);
        if lost == Lost::Move {
            self.rescue(reshape, &old);
        }
        let between = between(reshape, &self.scene.zones);
        remap(
            &mut self.scene,
            &to,
            &|lane| lane_then(reshape, lane, size),
            &|_| true,
        );
        for zone in &mut self.scene.zones {
            if let Some((is_rect, between)) = between.get(&zone.name) {
                let cells: BTreeSet<Cell> = zone.cells().chain(between.iter().copied()).collect();
                *zone = match rectangle(&cells).filter(|_| *is_rect) {
                    Some(rect) => Zone {
                        rect: Some(rect),
                        listed: None,
                        ..zone.clone()
                    },
                    None => Zone::of(zone.name.clone(), cells.into_iter().collect()),
                };
            }
        }
    }

    /// Moves the starts, goals and waypoints of cells that are gone to free cells, as places
    /// of the floor before.
    fn rescue(&mut self, reshape: Reshape, old: &Grid) {
        let size = (self.grid.width(), self.grid.height());
        let to = |cell: Cell| reshape.moved(cell, size);
        let agents = &mut self.scene.agents;
        let mut starts: BTreeSet<Cell> =
            agents.iter().filter_map(|agent| to(agent.start)).collect();
        let mut goals: BTreeSet<Cell> = agents.iter().filter_map(|agent| to(agent.goal?)).collect();
        // Free cells then, each with its place on the floor before, from which all places move.
        let free: Vec<(Cell, Cell)> = {
            let cells = self.grid.cells().map(|(cell, _)| cell);
            let free = cells.filter(|&cell| self.grid.is_vertex(cell));
            free.filter_map(|cell| Some((cell, reshape.before(cell, old)?)))
                .collect()
        };
        let nearest = |cell: Cell, taken: &BTreeSet<Cell>| {
            let wanted = reshape.nearest(cell, size);
            let far = |(at, _): &&(Cell, Cell)| at.x.abs_diff(wanted.x) + at.y.abs_diff(wanted.y);
            free.iter()
                .filter(|(at, _)| !taken.contains(at))
                .min_by_key(far)
                .copied()
        };
        let rescued = |cell: Cell, taken: &mut BTreeSet<Cell>| {
            if to(cell).is_some() {
                return cell;
            }
            let Some((found, before)) = nearest(cell, taken) else {
                return cell;
            };
            taken.insert(found);
            before
        };
        for agent in agents {
            agent.start = rescued(agent.start, &mut starts);
            agent.goal = agent.goal.map(|goal| rescued(goal, &mut goals));
            let mut own: BTreeSet<Cell> = agent
                .waypoints
                .iter()
                .filter_map(|&cell| to(cell))
                .collect();
            for waypoint in &mut agent.waypoints {
                *waypoint = rescued(*waypoint, &mut own);
            }
        }
    }
}

/// A lane on the floor then: it runs on through cells that come, and is gone where it tears.
fn lane_then(reshape: Reshape, lane: &[Cell], size: (u32, u32)) -> Vec<Cell> {
    let mut kept: Vec<Cell> = Vec::new();
    let mut last = None;
    for &cell in lane {
        if let (Reshape::Lines(lines), Some(last)) = (reshape, last) {
            kept.extend(lines.between(last, cell));
        }
        kept.extend(reshape.moved(cell, size));
        last = Some(cell);
    }
    let is_step =
        |pair: &[Cell]| matches!(pair, [a, b] if a.x.abs_diff(b.x) + a.y.abs_diff(b.y) == 1);
    if kept.windows(2).all(is_step) {
        kept
    } else {
        Vec::new()
    }
}

/// The cells that come between two of a zone, by its name, and whether it is a rectangle: they
/// are part of it, too.
fn between(reshape: Reshape, zones: &[Zone]) -> BTreeMap<String, (bool, Vec<Cell>)> {
    let Reshape::Lines(lines) = reshape else {
        return BTreeMap::new();
    };
    let of = |zone: &Zone| {
        let cells: BTreeSet<Cell> = zone.cells().collect();
        let next = |cell: Cell| match lines.axis {
            Axis::Columns => Cell::new(cell.x + 1, cell.y),
            Axis::Rows => Cell::new(cell.x, cell.y + 1),
        };
        let pairs = cells.iter().map(|&cell| (cell, next(cell)));
        let pairs = pairs.filter(|(_, next)| cells.contains(next));
        let between: Vec<Cell> = pairs.flat_map(|(a, b)| lines.between(a, b)).collect();
        (!between.is_empty()).then(|| (zone.name.clone(), (zone.rect.is_some(), between)))
    };
    zones.iter().filter_map(of).collect()
}
