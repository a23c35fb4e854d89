//! The best way to go on with a plan when the world changes: joint states from
//! the time of the change on.
//!
//! A state of an agent tells, beside its place, what it has seen and its level,
//! how far it has come on its old path, how long it is still broken down, and
//! whether it has done as in the old plan so far. The world at the time of the
//! change is read off the plan here once more, and nothing of the model's
//! history, of its judge or of the solver is used.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

use giveway_model::change::{Change, What};
use giveway_model::{Agent, Cell, Cost, Instance, Plan};

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

struct Robot {
    agent: Agent,
    is_old: bool,
    first: Place,
    level: u32,
    held: u32,
    slept: u32,
    rest: Vec<Cell>,
    old: Vec<Option<Cell>>,
    charges: Vec<u32>,
    tunnel: BTreeSet<Cell>,
    by: Held,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    At(Cell),
    Between(Cell, Cell),
    Done,
    Gone,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct State {
    place: Place,
    seen: u32,
    level: u32,
    progress: usize,
    held: u32,
    same: bool,
}

/// One step of one agent.
#[derive(Clone, Copy)]
struct Step {
    to: State,
    edge: Option<(Cell, Cell)>,
    /// Whether it takes time on the way; to be woken takes none.
    time: u32,
    steps: u32,
    charges: u32,
    moves: u32,
    waits: u32,
    disturbed: u32,
}

/// A level that never ends.
const UNLIMITED: u32 = u32::MAX;

impl Changed {
    /// The world of a plan at a time; `None` where an agent stands at its goal
    /// and goes on later, of which one may ask whether it sleeps.
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
            world: World::new(&edited(&scene.map, changes)),
            robots: Vec::new(),
            costs: costs.to_vec(),
            past: BTreeMap::new(),
            latest: 0,
        };
        for agent in instance.agents() {
            let mut whats = changes.iter().map(|change| &change.what);
            if whats.any(|w| matches!(w, What::RemoveAgent { agent: name } if *name == agent.name))
            {
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
                    slept: 0,
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
        if !self.stays && arrival < self.at {
            self.add_past(Cost::SumOfCosts, arrival);
            self.latest = self.latest.max(arrival);
            return Some(());
        }
        let is_resting = |time: u32| path[time as usize] == Some(agent.goal);
        if arrival > self.at && self.at > 0 && is_resting(self.at) && is_resting(self.at - 1) {
            return None;
        }
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
            slept: if self.stays {
                self.at.saturating_sub(arrival)
            } else {
                0
            },
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
        let from = if robot.slept > 0 { arrival } else { self.at };
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

    fn search(&self, cap: usize) -> Known {
        let mut heap = BinaryHeap::new();
        let mut settled: BTreeSet<(u32, Vec<State>)> = BTreeSet::new();
        let firsts: Vec<Vec<Step>> = self.robots.iter().map(|robot| self.first(robot)).collect();
        let zero = vec![0; self.costs.len() + 1];
        self.combine(&firsts, &zero, &mut |states, vector| {
            heap.push(Reverse((vector, 0, states)));
        });
        while let Some(Reverse((vector, tick, states))) = heap.pop() {
            if !settled.insert((tick, states.clone())) {
                continue;
            }
            if settled.len() > cap || heap.len() > 8 * cap {
                return Known::Capped;
            }
            if states
                .iter()
                .all(|s| matches!(s.place, Place::Done | Place::Gone))
            {
                return Known::Best(vector);
            }
            let robots = self.robots.iter().zip(&states);
            let steps: Vec<Vec<Step>> = robots.map(|(r, &s)| self.steps(r, s, tick)).collect();
            // After the old plan's end only whether it was kept to matters.
            let longest = self.robots.iter().map(|r| r.old.len() as u32).max();
            let next = (tick + 1).min(longest.unwrap_or(0));
            self.combine(&steps, &vector, &mut |states, vector| {
                if !settled.contains(&(next, states.clone())) {
                    heap.push(Reverse((vector, next, states)));
                }
            });
        }
        Known::None
    }

    /// All choices of one step an agent in which no two collide.
    fn combine(
        &self,
        choices: &[Vec<Step>],
        before: &[u32],
        each: &mut impl FnMut(Vec<State>, Vec<u32>),
    ) {
        let mut chosen: Vec<Vec<Step>> = vec![Vec::new()];
        for (a, steps) in choices.iter().enumerate() {
            let mut longer = Vec::new();
            for list in &chosen {
                for step in steps {
                    let free = list.iter().enumerate().all(|(b, other)| {
                        let here = self.cell(a, step.to);
                        let meet = here.is_some() && here == self.cell(b, other.to);
                        let back = other.edge.map(|(u, v)| (v, u));
                        !meet && (step.edge.is_none() || step.edge != back)
                    });
                    if free {
                        let mut list = list.clone();
                        list.push(*step);
                        longer.push(list);
                    }
                }
            }
            chosen = longer;
        }
        for list in chosen {
            let sum = |part: fn(&Step) -> u32| list.iter().map(part).sum::<u32>();
            let mut vector = before.to_vec();
            for (value, cost) in vector.iter_mut().zip(&self.costs) {
                *value += match cost {
                    Cost::Makespan => u32::from(list.iter().any(|step| step.time > 0)),
                    Cost::SumOfCosts => sum(|step| step.steps),
                    Cost::Charges => sum(|step| step.charges),
                    Cost::Moves => sum(|step| step.moves),
                    Cost::Waits => sum(|step| step.waits),
                };
            }
            if let Some(last) = vector.last_mut() {
                *last += sum(|step| step.disturbed);
            }
            each(list.iter().map(|step| step.to).collect(), vector);
        }
    }

    fn cell(&self, robot: usize, state: State) -> Option<Cell> {
        match state.place {
            Place::At(cell) => Some(cell),
            Place::Done => Some(self.robots[robot].agent.goal),
            Place::Between(..) | Place::Gone => None,
        }
    }

    /// Where an agent may be at the time of the change, as steps from nowhere.
    fn first(&self, robot: &Robot) -> Vec<Step> {
        let state = State {
            place: robot.first,
            seen: 0,
            level: robot.level,
            progress: 0,
            held: robot.held,
            same: robot.is_old,
        };
        let states = match robot.first {
            Place::At(cell) => robot.enter(state, cell),
            _ => vec![state],
        };
        let steps = states.into_iter().map(|state| Step {
            steps: if state.place == Place::Done {
                0
            } else {
                robot.slept
            },
            ..robot.step(state, 0)
        });
        // Below the floor only who sleeps on may be.
        let lasts = |step: &Step| {
            robot.level >= self.floor || (robot.slept > 0 && step.to.place == Place::Done)
        };
        steps.filter(lasts).collect()
    }

    fn spend(&self, level: u32) -> Option<u32> {
        match level {
            UNLIMITED => Some(UNLIMITED),
            level if level > self.floor => Some(level - 1),
            _ => None,
        }
    }

    fn steps(&self, robot: &Robot, state: State, tick: u32) -> Vec<Step> {
        let later = State {
            held: state.held.saturating_sub(1),
            ..state
        };
        let mut found = Vec::new();
        let mut go = |state: State, edge, [charges, moves, waits]: [u32; 3]| {
            let step = robot.step(state, tick + 1);
            let recharged = state.same && (robot.charges.contains(&tick) != (charges > 0));
            let same = step.to.same && !recharged;
            found.push(Step {
                to: State { same, ..step.to },
                edge,
                time: 1,
                steps: 1,
                charges,
                moves,
                waits,
                disturbed: u32::from(state.same && !same),
            });
        };
        match state.place {
            Place::Done | Place::Gone => {
                let place = if self.stays { state.place } else { Place::Gone };
                return vec![Step {
                    steps: 0,
                    ..robot.step(State { place, ..state }, tick + 1)
                }];
            }
            Place::Between(u, v) => {
                if let Some(level) = self.spend(state.level) {
                    for state in robot.enter(State { level, ..later }, v) {
                        go(state, Some((u, v)), [0, 0, 0]);
                    }
                }
            }
            Place::At(u) => {
                let mut levels = vec![(self.spend(state.level), 0)];
                if let Some(battery) = robot.agent.battery
                    && self.world.is_charger(u)
                    && battery.capacity >= self.floor
                {
                    levels.push((Some(battery.capacity), 1));
                }
                for (level, charges) in levels {
                    let Some(level) = level else { continue };
                    let later = State { level, ..later };
                    go(later, None, [charges, 0, 1]);
                    for v in self.world.neighbours(u) {
                        let Some(progress) = robot.may_go(state, v) else {
                            continue;
                        };
                        let later = State { progress, ..later };
                        let edge = Some((u, v));
                        if self.world.is_slow(u, v) {
                            let place = Place::Between(u, v);
                            go(State { place, ..later }, edge, [charges, 1, 0]);
                        } else {
                            for state in robot.enter(later, v) {
                                go(state, edge, [charges, 1, 0]);
                            }
                        }
                    }
                }
            }
        }
        found
    }
}

impl Robot {
    /// What a change means to the agent.
    fn meet(&mut self, what: &What) {
        let me = self.agent.name.clone();
        match what {
            What::SetGoal { agent, cell } if *agent == me => {
                if self.agent.goal != *cell {
                    self.slept = 0;
                }
                self.agent.goal = *cell;
            }
            What::AddWaypoint { agent, cell } if *agent == me => {
                self.agent.waypoints.push(*cell);
                self.slept = 0;
            }
            What::DropWaypoint { agent, cell } if *agent == me => {
                self.agent.waypoints.retain(|waypoint| waypoint != cell);
            }
            What::SetBattery { agent, level } if *agent == me => self.level = *level,
            What::DelayAgent { agent, steps } if *agent == me => {
                let transit = matches!(self.first, Place::Between(..));
                self.held = self.held.max(steps + u32::from(transit));
            }
            _ => {}
        }
    }

    fn enter(&self, mut state: State, cell: Cell) -> Vec<State> {
        for (i, waypoint) in self.agent.waypoints.iter().enumerate() {
            if *waypoint == cell {
                state.seen |= 1 << i;
            }
        }
        state.place = Place::At(cell);
        let mut states = vec![state];
        let all = state.seen.count_ones() as usize == self.agent.waypoints.len();
        let through = self.by != Held::Path || state.progress + 1 == self.rest.len();
        if cell == self.agent.goal && all && through {
            let place = Place::Done;
            states.push(State {
                place,
                level: 0,
                held: 0,
                ..state
            });
        }
        states
    }

    /// A step to a state at a time, and whether it is the first that differs
    /// from the old plan.
    fn step(&self, mut to: State, tick: u32) -> Step {
        let last = self.old.len().saturating_sub(1);
        let same = match self.old.get(tick as usize) {
            Some(Some(cell)) if (tick as usize) < last => to.place == Place::At(*cell),
            Some(None) => matches!(to.place, Place::Between(..)),
            _ => matches!(to.place, Place::Done | Place::Gone),
        };
        let disturbed = u32::from(to.same && !same);
        to.same &= same;
        Step {
            to,
            edge: None,
            time: 0,
            steps: 0,
            charges: 0,
            moves: 0,
            waits: 0,
            disturbed,
        }
    }

    /// How far it has come on its path once it is at a cell next; `None` where
    /// it may not go there.
    fn may_go(&self, state: State, v: Cell) -> Option<usize> {
        if state.held > 0 {
            return None;
        }
        match self.by {
            Held::Nothing => Some(0),
            Held::Tunnel(_) => self.tunnel.contains(&v).then_some(0),
            Held::Path => {
                let next = state.progress + 1;
                (self.rest.get(next) == Some(&v)).then_some(next)
            }
        }
    }
}

/// The rows of the map after the changes.
fn edited(rows: &[String], changes: &[Change]) -> Vec<String> {
    let mut rows: Vec<Vec<char>> = rows.iter().map(|row| row.chars().collect()).collect();
    let mut set = |cell: &Cell, to: &dyn Fn(char) -> char| {
        let c = &mut rows[cell.y as usize][cell.x as usize];
        *c = to(*c);
    };
    let is_slow = |c: char| matches!(c, '~' | '*');
    let is_charger = |c: char| matches!(c, '+' | '*');
    let slow = |c: char| if is_charger(c) { '*' } else { '~' };
    let normal = |c: char| if is_charger(c) { '+' } else { '.' };
    let charger = |c: char| if is_slow(c) { '*' } else { '+' };
    let none = |c: char| if is_slow(c) { '~' } else { '.' };
    for change in changes {
        match &change.what {
            What::AddObstacle { cell } => set(cell, &|_| '#'),
            What::RemoveObstacle { cell } => set(cell, &|_| '.'),
            What::MoveObstacle { from, to } => {
                set(from, &|_| '.');
                set(to, &|_| '#');
            }
            What::SetSlow { cells } => cells.iter().for_each(|cell| set(cell, &slow)),
            What::SetNormal { cells } => cells.iter().for_each(|cell| set(cell, &normal)),
            What::AddCharger { cell } => set(cell, &charger),
            What::RemoveCharger { cell } => set(cell, &none),
            _ => {}
        }
    }
    rows.iter().map(|row| row.iter().collect()).collect()
}

/// The cells within so many steps of others.
fn around(world: &World, cells: &[Cell], width: u32) -> BTreeSet<Cell> {
    let free = |cell: &Cell| {
        let mut sides = world.neighbours(*cell).into_iter();
        sides.any(|side| world.neighbours(side).contains(cell))
    };
    let mut found: BTreeSet<Cell> = cells.iter().copied().collect();
    let mut edge: Vec<Cell> = cells.iter().copied().filter(|cell| free(cell)).collect();
    for _ in 0..width {
        let mut next = Vec::new();
        for cell in edge {
            next.extend(world.neighbours(cell));
        }
        found.extend(next.iter().copied());
        edge = next;
    }
    found
}
