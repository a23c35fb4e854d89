//! Random changes of the world while a plan runs. Some contradict the world.

use giveway_model::change::{Change, What};
use giveway_model::{Agent, Battery, Cell, Instance};
use rand::RngExt;
use rand::seq::IndexedRandom;

use crate::random::numbers;

/// One to three changes at one time, some of them after the makespan.
pub fn changes(instance: &Instance, makespan: u32, seed: u64, number: u64) -> Vec<Change> {
    let random = &mut numbers(seed ^ 0x5eed, number);
    let cells: Vec<Cell> = instance.grid().cells().map(|(cell, _)| cell).collect();
    let cell = |random: &mut _| *cells.choose(random).unwrap();
    let at = random.random_range(0..=makespan + 2);
    let count = *[1, 1, 1, 2, 3].choose(random).unwrap();
    let mut whats = Vec::new();
    for i in 0..count {
        let agents = instance.agents();
        let agent = agents
            .choose(random)
            .map_or(String::new(), |agent| agent.name.clone());
        let kind = random.random_range(0..16);
        whats.push(match kind {
            0..=2 => What::AddAgent {
                agent: Agent {
                    name: format!("N{i}"),
                    start: cell(random),
                    goal: Some(cell(random)),
                    waypoints: Vec::new(),
                    battery: random.random_bool(0.2).then_some(Battery {
                        capacity: 9,
                        initial: 8,
                    }),
                    heading: None,
                },
            },
            3 if random.random_bool(0.5) => What::StopAgent { agent },
            3 => What::RemoveAgent { agent },
            4..=5 => What::AddObstacle { cell: cell(random) },
            6 => What::RemoveObstacle { cell: cell(random) },
            7 => What::MoveObstacle {
                from: cell(random),
                to: cell(random),
            },
            8 => What::SetSlow {
                cells: vec![cell(random), cell(random)],
            },
            9 => What::SetNormal {
                cells: vec![cell(random)],
            },
            10 => What::RemoveCharger { cell: cell(random) },
            11 => What::AddCharger { cell: cell(random) },
            12 => What::SetGoal {
                agent,
                cell: cell(random),
            },
            13 => What::AddWaypoint {
                agent,
                cell: cell(random),
            },
            14 => What::SetBattery {
                agent,
                level: random.random_range(0..8),
            },
            _ => What::DelayAgent {
                agent,
                steps: random.random_range(0..4),
            },
        });
    }
    whats.into_iter().map(|what| Change { at, what }).collect()
}

/// One or two breakdowns at one time, short or longer than the plan, some of them
/// with other changes of that time.
pub fn breakdowns(instance: &Instance, makespan: u32, seed: u64, number: u64) -> Vec<Change> {
    let random = &mut numbers(seed ^ 0xb4ea, number);
    let at = random.random_range(0..=makespan + 1);
    let mut list = Vec::new();
    for _ in 0..random.random_range(1..=2) {
        let Some(agent) = instance.agents().choose(random) else {
            continue;
        };
        let longest = *[3, 6, makespan + 4].choose(random).unwrap_or(&3);
        let agent = agent.name.clone();
        let steps = random.random_range(0..=longest);
        let what = What::DelayAgent { agent, steps };
        list.push(Change { at, what });
    }
    if random.random_bool(0.3) {
        let others = changes(instance, makespan, seed, number).into_iter();
        list.extend(others.map(|change| Change { at, ..change }));
    }
    list
}

/// The side of the maps on which agents join.
pub const SIDE: u32 = 20;

/// A kind of map on which agents join others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// No obstacle.
    Empty,
    /// Nine rooms, a door in each wall between two.
    Rooms,
    /// So many percent of the cells are obstacles.
    Random(u32),
}

/// The rows of a map of [`SIDE`] x [`SIDE`] cells, and its largest connected
/// part.
pub fn field(field: Field, seed: u64) -> (Vec<String>, Vec<Cell>) {
    let random = &mut numbers(seed, 0);
    let walls = [6, 13];
    let doors: Vec<u32> = (0..6)
        .map(|i| 7 * (i % 3) + random.random_range(0..6))
        .collect();
    let is_door = |along: u32, wall: usize| doors[3 * wall..3 * wall + 3].contains(&along);
    let mut rows = Vec::new();
    for y in 0..SIDE {
        let mut row = String::new();
        for x in 0..SIDE {
            let wall = |line: u32| walls.iter().position(|&wall| wall == line);
            let obstacle = match field {
                Field::Empty => false,
                Field::Rooms => match (wall(x), wall(y)) {
                    (Some(_), Some(_)) => true,
                    (Some(i), None) => !is_door(y, i),
                    (None, Some(i)) => !is_door(x, i),
                    (None, None) => false,
                },
                Field::Random(percent) => random.random_range(0..100) < percent,
            };
            row.push(if obstacle { '#' } else { '.' });
        }
        rows.push(row);
    }
    let is_free = |cell: &Cell| rows[cell.y as usize].as_bytes()[cell.x as usize] == b'.';
    let all: Vec<Cell> = (0..SIDE * SIDE)
        .map(|i| Cell::new(i % SIDE, i / SIDE))
        .collect();
    let mut left: Vec<Cell> = all.into_iter().filter(is_free).collect();
    let mut largest = Vec::new();
    while let Some(&first) = left.first() {
        let mut part = vec![first];
        let mut next = 0;
        while let Some(&u) = part.get(next) {
            next += 1;
            let near: Vec<Cell> = left.iter().copied().filter(|v| u.touches(*v)).collect();
            part.extend(
                near.into_iter()
                    .filter(|v| !part.contains(v))
                    .collect::<Vec<_>>(),
            );
        }
        left.retain(|cell| !part.contains(cell));
        if part.len() > largest.len() {
            largest = part;
        }
    }
    (rows, largest)
}

/// So many agents from cells to others, by chance; none has the start of
/// another, nor its goal.
pub fn crowd(
    prefix: &str,
    count: usize,
    (starts, goals): (&[Cell], &[Cell]),
    seed: u64,
    number: u64,
) -> Vec<Agent> {
    let random = &mut numbers(seed, number);
    let starts = starts.sample(random, count).copied().collect::<Vec<_>>();
    let goals = goals.sample(random, count).copied().collect::<Vec<_>>();
    let ends = starts.into_iter().zip(goals);
    let agents = (1..).zip(ends).map(|(i, (start, goal))| Agent {
        name: format!("{prefix}{i}"),
        start,
        goal: Some(goal),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    });
    agents.collect()
}
