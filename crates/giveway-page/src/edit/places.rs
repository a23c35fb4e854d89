//! All places that a scene names are given others: of robots, zones and rules.

use std::collections::BTreeSet;

use giveway_model::{Cell, Constraint, Scene, Zone, constraint::ConstraintKind};

/// Gives each place of a scene another one; `None` where a place is lost. A robot without its
/// start or its goal goes, and so does a rule without one of its cells; waypoints and cells of
/// zones go alone. Lanes become what `lane` makes of them, and zones that are not touched stay.
pub(super) fn remap(
    scene: &mut Scene,
    to: &dyn Fn(Cell) -> Option<Cell>,
    lane: &dyn Fn(&[Cell]) -> Vec<Cell>,
    is_touched: &dyn Fn(&Zone) -> bool,
) {
    scene.agents.retain_mut(|agent| {
        let Some(start) = to(agent.start) else {
            return false;
        };
        agent.start = start;
        let had_goal = agent.goal.is_some();
        agent.goal = agent.goal.and_then(to);
        let mut waypoints = Vec::new();
        for waypoint in agent.waypoints.iter().copied().filter_map(to) {
            if !waypoints.contains(&waypoint) {
                waypoints.push(waypoint);
            }
        }
        agent.waypoints = waypoints;
        agent.goal.is_some() == had_goal
    });
    for zone in scene.zones.iter_mut().filter(|zone| is_touched(zone)) {
        let cells: BTreeSet<Cell> = zone.cells().filter_map(to).collect();
        *zone = match zone.rect.and_then(|_| rectangle(&cells)) {
            Some(rect) => Zone {
                rect: Some(rect),
                listed: None,
                ..zone.clone()
            },
            None => Zone::of(zone.name.clone(), cells.into_iter().collect()),
        };
    }
    scene.zones.retain(|zone| zone.cells().next().is_some());
    scene.constraints.retain_mut(|rule| keep(rule, to, lane));
}

impl super::Sketch {
    /// Takes agents away, by their index.
    pub(super) fn remove_agents(&mut self, gone: &BTreeSet<usize>) {
        let mut indices = 0_usize..;
        let is_gone = |index: usize| gone.contains(&index);
        self.scene
            .agents
            .retain(|_| !indices.next().is_some_and(is_gone));
    }

    /// Puts agents in the place of those that there are; rules follow those that get another name.
    pub(super) fn put_agents(&mut self, agents: &[giveway_model::Agent]) {
        let old: Vec<String> = self
            .scene
            .agents
            .iter()
            .map(|agent| agent.name.clone())
            .collect();
        let renamed = || {
            old.iter()
                .zip(agents)
                .filter(|(old, agent)| **old != agent.name)
        };
        // By names that nobody has: two may change theirs with each other.
        for (index, (old, _)) in renamed().enumerate() {
            self.scene.rename_in_rules(old, &format!("\u{0}{index}"));
        }
        for (index, (_, agent)) in renamed().enumerate() {
            self.scene
                .rename_in_rules(&format!("\u{0}{index}"), &agent.name);
        }
        self.scene.agents = agents.to_vec();
    }
}

/// Gives the places of a rule others; whether all of them are there.
fn keep(
    rule: &mut Constraint,
    to: &dyn Fn(Cell) -> Option<Cell>,
    lane: &dyn Fn(&[Cell]) -> Vec<Cell>,
) -> bool {
    if let ConstraintKind::OneWay { lane: cells } = &mut rule.kind {
        *cells = lane(cells);
        return cells.len() > 1;
    }
    let mut cells = crate::rules::parts(&mut rule.kind).cells.into_iter();
    cells.all(|cell| match to(*cell) {
        Some(other) => {
            *cell = other;
            true
        }
        None => false,
    })
}

/// The first and last column and row of cells that are a rectangle.
pub(super) fn rectangle(cells: &BTreeSet<Cell>) -> Option<[u32; 4]> {
    let rect @ [x0, y0, x1, y1] = crate::area::frame(cells);
    let count = u64::from(x1 - x0 + 1) * u64::from(y1 - y0 + 1);
    (cells.len() as u64 == count).then_some(rect)
}
