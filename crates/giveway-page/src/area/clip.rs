//! What is on an area, remembered: its ground, its robots, its part of the zones.

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint, Grid, Ground};

use super::{Area, Doing, Way, frame};
use crate::Draft;

/// What was on an area when it was copied.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    pub(crate) cells: Rc<BTreeSet<Cell>>,
    /// The ground of each cell.
    pub(crate) ground: Vec<(Cell, Ground)>,
    /// Robots that start there, with those goals and waypoints that are there, too.
    pub(crate) agents: Vec<Agent>,
    /// The part of each zone that is there.
    pub(crate) zones: Vec<(String, Vec<Cell>)>,
    /// One-way lanes that are there as a whole.
    pub(crate) lanes: Vec<Constraint>,
}

impl Clip {
    /// What is on some cells of a scene.
    pub(crate) fn of(cells: &Rc<BTreeSet<Cell>>, draft: &Draft) -> Self {
        let scene = draft.scene();
        let is_there = |cell: &Cell| cells.contains(cell);
        let copied = |agent: &Agent| Agent {
            goal: agent.goal.filter(is_there),
            waypoints: agent.waypoints.iter().copied().filter(is_there).collect(),
            ..agent.clone()
        };
        let agents = scene.agents.iter().filter(|agent| is_there(&agent.start));
        let zone = |zone: &giveway_model::Zone| {
            let part: Vec<Cell> = zone.cell_set().into_iter().filter(is_there).collect();
            (!part.is_empty()).then(|| (zone.name.clone(), part))
        };
        let lanes = scene.constraints.iter().filter(|rule| match &rule.kind {
            ConstraintKind::OneWay { lane } => lane.iter().all(is_there),
            _ => false,
        });
        Self {
            ground: ground(cells, draft.grid()).collect(),
            agents: agents.map(copied).collect(),
            zones: scene.zones.iter().filter_map(zone).collect(),
            lanes: lanes.cloned().collect(),
            cells: Rc::clone(cells),
        }
    }

    /// The same mirrored or turned.
    pub(crate) fn turned(&self, way: Way) -> Self {
        let all = |cells: &[Cell]| cells.iter().filter_map(|&cell| way.of(cell)).collect();
        let agent = |agent: &Agent| {
            Some(Agent {
                start: way.of(agent.start)?,
                goal: agent.goal.and_then(|goal| way.of(goal)),
                waypoints: all(&agent.waypoints),
                ..agent.clone()
            })
        };
        let lane = |rule: &Constraint| {
            let mut rule = rule.clone();
            if let ConstraintKind::OneWay { lane } = &mut rule.kind {
                *lane = all(lane);
            }
            rule
        };
        let ground = self.ground.iter();
        let zones = self.zones.iter();
        Self {
            cells: Rc::new(self.cells.iter().filter_map(|&cell| way.of(cell)).collect()),
            ground: ground
                .filter_map(|&(cell, ground)| Some((way.of(cell)?, ground)))
                .collect(),
            agents: self.agents.iter().filter_map(agent).collect(),
            zones: zones
                .map(|(name, cells)| (name.clone(), all(cells)))
                .collect(),
            lanes: self.lanes.iter().map(lane).collect(),
        }
    }

    /// It as drawn text, row by row: what is no part of it is blank.
    pub(crate) fn text(&self) -> String {
        let [x0, y0, x1, y1] = frame(&self.cells);
        let mut rows = vec![vec![' '; (x1 - x0 + 1) as usize]; (y1 - y0 + 1) as usize];
        for (cell, ground) in &self.ground {
            let row = rows.get_mut((cell.y - y0) as usize);
            if let Some(at) = row.and_then(|row| row.get_mut((cell.x - x0) as usize)) {
                *at = ground.to_char();
            }
        }
        let rows: Vec<String> = rows.into_iter().map(String::from_iter).collect();
        rows.join("\n")
    }
}

/// The ground of each of some cells that are on a map.
pub(crate) fn ground<'a>(
    cells: &'a BTreeSet<Cell>,
    grid: &'a Grid,
) -> impl Iterator<Item = (Cell, Ground)> + 'a {
    let of = |&cell: &Cell| grid.ground(cell).map(|ground| (cell, ground));
    cells.iter().filter_map(of)
}

impl Area {
    /// Something that was copied, with its upper left corner at a cell as far as it fits.
    pub(crate) fn pasted(clip: &Rc<Clip>, at: Cell, grid: &Grid) -> Self {
        let [x0, y0, ..] = frame(&clip.cells);
        let go = |to: u32, from: u32| i32::try_from(i64::from(to) - i64::from(from)).unwrap_or(0);
        let pasted = Self {
            cells: Rc::clone(&clip.cells),
            by: (0, 0),
            doing: Doing::Pastes(Rc::clone(clip)),
        };
        pasted.moved((go(at.x, x0), go(at.y, y0)), grid)
    }
}
