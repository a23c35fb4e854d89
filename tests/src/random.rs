//! Random instances: the same seed and number give the same instance for ever.
//!
//! The generator and its version are pinned in the manifest of the workspace.
//! [`small`] instances are for the oracle: at most 3 agents on at most 20 cells,
//! with everything that the problem knows. [`medium`] ones, of up to 8x8 cells
//! and 6 agents, are too large for it.

mod map;

use giveway_model::{Agent, AtGoal, Battery, Cell, Cost, Instance, Objective, Rules, Scene};
use rand::seq::{IndexedRandom, SliceRandom};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::environment;
use map::Map;

/// The random numbers of one instance.
pub(crate) fn numbers(seed: u64, number: u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(number);
    random
}

/// A small instance: 0 to 3 agents, all five costs in any order, obstacles, slow
/// zones, chargers, waypoints, batteries, floors and both arrival rules. Some
/// are impossible.
pub fn small(seed: u64, number: u64) -> Instance {
    let random = &mut numbers(seed, number);
    let agents = *[0, 1, 1, 2, 2, 2, 2, 2, 3, 3].choose(random).unwrap();
    // The more agents, the less else, or the joint states would be too many.
    let (most_cells, most_waypoints, most_capacity) = match agents {
        0 | 1 => (20, 3, 14),
        2 => (20, 2, 10),
        _ => (12, 1, 8),
    };
    let size = Size {
        agents,
        waypoints: most_waypoints,
        capacity: 3..=most_capacity,
        batteries: if agents == 3 { 0.3 } else { 0.5 },
    };
    loop {
        let width = *[1, 2, 3, 4, 4, 5, 5].choose(random).unwrap();
        let height = *[1, 2, 3, 3, 4].choose(random).unwrap();
        let obstacles = *[0.0, 0.15, 0.3].choose(random).unwrap();
        let mut map = Map::new(random, width, height, obstacles);
        if random.random_bool(0.9) {
            map = map.connected();
        }
        if map.free.len() >= agents && map.free.len() <= most_cells {
            return wanted(size.instance(random, &map), seed, number);
        }
    }
}

/// A small instance with more agents: 2 to 4 on at most 12 cells, at least a third
/// of them free. Otherwise as [`small`].
pub fn crowded(seed: u64, number: u64) -> Instance {
    let random = &mut numbers(seed, number);
    let agents = *[2, 2, 3, 3, 4].choose(random).unwrap();
    let size = Size {
        agents,
        waypoints: 1,
        capacity: 3..=8,
        batteries: if agents == 2 { 0.5 } else { 0.2 },
    };
    loop {
        let (width, height) = (random.random_range(2..=4), random.random_range(2..=4));
        let obstacles = *[0.0, 0.1, 0.2].choose(random).unwrap();
        let map = Map::new(random, width, height, obstacles).connected();
        if ((3 * agents).div_ceil(2)..=12).contains(&map.free.len()) {
            return wanted(size.instance(random, &map), seed, number);
        }
    }
}

/// A medium instance, on a connected map: 4x4 to 8x8 cells, 2 to 6 agents.
pub fn medium(seed: u64, number: u64) -> Instance {
    let random = &mut numbers(seed, number);
    let size = Size {
        agents: random.random_range(2..=6),
        waypoints: 1,
        capacity: 10..=24,
        batteries: 0.3,
    };
    loop {
        let (width, height) = (random.random_range(4..=8), random.random_range(4..=8));
        let obstacles = *[0.0, 0.1, 0.2].choose(random).unwrap();
        let map = Map::new(random, width, height, obstacles).connected();
        if map.free.len() >= 3 * size.agents {
            return size.instance(random, &map);
        }
    }
}

/// The instance, or with `GIVEWAY_RANDOM_GOALLESS=1` the same with agents that have no
/// goal: every test of random instances can be run over such ones.
fn wanted(instance: Instance, seed: u64, number: u64) -> Instance {
    match environment::number("GIVEWAY_RANDOM_GOALLESS", 0) {
        0 => instance,
        _ => goalless(&instance, seed, number),
    }
}

/// A [`small`] instance where some agents have no goal.
pub fn small_goalless(seed: u64, number: u64) -> Instance {
    goalless(&small(seed, number), seed, number)
}

/// The same instance where half of the agents, and one at least, have no goal: they
/// may rest at any cell.
pub fn goalless(instance: &Instance, seed: u64, number: u64) -> Instance {
    let random = &mut numbers(seed ^ 0x60a1, number);
    let mut scene = instance.to_scene();
    let certain = random.random_range(0..scene.agents.len().max(1));
    for (i, agent) in scene.agents.iter_mut().enumerate() {
        if random.random_bool(0.5) || i == certain {
            agent.goal = None;
        }
    }
    Instance::new(scene).expect("fewer goals are as different as before")
}

/// A cell of the map on which an obstacle may be put without touching a start, a
/// goal or a waypoint, if there is one.
pub fn spare_cell(instance: &Instance, seed: u64) -> Option<Cell> {
    let used = |cell: Cell| {
        let mut agents = instance.agents().iter();
        agents.any(|a| a.start == cell || a.goal == Some(cell) || a.waypoints.contains(&cell))
    };
    let cells = instance.grid().cells();
    let spare: Vec<Cell> = cells
        .filter(|&(cell, ground)| ground.is_vertex() && !used(cell))
        .map(|(cell, _)| cell)
        .collect();
    spare.choose(&mut numbers(seed, 0)).copied()
}

/// The instance, every other one with a battery floor of 1 to 3.
pub fn with_floor(instance: Instance, number: u64) -> Instance {
    if number.is_multiple_of(2) {
        return instance;
    }
    instance.with_battery_floor(1 + (number / 2 % 3) as u32)
}

/// Some of all pairs of different things, at most so many.
pub fn pairs<T: Clone>(things: &[T], seed: u64, most: usize) -> Vec<[T; 2]> {
    let mut pairs: Vec<[T; 2]> = Vec::new();
    for (number, first) in things.iter().enumerate() {
        let others = things.iter().skip(number + 1);
        pairs.extend(others.map(|second| [first.clone(), second.clone()]));
    }
    pairs.shuffle(&mut numbers(seed, 0));
    pairs.truncate(most);
    pairs
}

/// How large an instance may be.
struct Size {
    agents: usize,
    waypoints: usize,
    capacity: std::ops::RangeInclusive<u32>,
    /// The probability of a battery.
    batteries: f64,
}

impl Size {
    fn instance(&self, random: &mut ChaCha8Rng, map: &Map) -> Instance {
        let at_goal = *[AtGoal::Stay, AtGoal::Vanish].choose(random).unwrap();
        let mut starts = map.free.clone();
        starts.shuffle(random);
        let mut goals = map.free.clone();
        goals.shuffle(random);
        let vanish = at_goal == AtGoal::Vanish;
        if let Some(&goal) = goals.first()
            && vanish
            && random.random_bool(0.3)
        {
            goals.insert(0, goal); // of two agents
        }
        let ends = starts.into_iter().zip(goals).take(self.agents);
        let agents = (1..).zip(ends).map(|(i, (start, goal))| Agent {
            name: format!("A{i}"),
            start,
            goal: Some(if vanish && random.random_bool(0.1) {
                start
            } else {
                goal
            }),
            waypoints: self.waypoints(random, map),
            battery: self.battery(random),
            heading: None,
        });
        let scene = Scene {
            name: "random".to_owned(),
            agents: agents.collect(),
            map: map.rows.iter().map(|row| row.iter().collect()).collect(),
            rules: Rules {
                at_goal,
                battery_floor: *[0, 0, 0, 1, 2].choose(random).unwrap(),
            },
            objective: objective(random),
            ..Scene::default()
        };
        Instance::new(scene).expect("the generator keeps the promises of an instance")
    }

    fn waypoints(&self, random: &mut ChaCha8Rng, map: &Map) -> Vec<Cell> {
        let count = random.random_range(0..=self.waypoints);
        map.free.sample(random, count).copied().collect()
    }

    fn battery(&self, random: &mut ChaCha8Rng) -> Option<Battery> {
        random.random_bool(self.batteries).then(|| {
            let capacity = random.random_range(self.capacity.clone());
            Battery {
                capacity,
                initial: random.random_range(capacity / 2..=capacity),
            }
        })
    }
}

/// One to five costs in any order.
fn objective(random: &mut ChaCha8Rng) -> Objective {
    let mut costs = Cost::USUAL.to_vec();
    costs.shuffle(random);
    costs.truncate(random.random_range(1..=costs.len()));
    Objective::new(costs).unwrap()
}
