//! The best way to go on with a plan when the world changes: joint states from
//! the time of the change on.
//!
//! A state of an agent tells, beside its place, what it has seen and its level,
//! how far it has come on its old path, how long it is still broken down, and
//! whether it has done as in the old plan so far. The world at the time of the
//! change is read off the plan here once more, and nothing of the model's
//! history, of its judge or of the solver is used.

mod map;
mod robot;
mod search;

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::change::{Change, What};
use giveway_model::{Agent, Cell, Cost, Instance, Plan};

use self::map::{around, edited};
pub use self::map::{edited as map_after, standing};
use self::robot::{Place, Robot, UNLIMITED};
use super::world::World;

/// What an old agent is held to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// Its old sequence of cells.
    Path,
    /// So many steps around the rest of its old path.
    Tunnel(u32),
    /// Nothing.
    Nothing,
}

/// What is known of the best way to go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Known {
    /// The costs in order and the number of disturbed agents.
    Best(Vec<u32>),
    /// There is no way.
    None,
    /// There were more states than allowed.
    Capped,
}

/// A plan and the changes of one time.
pub struct Changed {
    at: u32,
    stays: bool,
    floor: u32,
    world: World,
    robots: Vec<Robot>,
    costs: Vec<Cost>,
    /// What is past, and that times count from the change.
    past: BTreeMap<Cost, u32>,
    /// The latest arrival where nobody goes on.
    latest: u32,
}

/// For how long an agent has been at its goal at a time, with nothing left to
/// do and without charging.
fn stood(agent: &Agent, path: &[Option<Cell>], charges: &[u32], now: u32) -> u32 {
    let done = |time: u32| {
        let been = &path[..=time as usize];
        let mut left = agent.waypoints.iter();
        let here = path[time as usize];
        let rests = here.is_some() && here == agent.goal.or(path[now as usize]);
        rests && left.all(|cell| been.contains(&Some(*cell)))
    };
    let mut since = now;
    while since > 0 && done(since) && done(since - 1) && !charges.contains(&(since - 1)) {
        since -= 1;
    }
    now - since
}

impl Changed {
    /// The world of a plan at a time; `None` where the plan is none.
    pub fn new(
        instance: &Instance,
        costs: &[Cost],
        plan: &Plan,
        at: u32,
        changes: &[Change],
    ) -> Option<Self> {
        let scene = instance.to_scene();
        let stays = instance.stays();
        let mut changed = Self {
            at,
            stays,
            floor: instance.rules().battery_floor,
            world: World::new(&standing(&edited(&scene.map, changes), plan, changes)),
            robots: Vec::new(),
            costs: costs.to_vec(),
            past: BTreeMap::new(),
            latest: 0,
        };
        for agent in instance.agents() {
            let leaves = |change: &Change| match &change.what {
                What::RemoveAgent { agent: name } | What::StopAgent { agent: name } => {
                    *name == agent.name
                }
                _ => false,
            };
            if changes.iter().any(leaves) {
                continue;
            }
            changed.go_on(agent, plan, changes)?;
        }
        for change in changes {
            if let What::AddAgent { agent } = &change.what {
                changed.robots.push(Robot {
                    first: Place::At(agent.start),
                    is_old: false,
                    level: agent.battery.map_or(UNLIMITED, |b| b.initial),
                    held: 0,
                    rested: 0,
                    stood: 0,
                    rest: Vec::new(),
                    old: Vec::new(),
                    charges: Vec::new(),
                    tunnel: BTreeSet::new(),
                    by: Held::Nothing,
                    agent: agent.clone(),
                });
                changed.add_past(Cost::SumOfCosts, at);
                changed.latest = changed.latest.max(at);
            }
        }
        Some(changed)
    }

    fn add_past(&mut self, cost: Cost, more: u32) {
        *self.past.entry(cost).or_default() += more;
    }

    /// An agent of the instance.
    fn go_on(&mut self, agent: &Agent, plan: &Plan, changes: &[Change]) -> Option<()> {
        let path = plan.path(&agent.name);
        let arrival = path.len() as u32 - 1;
        let now = self.at.min(arrival);
        let charges = plan.charges(&agent.name);
        self.count_past(path, charges, now);
        let stays = self.stays || agent.goal.is_none();
        if !stays && arrival < self.at {
            self.add_past(Cost::SumOfCosts, arrival);
            self.latest = self.latest.max(arrival);
            return Some(());
        }
        // Who stands at its goal and was to go on has not arrived; but if it stays
        // for good now, it arrived when it came.
        let stood = if stays {
            stood(agent, path, charges, now)
        } else {
            0
        };
        let mut level = agent.battery.map_or(UNLIMITED, |battery| battery.initial);
        if let Some(battery) = agent.battery {
            for time in 0..now {
                level = if charges.contains(&time) {
                    battery.capacity
                } else {
                    level - 1
                };
            }
        }
        let been: Vec<Cell> = path[..=now as usize].iter().copied().flatten().collect();
        let mut robot = Robot {
            agent: agent.clone(),
            is_old: true,
            first: match path[now as usize] {
                Some(cell) => Place::At(cell),
                None => Place::Between(path[now as usize - 1]?, path[now as usize + 1]?),
            },
            level,
            held: 0,
            rested: if stays && arrival < self.at {
                self.at - arrival
            } else {
                stood
            },
            stood: if arrival < self.at { 0 } else { stood },
            rest: path[now as usize..].iter().copied().flatten().collect(),
            old: path[now as usize..].to_vec(),
            charges: charges
                .iter()
                .filter(|&&t| t >= self.at)
                .map(|t| t - self.at)
                .collect(),
            tunnel: BTreeSet::new(),
            by: Held::Nothing,
        };
        robot.rest.dedup();
        robot.agent.waypoints.retain(|cell| !been.contains(cell));
        for change in changes {
            robot.meet(&change.what);
        }
        let from = self.at - robot.rested;
        *self.past.entry(Cost::Waits).or_default() -= if arrival < self.at { 0 } else { stood };
        if robot.rested < stood {
            self.add_past(Cost::Waits, stood); // it is to go on for sure
        }
        self.add_past(Cost::SumOfCosts, from);
        self.latest = self.latest.max(from);
        self.robots.push(robot);
        Some(())
    }

    fn count_past(&mut self, path: &[Option<Cell>], charges: &[u32], now: u32) {
        let before = charges.iter().filter(|&&time| time < now).count() as u32;
        self.add_past(Cost::Charges, before);
        for time in 0..now as usize {
            let Some(here) = path[time] else { continue };
            let waits = path[time + 1] == Some(here);
            self.add_past(if waits { Cost::Waits } else { Cost::Moves }, 1);
        }
    }

    /// The names of the agents that were there before.
    pub fn old(&self) -> Vec<&str> {
        let old = self.robots.iter().filter(|robot| robot.is_old);
        old.map(|robot| robot.agent.name.as_str()).collect()
    }

    /// The best way to go on with the old agents held to something, these
    /// freed, by looking at so many joint states at most.
    pub fn best(&mut self, held: Held, freed: &[&str], cap: usize) -> Known {
        for robot in &mut self.robots {
            let is_free = !robot.is_old || freed.contains(&robot.agent.name.as_str());
            robot.by = if is_free { Held::Nothing } else { held };
            if let Held::Tunnel(width) = robot.by {
                robot.tunnel = around(&self.world, &robot.rest, width);
            }
        }
        let mut vector = match self.search(cap) {
            Known::Best(vector) => vector,
            known => return known,
        };
        for (value, cost) in vector.iter_mut().zip(&self.costs) {
            *value += match cost {
                Cost::Makespan if *value == 0 => self.latest,
                Cost::Makespan => self.at,
                cost => self.past.get(cost).copied().unwrap_or(0),
            };
        }
        Known::Best(vector)
    }
}
