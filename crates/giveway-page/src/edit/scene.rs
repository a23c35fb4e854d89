//! Edits made of the scene as it is now.

use std::collections::BTreeSet;

use giveway_model::words::Sentence;
use giveway_model::{Agent, Battery, Cell, Grid, Ground, Scene, tr_data};

use super::{Edit, Paint, Sketch, Weaker};
use crate::MAX_SIDE;
use crate::words::at as place;

/// The longest name that can be given, in characters.
const LONGEST_NAME: usize = 60;

impl Sketch {
    /// Makes an edit. What the whole document knows and the scene does not (the
    /// horizon, colours) changes nothing here.
    ///
    /// # Errors
    /// Why it cannot be, as a sentence; the sketch is then as it was.
    pub(crate) fn make(&mut self, edit: &Edit) -> Result<(), Sentence> {
        match edit {
            Edit::Paint(paint, cell, on) => return self.paint(*paint, *cell, *on),
            Edit::Erase(cell) => self.erase(*cell),
            Edit::MovePaint(paint, from, to) => return self.move_paint(*paint, *from, *to),

            Edit::AddAgent(agent) => {
                self.stand(
                    &agent.name,
                    agent.start,
                    tr_data!("a robot cannot" => "start"),
                )?;
                if let Some(goal) = agent.goal {
                    self.stand(&agent.name, goal, tr_data!("a robot cannot" => "end"))?;
                }
                self.scene.agents.push(agent.clone());
            }
            Edit::PaintCells(paint, cells) => self.paint_all(*paint, cells),
            Edit::AddAgents(agents) => self.scene.agents.extend(agents.iter().cloned()),
            Edit::PutAgents(agents) => self.put_agents(agents),
            Edit::RemoveAgents(gone) => self.remove_agents(gone),
            Edit::RemoveAgent(agent) => self.remove_agents(&BTreeSet::from([*agent])),
            Edit::SetStart(agent, to) => {
                let name = self.name(*agent);
                self.stand(&name, *to, tr_data!("a robot cannot" => "start"))?;
                self.agent(*agent, |a| a.start = *to);
            }
            Edit::SetGoal(agent, to) => {
                let name = self.name(*agent);
                self.stand(&name, *to, tr_data!("a robot cannot" => "end"))?;
                self.agent(*agent, |a| a.goal = Some(*to));
            }
            Edit::AddWaypoint(agent, cell) => {
                let name = self.name(*agent);
                self.stand(
                    &name,
                    *cell,
                    tr_data!("a robot cannot" => "have a waypoint"),
                )?;
                self.agent(*agent, |a| {
                    if !a.waypoints.contains(cell) {
                        a.waypoints.push(*cell);
                    }
                });
            }
            Edit::DropWaypoint(agent, cell) => self.agent(*agent, |a| {
                a.waypoints.retain(|waypoint| waypoint != cell);
            }),
            Edit::MoveWaypoint(agent, from, to) => {
                let name = self.name(*agent);
                self.stand(&name, *to, tr_data!("a robot cannot" => "have a waypoint"))?;
                self.agent(*agent, |a| {
                    if !a.waypoints.contains(to) {
                        let moved = a.waypoints.iter_mut().filter(|w| *w == from);
                        moved.for_each(|waypoint| *waypoint = *to);
                    }
                });
            }
            Edit::SetBattery(agent, battery) => self.agent(*agent, |a| {
                a.battery = battery.map(|battery| Battery {
                    initial: battery.initial.min(battery.capacity),
                    ..battery
                });
            }),
            Edit::SetLevel(agent, level) => self.agent(*agent, |a| {
                if let Some(battery) = &mut a.battery {
                    battery.initial = (*level).min(battery.capacity);
                }
            }),
            Edit::Delay(..) | Edit::Stop(_) => {
                return Err(tr_data!("A delay needs a plan that runs."));
            }
            Edit::Rename(agent, name) => {
                let name = short(name);
                if !name.is_empty() {
                    self.scene.rename_in_rules(&self.name(*agent), &name);
                    self.agent(*agent, |a| a.name = name);
                }
            }
            Edit::Face(agent, heading) => self.agent(*agent, |a| a.heading = *heading),
            Edit::Name(name) => self.scene.name = short(name),
            Edit::Units(units) => self.scene.units = *units,
            Edit::Resize(width, height) => self.resize(*width, *height),
            Edit::Clear => {
                let (width, height) = (self.grid.width(), self.grid.height());
                self.grid = free(width, height);
                self.scene.agents.clear();
                self.scene.zones.clear();
                self.scene.constraints.clear();
            }
            Edit::Fill(fill) => fill.strew(self),
            Edit::Objective(objective) => self.scene.objective = objective.clone(),
            Edit::AtGoal(at_goal) => self.scene.rules.at_goal = *at_goal,
            Edit::BatteryFloor(floor) => self.scene.rules.battery_floor = *floor,
            Edit::WeakenRule(rule, weaker) => self.weaken(*rule, *weaker),
            Edit::Rules(edit) => return self.make_of_rules(edit),
            Edit::Grow(to, lost) => self.grow(*to, *lost),
            Edit::Area(edit) => return self.make_of_area(edit),
            Edit::Within(_) | Edit::Recolour(..) => {}
        }
        Ok(())
    }

    /// A rule asks for less; where it has no such number, it stays as it is.
    fn weaken(&mut self, rule: usize, weaker: Weaker) {
        let Some(rule) = self.scene.constraints.get_mut(rule) else {
            return;
        };
        let kind = match weaker {
            Weaker::Off => {
                rule.off = true;
                return;
            }
            Weaker::Most(most) => rule.kind.with_most(most),
            Weaker::Until(to) => rule.kind.with_last_time(to),
        };
        if let Some(kind) = kind {
            rule.kind = kind;
        }
    }

    fn agent(&mut self, agent: usize, change: impl FnOnce(&mut Agent)) {
        if let Some(agent) = self.scene.agents.get_mut(agent) {
            change(agent);
        }
    }

    fn name(&self, agent: usize) -> String {
        let agent = self.scene.agents.get(agent);
        agent.map_or_else(String::new, |agent| agent.name.clone())
    }

    /// Whether an agent can have something on a cell: none where there is an
    /// obstacle.
    fn stand(&self, name: &str, at: Cell, what: Sentence) -> Result<(), Sentence> {
        match self.ground(at) {
            Some(Ground::Obstacle) => Err(tr_data!(
                "{name} cannot {what} at {place}: there is an obstacle.",
                name,
                what,
                place = place(at)
            )),
            Some(_) => Ok(()),
            None => Err(tr_data!("{place} is not on the map.", place = place(at))),
        }
    }

    /// Paints a cell. What an agent needs is kept free of obstacles.
    fn paint(&mut self, paint: Paint, at: Cell, on: bool) -> Result<(), Sentence> {
        let Some(old) = self.ground(at) else {
            return Ok(());
        };
        let new = paint.painted(old, on);
        if new == Ground::Obstacle
            && old != new
            && let Some((name, why)) = self.needed_by(at)
        {
            return Err(tr_data!(
                "{name} {why} at {place}: no obstacle fits there.",
                name,
                why,
                place = place(at)
            ));
        }
        self.grid.set_ground(at, new);
        Ok(())
    }

    /// Paints cells; what a robot needs stays as it is.
    fn paint_all(&mut self, paint: Paint, cells: &[Cell]) {
        for &cell in cells {
            // What is refused is told before it is drawn.
            let _ = self.paint(paint, cell, true);
        }
    }

    fn move_paint(&mut self, paint: Paint, from: Cell, to: Cell) -> Result<(), Sentence> {
        let (Some(old), Some(new)) = (self.ground(from), self.ground(to)) else {
            return Ok(());
        };
        // Moving it onto another one would lose it.
        if !paint.is_on(old) || paint.is_on(new) {
            return Ok(());
        }
        if new == Ground::Obstacle && paint != Paint::Obstacle {
            return Err(tr_data!(
                "There is an obstacle at {place}.",
                place = place(to)
            ));
        }
        self.paint(paint, to, true)?;
        self.grid.set_ground(from, paint.painted(old, false));
        Ok(())
    }

    /// Takes away what is on a cell: an agent that starts there, waypoints, the
    /// ground; an agent whose goal was there has none, and may rest at any cell.
    fn erase(&mut self, at: Cell) {
        self.scene.agents.retain(|agent| agent.start != at);
        for agent in &mut self.scene.agents {
            agent.waypoints.retain(|&waypoint| waypoint != at);
            if agent.goal == Some(at) {
                agent.goal = None;
            }
        }
        self.grid.set_ground(at, Ground::Free);
    }

    fn resize(&mut self, width: u32, height: u32) {
        let (width, height) = (width.clamp(1, MAX_SIDE), height.clamp(1, MAX_SIDE));
        let mut grid = free(width, height);
        for (cell, ground) in self.grid.cells() {
            grid.set_ground(cell, ground);
        }
        self.grid = grid;
        let is_on = |cell: &Cell| cell.x < width && cell.y < height;
        let agents = &mut self.scene.agents;
        agents.retain(|agent| is_on(&agent.start) && agent.goal.iter().all(is_on));
        for agent in agents {
            agent.waypoints.retain(is_on);
        }
    }
}

impl Paint {
    /// Whether the ground has it.
    pub(crate) const fn is_on(self, ground: Ground) -> bool {
        match self {
            Self::Obstacle => matches!(ground, Ground::Obstacle),
            Self::Charger => ground.is_charger(),
            Self::Slow => ground.is_slow(),
        }
    }

    /// The ground with it, or without it.
    const fn painted(self, ground: Ground, on: bool) -> Ground {
        match (self, on) {
            (Self::Obstacle, true) => Ground::Obstacle,
            (Self::Obstacle, false) => match ground {
                Ground::Obstacle => Ground::Free,
                other => other,
            },
            (Self::Charger, on) => both(on, ground.is_slow()),
            (Self::Slow, on) => both(ground.is_charger(), on),
        }
    }
}

const fn both(charger: bool, slow: bool) -> Ground {
    match (charger, slow) {
        (true, true) => Ground::SlowCharger,
        (true, false) => Ground::Charger,
        (false, true) => Ground::Slow,
        (false, false) => Ground::Free,
    }
}

/// A free map.
pub(super) fn free(width: u32, height: u32) -> Grid {
    let row = ".".repeat(width as usize);
    Grid::from_rows(&vec![row; height as usize]).unwrap_or_default()
}

/// A name without blanks around it, and not too long.
pub(super) fn short(name: &str) -> String {
    name.trim().chars().take(LONGEST_NAME).collect()
}

/// A name that no agent has: `A7`, of the least free number.
pub(crate) fn fresh_name(scene: &Scene) -> String {
    giveway_model::fleet::fresh_names(&scene.agents, 1)
        .pop()
        .unwrap_or_default()
}
