//! Zones and rules of a scene that is edited: they follow its agents and its map.

use super::{Constraint, ConstraintKind, Zone};
use crate::{Agent, Cell, Grid, Scene};

impl Scene {
    /// Leaves out of zones and rules what is no longer there: agents, cells off the map,
    /// zones.
    ///
    /// ```
    /// use giveway_model::{Cell, Grid, Scene, Zone};
    /// let mut scene = Scene { zones: vec![Zone::of("far", vec![Cell::new(9, 9)])], ..Scene::default() };
    /// scene.settle_rules(&Grid::from_rows(&["..".to_owned()]).unwrap());
    /// assert!(scene.zones.is_empty());
    /// ```
    pub fn settle_rules(&mut self, grid: &Grid) {
        self.zones.retain_mut(|zone| zone.keep_on(grid));
        let Self {
            agents,
            zones,
            constraints,
            ..
        } = self;
        constraints.retain_mut(|rule| rule.keep_agents(agents) && rule.is_placed(zones, grid));
    }

    /// Gives an agent another name in the rules that name it.
    pub fn rename_in_rules(&mut self, from: &str, to: &str) {
        for rule in &mut self.constraints {
            rule.rename(from, to);
        }
    }
}

impl Zone {
    /// Leaves out cells off the map; whether there are others.
    fn keep_on(&mut self, grid: &Grid) -> bool {
        if let Some(cells) = &mut self.listed {
            cells.retain(|&cell| grid.ground(cell).is_some());
        }
        if let Some([x0, y0, x1, y1]) = &mut self.rect {
            *x1 = (*x1).min(grid.width().saturating_sub(1));
            *y1 = (*y1).min(grid.height().saturating_sub(1));
            return x0 <= x1 && y0 <= y1;
        }
        self.listed.as_ref().is_some_and(|cells| !cells.is_empty())
    }
}

impl Constraint {
    /// Leaves the agents out that are gone; whether it still binds any.
    pub(crate) fn keep_agents(&mut self, agents: &[Agent]) -> bool {
        let is_there = |name: &String| agents.iter().any(|agent| agent.name == *name);
        match (&self.kind, &mut self.agents) {
            (ConstraintKind::Sequence { agent, .. }, _) => is_there(agent),
            (ConstraintKind::Before { first, second }, _) => {
                is_there(&first.agent) && is_there(&second.agent)
            }
            (_, Some(names)) => {
                names.retain(is_there);
                !names.is_empty()
            }
            (_, None) => true,
        }
    }

    /// Whether its zone is there, and its cells are on the map.
    fn is_placed(&self, zones: &[Zone], grid: &Grid) -> bool {
        let has = |name: &String| zones.iter().any(|zone| zone.name == *name);
        let is_on = |cell: &Cell| grid.ground(*cell).is_some();
        match &self.kind {
            ConstraintKind::Capacity { zone, .. }
            | ConstraintKind::Closed { zone, .. }
            | ConstraintKind::NoWaiting { zone, .. }
            | ConstraintKind::Avoid { zone, .. } => has(zone),
            ConstraintKind::OneWay { lane: cells } | ConstraintKind::Sequence { cells, .. } => {
                cells.iter().all(is_on)
            }
            ConstraintKind::Visit { cell, .. } => is_on(cell),
            ConstraintKind::Before { first, second } => is_on(&first.cell) && is_on(&second.cell),
            ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Turns { .. } => true,
        }
    }

    fn rename(&mut self, from: &str, to: &str) {
        let rename = |name: &mut String| {
            if name == from {
                to.clone_into(name);
            }
        };
        match &mut self.kind {
            ConstraintKind::Sequence { agent, .. } => rename(agent),
            ConstraintKind::Before { first, second } => {
                rename(&mut first.agent);
                rename(&mut second.agent);
            }
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => {}
        }
        self.agents.iter_mut().flatten().for_each(rename);
    }
}
