//! Edits of an area of the floor as a whole.

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::fleet::fresh_names;
use giveway_model::words::Sentence;
use giveway_model::{Agent, Cell, Constraint, Ground, Zone, constraint::ConstraintKind, tr_data};

use super::places::remap;
use super::{AreaEdit, Sketch};
use crate::MAX_AGENTS;
use crate::area::Way;
use crate::words::at as place;

impl Sketch {
    /// Makes an edit of an area.
    ///
    /// # Errors
    /// Why it cannot be, as a sentence; nothing has changed then.
    pub(super) fn make_of_area(&mut self, edit: &AreaEdit) -> Result<(), Sentence> {
        match edit {
            AreaEdit::Move(cells, way) => self.move_area(cells, *way),
            AreaEdit::Put(clip, by) => {
                let way = Way::by(*by);
                let agents = self.copies(&clip.agents, way)?;
                let ground = self.landing(&clip.ground, way, &BTreeSet::new())?;
                self.free_for(&agents, &BTreeSet::new())?;
                for (cell, ground) in ground {
                    self.grid.set_ground(cell, ground);
                }
                self.scene.agents.extend(agents);
                for (name, cells) in &clip.zones {
                    let cells = cells.iter().filter_map(|&cell| way.of(cell));
                    self.add_to_zone(name, cells);
                }
                let lane = |rule: &Constraint| match &rule.kind {
                    ConstraintKind::OneWay { lane } => Some(Constraint {
                        kind: ConstraintKind::OneWay {
                            lane: lane.iter().filter_map(|&cell| way.of(cell)).collect(),
                        },
                        name: None,
                        ..rule.clone()
                    }),
                    _ => None,
                };
                self.scene
                    .constraints
                    .extend(clip.lanes.iter().filter_map(lane));
                Ok(())
            }
            AreaEdit::Erase(cells) => {
                self.erase_all(cells);
                Ok(())
            }
        }
    }

    /// Where the ground of an area comes to lie.
    ///
    /// # Errors
    /// It leaves the map, or an obstacle comes to lie where a robot of elsewhere has something.
    fn landing(
        &self,
        ground: &[(Cell, Ground)],
        way: Way,
        from: &BTreeSet<Cell>,
    ) -> Result<Vec<(Cell, Ground)>, Sentence> {
        let off = || tr_data!("That would leave the map.");
        let to = |&(cell, ground): &(Cell, Ground)| {
            let to = way.of(cell).filter(|&to| self.ground(to).is_some());
            to.map(|to| (to, ground)).ok_or_else(off)
        };
        let landing = ground.iter().map(to).collect::<Result<Vec<_>, _>>()?;
        let is_obstacle =
            |(cell, ground): &(Cell, Ground)| (*ground == Ground::Obstacle).then_some(*cell);
        let obstacles: BTreeSet<Cell> = landing.iter().filter_map(is_obstacle).collect();
        for agent in &self.scene.agents {
            let goal = agent.goal.as_ref();
            for cell in [Some(&agent.start), goal]
                .into_iter()
                .flatten()
                .chain(&agent.waypoints)
            {
                if obstacles.contains(cell)
                    && !from.contains(cell)
                    && let Some((name, why)) = self.needed_by(*cell)
                {
                    return Err(tr_data!(
                        "{name} {why} at {place}: no obstacle fits there.",
                        name,
                        why,
                        place = place(*cell)
                    ));
                }
            }
        }
        Ok(landing)
    }

    /// Whether robots can start and end where they come to be, beside those that stay: all but
    /// those that start or end in `from`.
    fn free_for(&self, agents: &[Agent], from: &BTreeSet<Cell>) -> Result<(), Sentence> {
        let stays = |cell: &Cell| !from.contains(cell);
        let there = || self.scene.agents.iter();
        let starts: BTreeSet<Cell> = there().map(|agent| agent.start).filter(stays).collect();
        let goals: BTreeSet<Cell> = there()
            .filter_map(|agent| agent.goal)
            .filter(stays)
            .collect();
        for agent in agents {
            if starts.contains(&agent.start) {
                return Err(tr_data!(
                    "Another robot starts at {place}: {name} cannot start there.",
                    place = place(agent.start),
                    name = &agent.name
                ));
            }
            if let Some(goal) = agent.goal.filter(|goal| goals.contains(goal)) {
                return Err(tr_data!(
                    "Another robot has its goal at {place}: {name} cannot end there.",
                    place = place(goal),
                    name = &agent.name
                ));
            }
        }
        Ok(())
    }

    /// Copies of robots, with names of their own.
    fn copies(&self, agents: &[Agent], way: Way) -> Result<Vec<Agent>, Sentence> {
        if self.scene.agents.len() + agents.len() > MAX_AGENTS {
            return Err(tr_data!(
                "At most {most} robots fit on the page.",
                most = MAX_AGENTS
            ));
        }
        let names = fresh_names(&self.scene.agents, agents.len());
        let copy = |(name, agent): (String, &Agent)| {
            Some(Agent {
                name,
                start: way.of(agent.start)?,
                goal: agent.goal.and_then(|goal| way.of(goal)),
                waypoints: agent
                    .waypoints
                    .iter()
                    .filter_map(|&cell| way.of(cell))
                    .collect(),
                ..agent.clone()
            })
        };
        Ok(names.into_iter().zip(agents).filter_map(copy).collect())
    }

    /// Moves what is on some cells, with all that robots, zones and rules have there.
    fn move_area(&mut self, cells: &Rc<BTreeSet<Cell>>, way: Way) -> Result<(), Sentence> {
        let ground: Vec<_> = crate::area::ground(cells, &self.grid).collect();
        let landing = self.landing(&ground, way, cells)?;
        let moved = |cell: Cell| {
            if cells.contains(&cell) {
                way.of(cell)
            } else {
                Some(cell)
            }
        };
        // Of each robot only what moves, to be compared with what stays.
        let far = Cell::new(u32::MAX, u32::MAX);
        let part = |agent: &Agent| Agent {
            start: Some(agent.start)
                .filter(|cell| cells.contains(cell))
                .and_then(moved)
                .unwrap_or(far),
            goal: agent
                .goal
                .filter(|cell| cells.contains(cell))
                .and_then(moved),
            ..agent.clone()
        };
        let parts: Vec<Agent> = self.scene.agents.iter().map(part).collect();
        self.free_for(&parts, cells)?;
        for &cell in cells.iter() {
            self.grid.set_ground(cell, Ground::Free);
        }
        for (cell, ground) in landing {
            self.grid.set_ground(cell, ground);
        }
        // A lane that only partly lies there stays, so that it does not tear.
        let lane = |lane: &[Cell]| {
            if lane.iter().all(|cell| cells.contains(cell)) {
                lane.iter().copied().filter_map(moved).collect()
            } else {
                lane.to_vec()
            }
        };
        let is_touched = |zone: &Zone| zone.cells().any(|cell| cells.contains(&cell));
        remap(&mut self.scene, &moved, &lane, &is_touched);
        Ok(())
    }

    fn add_to_zone(&mut self, name: &str, cells: impl Iterator<Item = Cell>) {
        let zones = &mut self.scene.zones;
        match zones.iter_mut().find(|zone| zone.name == name) {
            Some(zone) => {
                let mut all = zone.cell_set();
                all.extend(cells);
                *zone = Zone::of(name, all.into_iter().collect());
            }
            None => zones.push(Zone::of(name, cells.collect())),
        }
    }

    /// Takes away what is on some cells, as [`super::Edit::Erase`] does on one.
    fn erase_all(&mut self, cells: &BTreeSet<Cell>) {
        self.scene
            .agents
            .retain(|agent| !cells.contains(&agent.start));
        for agent in &mut self.scene.agents {
            agent.waypoints.retain(|waypoint| !cells.contains(waypoint));
            agent.goal = agent.goal.filter(|goal| !cells.contains(goal));
        }
        for &cell in cells {
            if self.ground(cell).is_some() {
                self.grid.set_ground(cell, Ground::Free);
            }
        }
    }
}
