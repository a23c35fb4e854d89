//! The changes of one time, applied together to the world as a plan has it.

use std::collections::BTreeMap;

use super::{
    Career, Change, Duty, Epoch, History, Life, MAX_DELAY, MAX_TIME, What, Whereabouts, refuse,
};
use crate::{Agent, Battery, Cell, Fault, Grid, Ground, MAX_AGENTS, MAX_CAPACITY, Plan, sorting};

impl History {
    /// Applies the changes of one time, each with its place in the list of
    /// changes. Nothing may have changed at that time or later yet.
    ///
    /// # Errors
    /// Where they contradict the world: every contradiction, and nothing has
    /// changed.
    pub fn apply(
        &mut self,
        at: u32,
        changes: &[(usize, &Change)],
        plan: &Plan,
    ) -> Result<(), Vec<Fault>> {
        let mut world = World {
            at,
            before: self,
            after: self.clone(),
            grid: self.grid(at).clone(),
            lives: self.lives(plan, at),
            plan,
            faults: Vec::new(),
            obstacles: BTreeMap::new(),
            placed: Vec::new(),
            aimed: Vec::new(),
        };
        for &(index, change) in changes {
            if at > MAX_TIME {
                world.refuse(index, refuse::too_late(at));
            } else {
                world.edit(index, &change.what);
            }
        }
        world.look_over();
        let World {
            mut after,
            faults,
            grid,
            ..
        } = world;
        if !faults.is_empty() {
            return Err(faults);
        }
        after.epochs.push(Epoch { from: at, grid });
        *self = after;
        Ok(())
    }
}

/// What was found and what was expected.
pub(super) type Reason = (String, String);

/// The world while changes are applied to it.
struct World<'a> {
    at: u32,
    before: &'a History,
    after: History,
    grid: Grid,
    /// The agents that are there before anything changes.
    lives: Vec<Life<'a>>,
    /// The plan around which the world changes.
    plan: &'a Plan,
    faults: Vec<Fault>,
    /// New obstacles, with the changes that put them.
    obstacles: BTreeMap<Cell, usize>,
    /// New agents, with the changes that added them.
    placed: Vec<(usize, String, Cell)>,
    /// Cells that agents must go to, with the changes that said so.
    aimed: Vec<(usize, Cell)>,
}

impl World<'_> {
    fn refuse(&mut self, index: usize, (found, expected): Reason) {
        let place = format!("changes[{index}]");
        self.faults.push(Fault::at(place, found, expected));
    }

    fn edit(&mut self, index: usize, what: &What) {
        let done = match what {
            What::AddAgent { agent } => self.add(index, agent),
            What::RemoveAgent { agent } => self.remove(agent),
            What::AddObstacle { cell } => self.block(index, *cell),
            What::RemoveObstacle { cell } => self.unblock(*cell),
            What::MoveObstacle { from, to } => {
                self.unblock(*from).and_then(|()| self.block(index, *to))
            }
            What::SetSlow { cells } => self.pave(cells, |charger, _| (charger, true)),
            What::SetNormal { cells } => self.pave(cells, |charger, _| (charger, false)),
            What::AddCharger { cell } => self.charger(*cell, true),
            What::RemoveCharger { cell } => self.charger(*cell, false),
            What::SetGoal { agent, cell } => self.goal(index, agent, *cell),
            What::AddWaypoint { agent, cell } => self.waypoint(index, agent, *cell),
            What::DropWaypoint { agent, cell } => self.drop_waypoint(agent, *cell),
            What::SetBattery { agent, level } => self.level(agent, *level),
            What::DelayAgent { agent, steps } => self.delay(agent, *steps),
        };
        if let Err(reason) = done {
            self.refuse(index, reason);
        }
    }

    /// An agent that is there: it has come, was not removed, has not vanished.
    fn career(&mut self, name: &str) -> Result<&mut Career, Reason> {
        let at = self.at;
        let is_gone = |career: &Career| {
            let lives = self.lives.iter();
            let old = self.before.careers().iter().any(|c| c.name() == name);
            // A plan from which it is removed as it appears has no cell of it.
            let leaves_at_once = career.from == at && self.plan.until.get(name) == Some(&at);
            old && !leaves_at_once
                && !lives
                    .clone()
                    .any(|life| life.career.name() == career.name())
        };
        let mut careers = self.after.careers.iter();
        let Some(index) = careers.position(|career| career.name() == name) else {
            return Err(refuse::unknown(name));
        };
        match self.after.careers.get(index) {
            Some(career) if career.until.is_some() => Err(refuse::removed(name)),
            Some(career) if is_gone(career) => Err(refuse::vanished(name, at)),
            _ => {
                let career = self.after.careers.get_mut(index);
                career.ok_or_else(|| refuse::unknown(name))
            }
        }
    }

    fn ground(&self, cell: Cell) -> Result<Ground, Reason> {
        let off = || refuse::off_map(cell, &self.grid);
        self.grid.ground(cell).ok_or_else(off)
    }

    fn add(&mut self, index: usize, agent: &Agent) -> Result<(), Reason> {
        if agent.name.is_empty() {
            return Err(refuse::no_name());
        }
        if self.after.careers.iter().any(|c| c.name() == agent.name) {
            return Err(refuse::used_name(&agent.name));
        }
        if self.after.careers.len() >= MAX_AGENTS {
            return Err(refuse::too_many());
        }
        for (k, cell) in agent.waypoints.iter().enumerate() {
            if agent.waypoints.iter().take(k).any(|other| other == cell) {
                return Err(refuse::twice(*cell));
            }
        }
        if let Some(Battery { capacity, initial }) = agent.battery
            && (capacity > MAX_CAPACITY || initial > capacity)
        {
            return Err(refuse::capacity(capacity, initial));
        }
        let cells = [agent.start, agent.goal];
        for &cell in cells.iter().chain(&agent.waypoints) {
            self.ground(cell)?;
            self.aimed.push((index, cell));
        }
        let career = Career::new(agent.clone(), self.at);
        self.after.careers.push(career);
        self.placed.push((index, agent.name.clone(), agent.start));
        Ok(())
    }

    fn remove(&mut self, name: &str) -> Result<(), Reason> {
        let at = self.at;
        let career = self.career(name)?;
        if career.from == at && at > 0 {
            return Err(refuse::just_added(name));
        }
        career.until = Some(at);
        Ok(())
    }

    fn block(&mut self, index: usize, cell: Cell) -> Result<(), Reason> {
        if self.ground(cell)? == Ground::Obstacle {
            return Err(refuse::blocked(cell));
        }
        self.grid.set_ground(cell, Ground::Obstacle);
        self.obstacles.insert(cell, index);
        Ok(())
    }

    fn unblock(&mut self, cell: Cell) -> Result<(), Reason> {
        if self.ground(cell)? != Ground::Obstacle {
            return Err(refuse::no_obstacle(cell));
        }
        self.grid.set_ground(cell, Ground::Free);
        self.obstacles.remove(&cell);
        Ok(())
    }

    /// Changes whether vertices are chargers, and in the slow zone.
    fn pave(
        &mut self,
        cells: &[Cell],
        make: impl Fn(bool, bool) -> (bool, bool),
    ) -> Result<(), Reason> {
        for &cell in cells {
            let ground = self.ground(cell)?;
            if !ground.is_vertex() {
                return Err(refuse::in_obstacle(cell));
            }
            let (charger, slow) = make(ground.is_charger(), ground.is_slow());
            self.grid.set_ground(cell, Ground::vertex(charger, slow));
        }
        Ok(())
    }

    fn charger(&mut self, cell: Cell, is_there: bool) -> Result<(), Reason> {
        let ground = self.ground(cell)?;
        if ground.is_vertex() && ground.is_charger() == is_there {
            return Err(refuse::charger(cell, is_there));
        }
        self.pave(&[cell], |_, slow| (is_there, slow))
    }

    fn goal(&mut self, index: usize, name: &str, cell: Cell) -> Result<(), Reason> {
        let at = self.at;
        self.ground(cell)?;
        let career = self.career(name)?;
        if career.goal() != cell {
            career.goals.push((at, cell));
        }
        self.aimed.push((index, cell));
        Ok(())
    }

    fn waypoint(&mut self, index: usize, name: &str, cell: Cell) -> Result<(), Reason> {
        let at = self.at;
        self.ground(cell)?;
        let life = self.lives.iter().find(|life| life.career.name() == name);
        let life = life.copied();
        // Of one that is removed now, the plan does not tell what it visits now.
        let leaves = self.plan.until.get(name) == Some(&at);
        let career = self.career(name)?;
        let pending = career.duties().any(|duty| {
            let visit = life.and_then(|life| life.visit(duty));
            duty.cell == cell && visit.is_none_or(|visit| visit > at)
        });
        if pending && !leaves {
            return Err(refuse::waypoint_again(name, cell));
        }
        career.duties.push(Duty {
            cell,
            since: Some(at),
            dropped: None,
        });
        self.aimed.push((index, cell));
        Ok(())
    }

    fn drop_waypoint(&mut self, name: &str, cell: Cell) -> Result<(), Reason> {
        let at = self.at;
        let career = self.career(name)?;
        let mut duties = career.duties.iter_mut().rev();
        let found = duties.find(|duty| duty.cell == cell && duty.dropped.is_none());
        let duty = found.ok_or_else(|| refuse::no_waypoint(name, cell))?;
        duty.dropped = Some(at);
        Ok(())
    }

    fn level(&mut self, name: &str, level: u32) -> Result<(), Reason> {
        let at = self.at;
        let career = self.career(name)?;
        let Some(battery) = career.agent.battery else {
            return Err(refuse::unlimited(name));
        };
        if level > battery.capacity {
            return Err(refuse::level(name, level, battery.capacity));
        }
        career.levels.push((at, level));
        Ok(())
    }

    fn delay(&mut self, name: &str, steps: u32) -> Result<(), Reason> {
        let at = self.at;
        if steps > MAX_DELAY {
            return Err(refuse::too_long(steps));
        }
        let life = self.lives.iter().find(|life| life.career.name() == name);
        let place = life.map(|life| life.place(at));
        let career = self.career(name)?;
        let from = match place {
            Some(Whereabouts::Transit { .. }) => at + 1,
            _ => at,
        };
        career.held.push((from, from + steps));
        Ok(())
    }

    /// What can only be seen once everything has changed.
    fn look_over(&mut self) {
        let mut taken: BTreeMap<Cell, &str> = BTreeMap::new();
        let mut reasons: Vec<(usize, Reason)> = Vec::new();
        let (after, at) = (&self.after, self.at);
        let there = |name: &str| {
            let mut careers = after.careers.iter();
            careers.any(|career| career.name() == name && career.until.is_none())
        };
        for life in &self.lives {
            let name = life.career.name();
            match life.place(at) {
                Whereabouts::At(cell) | Whereabouts::Transit { to: cell, .. } if there(name) => {
                    taken.insert(cell, name);
                }
                _ => {}
            }
        }
        for (index, name, cell) in &self.placed {
            if let Some(other) = taken.insert(*cell, name.as_str()) {
                reasons.push((*index, refuse::occupied(name, *cell, other, at)));
            }
        }
        for (&cell, &index) in &self.obstacles {
            if let Some(other) = taken.get(&cell) {
                reasons.push((index, refuse::obstacle_on(cell, other, at)));
            }
        }
        for &(index, cell) in &self.aimed {
            // An obstacle of the same time is one on somebody's goal.
            if !self.grid.is_vertex(cell) && !self.obstacles.contains_key(&cell) {
                reasons.push((index, refuse::in_obstacle(cell)));
            }
        }
        if after.stays() {
            let mut goals: BTreeMap<Cell, &str> = BTreeMap::new();
            let careers = after.careers.iter();
            for career in careers.filter(|career| career.until.is_none()) {
                if let Some(other) = goals.insert(career.goal(), career.name()) {
                    let changed = self.aimed.iter().rev();
                    let index = changed
                        .filter(|(_, cell)| *cell == career.goal())
                        .map(|&(index, _)| index)
                        .next();
                    let reason = refuse::shared_goal(career.goal(), other, career.name());
                    reasons.push((index.unwrap_or(0), reason));
                }
            }
        }
        sorting::sort_by_key(&mut reasons, |(index, _)| *index);
        for (index, reason) in reasons {
            self.refuse(index, reason);
        }
    }
}
