//! Robots that keep to an order, step by step. It reads visits and links off the plan by itself
//! and shares nothing with the graph.

use std::collections::BTreeMap;

use giveway_model::change::{Changes, History, Trajectory, What};
use giveway_model::constraint::{ConstraintKind, Heading};
use giveway_model::{Cell, Plan};

/// A robot's visits, as the plan has them.
#[derive(Debug)]
pub(crate) struct Robot {
    pub(crate) name: String,
    pub(crate) from: i64,
    pub(crate) until: Option<i64>,
    pub(crate) visits: Vec<(Cell, i64, i64)>,
    /// Whether the last event is that it leaves the floor.
    pub(crate) leaves: bool,
    /// The least steps at each visit before it goes on.
    stands: Vec<i64>,
}

impl Robot {
    pub(crate) fn events(&self) -> usize {
        self.visits.len() + usize::from(self.leaves)
    }
}

pub(crate) struct World<'a> {
    history: &'a History,
    changes: &'a Changes,
    pub(crate) robots: Vec<Robot>,
    /// Who has to leave before a robot comes, by robot and visit: all others that are there
    /// before, the last first, each with its visit and how many steps before.
    pub(crate) links: Links,
}

/// By robot and visit: others that are there before, with their visits and the steps between.
pub(crate) type Links = BTreeMap<(usize, usize), Vec<(usize, usize, i64)>>;

/// What came of it: the begin of each event, where it came to that, and where each robot is
/// from time 0 on.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) begins: Vec<Vec<Option<i64>>>,
    pub(crate) arrives: Vec<Vec<Option<i64>>>,
    pub(crate) cells: Vec<Vec<Option<Cell>>>,
    pub(crate) done: bool,
    pub(crate) collision: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    /// Not there yet.
    Coming,
    At {
        visit: usize,
        since: i64,
    },
    Moving {
        visit: usize,
        arrives: i64,
        from: Option<Cell>,
    },
    Gone,
}

impl<'a> World<'a> {
    pub(crate) fn new(history: &'a History, changes: &'a Changes, plan: &'a Plan) -> Self {
        let mut robots = Vec::new();
        for timeline in history.timelines() {
            let Some(it) = Trajectory::of(history, timeline, plan) else {
                continue;
            };
            let mut visits: Vec<(Cell, i64, i64)> = Vec::new();
            let last = timeline.from as usize + it.path.len();
            let last = timeline.until.map_or(last, |until| until as usize);
            let mut before = None;
            for time in timeline.from as usize..last {
                let now = it.at(time as u32);
                if let Some(cell) = now {
                    if before == Some(cell) {
                        visits.last_mut().unwrap().2 = time as i64;
                    } else {
                        visits.push((cell, time as i64, time as i64));
                    }
                }
                before = now;
            }
            robots.push(Robot {
                name: timeline.name().to_owned(),
                from: i64::from(timeline.from),
                until: timeline.until.map(i64::from),
                leaves: timeline.until.is_some() || !history.keeps(timeline),
                stands: stands(history, timeline.name(), timeline.agent.heading, &visits),
                visits,
            });
        }
        let links = links(history, &robots);
        Self {
            history,
            changes,
            robots,
            links,
        }
    }

    /// Whether robots without clocks wait for ever.
    pub(crate) fn waits_for_itself(&self) -> bool {
        !self.run(600, &mut |_, _, _| true).done
    }

    /// Lets all robots go; `may` says whether a robot may begin an event at a time.
    pub(crate) fn run(&self, most: i64, may: &mut dyn FnMut(usize, usize, i64) -> bool) -> Run {
        let count = self.robots.len();
        let mut run = Run {
            begins: self
                .robots
                .iter()
                .map(|it| vec![None; it.events()])
                .collect(),
            arrives: self
                .robots
                .iter()
                .map(|it| vec![None; it.visits.len()])
                .collect(),
            cells: vec![Vec::new(); count],
            done: false,
            collision: None,
        };
        let mut states = vec![State::Coming; count];
        // Until when a breakdown keeps each robot.
        let mut held = vec![-1; count];
        // Edges that are crossed: from, to, and the first and last step.
        let mut crossed: Vec<(usize, Cell, Cell, i64, i64)> = Vec::new();
        for time in -1..most {
            for (number, robot) in self.robots.iter().enumerate() {
                match states[number] {
                    State::Moving { visit, arrives, .. } if arrives == time => {
                        states[number] = State::At { visit, since: time };
                        run.arrives[number][visit] = Some(time);
                    }
                    State::Coming if robot.from == 0 && time == -1 => {
                        // It stands at its start at time 0, and may be ready later.
                        run.begins[number][0] = Some(-1);
                        states[number] = State::Moving {
                            visit: 0,
                            arrives: 0,
                            from: None,
                        };
                    }
                    _ => {}
                }
                if robot.until == Some(time) {
                    states[number] = State::Gone;
                }
            }
            self.break_down(time, &states, &mut held);
            if time >= 0 {
                self.note(time, &states, &mut run);
            }
            let going = self.going(time, (&states, &held), &run, may);
            for &number in &going {
                let robot = &self.robots[number];
                let (visit, from) = match states[number] {
                    State::Coming => (0, None),
                    State::At { visit, .. } => (visit + 1, Some(robot.visits[visit].0)),
                    _ => unreachable!(),
                };
                run.begins[number][visit] = Some(time);
                let Some(&(to, ..)) = robot.visits.get(visit) else {
                    states[number] = State::Gone;
                    continue;
                };
                let slow = from.is_some_and(|from| self.is_slow(from, to, time));
                let arrives = time + 1 + i64::from(slow);
                states[number] = State::Moving {
                    visit,
                    arrives,
                    from,
                };
                if let Some(from) = from {
                    for &(other, a, b, first, last) in &crossed {
                        let meets = first < arrives && time <= last;
                        if meets && a == to && b == from {
                            let (one, other) = (&robot.name, &self.robots[other].name);
                            run.collision
                                .get_or_insert(format!("{one} {other} swap at {time}"));
                        }
                    }
                    crossed.push((number, from, to, time, arrives - 1));
                }
            }
            let at_end = |(robot, state): (&Robot, &State)| match state {
                State::Gone => true,
                State::At { visit, .. } => visit + 1 == robot.events(),
                State::Coming | State::Moving { .. } => false,
            };
            if self.robots.iter().zip(&states).all(at_end) {
                run.done = true;
                return run;
            }
        }
        run
    }

    /// Robots that break down at a time, from the end of a slow move under way.
    fn break_down(&self, time: i64, states: &[State], held: &mut [i64]) {
        for change in self
            .changes
            .changes
            .iter()
            .filter(|it| i64::from(it.at) == time)
        {
            let What::DelayAgent { agent, steps } = &change.what else {
                continue;
            };
            let number = self.robots.iter().position(|it| it.name == *agent).unwrap();
            let moving = matches!(states[number], State::Moving { from: Some(_), .. });
            held[number] = held[number].max(time + i64::from(moving) + i64::from(*steps));
        }
    }

    /// Where everyone is at a time.
    fn note(&self, time: i64, states: &[State], run: &mut Run) {
        let mut here: BTreeMap<Cell, usize> = BTreeMap::new();
        for (number, state) in states.iter().enumerate() {
            let cell = match state {
                State::At { visit, .. } => Some(self.robots[number].visits[*visit].0),
                State::Coming | State::Moving { .. } | State::Gone => None,
            };
            run.cells[number].resize(time as usize, None);
            run.cells[number].push(cell);
            if let Some(cell) = cell
                && let Some(other) = here.insert(cell, number)
            {
                let (one, other) = (&self.robots[number].name, &self.robots[other].name);
                run.collision
                    .get_or_insert(format!("{one} {other} at {cell}, {time}"));
            }
        }
    }

    /// The most robots that can begin an event together.
    fn going(
        &self,
        time: i64,
        (states, held): (&[State], &[i64]),
        run: &Run,
        may: &mut dyn FnMut(usize, usize, i64) -> bool,
    ) -> Vec<usize> {
        let mut next: BTreeMap<usize, usize> = BTreeMap::new();
        for (number, robot) in self.robots.iter().enumerate() {
            let event = match states[number] {
                State::Coming if time + 1 >= robot.from => 0,
                State::At { visit, since } if time >= since + robot.stands[visit] => visit + 1,
                _ => continue,
            };
            if event >= robot.events() {
                continue;
            }
            let is_move = event > 0 && event < robot.visits.len();
            let held = time < held[number];
            let early = event == robot.visits.len() && robot.until.is_some_and(|it| time + 1 < it);
            let free = !early && (!is_move || !held);
            if free && may(number, event, time) {
                next.insert(number, event);
            }
        }
        loop {
            let waits = |(&number, &event): (&usize, &usize)| {
                let links = self.links.get(&(number, event)).into_iter().flatten();
                links.into_iter().any(|&(other, visit, gap)| {
                    let removed = self.robots[other].until.map(|until| until - 1);
                    let begun = run.begins[other][visit + 1]
                        .into_iter()
                        .chain(removed)
                        .min();
                    let together = gap == 0 && next.get(&other) == Some(&(visit + 1));
                    !together && begun.is_none_or(|begun| time < begun + gap)
                })
            };
            let Some(number) = next.iter().find(|it| waits(*it)).map(|it| *it.0) else {
                return next.into_keys().collect();
            };
            next.remove(&number);
        }
    }

    fn is_slow(&self, from: Cell, to: Cell, time: i64) -> bool {
        self.history.grid(time.max(0) as u32).is_slow_edge(from, to)
    }
}

/// The steps in which a robot turns at each visit before it goes on.
fn stands(
    history: &History,
    name: &str,
    first: Option<Heading>,
    visits: &[(Cell, i64, i64)],
) -> Vec<i64> {
    let quarter = history
        .constraints()
        .iter()
        .filter_map(|it| match &it.constraint.kind {
            ConstraintKind::Turns { quarter } => {
                let names = it.constraint.agents.as_ref();
                let bound = names.is_none_or(|names| names.iter().any(|it| it == name));
                bound.then_some(i64::from(*quarter))
            }
            _ => None,
        });
    let quarter = quarter.max().unwrap_or(0);
    let mut stands = vec![0; visits.len()];
    let mut facing = first;
    for i in 1..visits.len() {
        let next = Heading::of(visits[i - 1].0, visits[i].0);
        if let (Some(a), Some(b)) = (facing, next) {
            stands[i - 1] = quarter * i64::from(a.quarters_to(b));
        }
        facing = next;
    }
    stands
}

fn links(history: &History, robots: &[Robot]) -> Links {
    let mut cells: BTreeMap<Cell, Vec<(i64, usize, usize)>> = BTreeMap::new();
    for (number, robot) in robots.iter().enumerate() {
        for (visit, &(cell, arrives, _)) in robot.visits.iter().enumerate() {
            cells
                .entry(cell)
                .or_default()
                .push((arrives, number, visit));
        }
    }
    let mut links = Links::new();
    for visits in cells.values_mut() {
        visits.sort_unstable();
        for (number, &(arrives, other, comes)) in visits.iter().enumerate() {
            for &(_, one, visit) in visits[..number].iter().rev().filter(|it| it.1 != other) {
                let closed = closed(history, &robots[one].name, &robots[other].name);
                let begins = match comes.checked_sub(1) {
                    Some(before) => robots[other].visits[before].2,
                    None => arrives - 1,
                };
                let gap = closed.map_or(0, |closed| (closed + 1 - (arrives - begins)).max(0));
                links
                    .entry((other, comes))
                    .or_default()
                    .push((one, visit, gap));
            }
        }
    }
    links
}

/// How long a cell stays closed to the second after the first was there.
fn closed(history: &History, first: &str, second: &str) -> Option<i64> {
    let closed = history
        .constraints()
        .iter()
        .filter_map(|it| match &it.constraint.kind {
            ConstraintKind::Gap { steps } => {
                let names = it.constraint.agents.as_ref();
                let binds =
                    |name: &str| names.is_none_or(|names| names.iter().any(|it| it == name));
                (binds(first) && binds(second)).then_some(i64::from(*steps))
            }
            _ => None,
        });
    closed.max()
}
