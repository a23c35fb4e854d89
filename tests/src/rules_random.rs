//! Random scenes with rules of their own, as JSON: the same seed and number give the same
//! scene for ever.

mod changes;
mod rule;

use rand::RngExt;
use rand::seq::{IndexedRandom, SliceRandom};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use crate::random::numbers;
pub use changes::{changes_of_rules, scene_to_change};

/// The kinds of rules; the last costs late steps.
pub const KINDS: [&str; 14] = [
    "capacity",
    "closed",
    "one-way",
    "gap",
    "apart",
    "sequence",
    "visit",
    "arrive",
    "depart",
    "before",
    "no-waiting",
    "turns",
    "avoid",
    "late",
];

type Spot = (usize, usize);

/// A scene of 2 or 3 agents on few cells, with a rule of each of some kinds.
pub fn scene_with_rules(seed: u64, number: u64, kinds: &[&str]) -> Value {
    let random = &mut numbers(seed, number);
    loop {
        let agents = *[2, 2, 3].choose(random).unwrap();
        let size = *[(3, 2), (3, 3), (4, 2), (5, 1), (4, 3), (2, 4)]
            .choose(random)
            .unwrap();
        let most = if agents == 3 { 8 } else { usize::MAX };
        if let Some(mut scene) = scene(random, (agents, size, most), kinds) {
            scene["name"] = json!(format!("rules {seed}-{number}"));
            return scene;
        }
    }
}

/// The same with 3 to 6 agents on more cells: too many for an exhaustive search.
pub fn crowd_with_rules(seed: u64, number: u64, kinds: &[&str]) -> Value {
    let random = &mut numbers(seed, number);
    loop {
        let agents = random.random_range(3..=6);
        let size = *[(5, 3), (4, 4), (6, 4), (5, 5), (8, 2)]
            .choose(random)
            .unwrap();
        if let Some(mut scene) = scene(random, (agents, size, usize::MAX), kinds) {
            scene["name"] = json!(format!("crowd {seed}-{number}"));
            return scene;
        }
    }
}

/// A scene of so many agents on a map of a size with at most so many free cells; `None`
/// where the numbers give none.
fn scene(
    random: &mut ChaCha8Rng,
    (agents, (width, height), most): (usize, Spot, usize),
    kinds: &[&str],
) -> Option<Value> {
    let vanish = random.random_bool(0.3);
    let (wall, slow, charger) = (
        *[0.0, 0.1, 0.2].choose(random).unwrap(),
        *[0.0, 0.0, 0.4].choose(random).unwrap(),
        0.15,
    );
    let mut rows = vec![String::new(); height];
    let mut free: Vec<Spot> = Vec::new();
    for (y, row) in rows.iter_mut().enumerate() {
        for x in 0..width {
            let is_free = !random.random_bool(wall);
            let (slow, charger) = (random.random_bool(slow), random.random_bool(charger));
            row.push(match (is_free, slow, charger) {
                (false, ..) => '#',
                (true, false, false) => '.',
                (true, true, false) => '~',
                (true, false, true) => '+',
                (true, true, true) => '*',
            });
            free.extend(is_free.then_some((x, y)));
        }
    }
    if free.len() < agents + 2 || free.len() > most {
        return None;
    }
    let mut world = World {
        random,
        free,
        agents,
        zones: Vec::new(),
    };
    let agents: Vec<Value> = world.agents();
    let constraints: Vec<Value> = kinds.iter().map(|kind| world.rule(kind)).collect();
    if constraints.iter().any(Value::is_null) {
        return None;
    }
    let mut costs = vec!["makespan", "sum-of-costs", "charges", "moves", "waits"];
    costs.shuffle(world.random);
    costs.truncate(world.random.random_range(1..=3));
    if world.random.random_bool(0.2) {
        let place = world.random.random_range(0..=costs.len());
        costs.insert(place, "penalty");
    }
    let rules = json!({
        "at_goal": if vanish { "vanish" } else { "stay" },
        "battery_floor": u32::from(world.random.random_bool(0.15)),
    });
    Some(json!({
        "giveway": 1, "map": rows, "rules": rules,
        "objective": costs, "agents": agents, "zones": world.zones, "constraints": constraints,
    }))
}

struct World<'r> {
    random: &'r mut ChaCha8Rng,
    free: Vec<Spot>,
    agents: usize,
    zones: Vec<Value>,
}

impl World<'_> {
    fn cell(&mut self) -> Spot {
        *self.free.choose(self.random).unwrap()
    }

    fn agents(&mut self) -> Vec<Value> {
        let mut starts = self.free.clone();
        starts.shuffle(self.random);
        let mut goals = self.free.clone();
        goals.shuffle(self.random);
        let mut agents = Vec::new();
        for i in 0..self.agents {
            let mut agent =
                json!({ "name": format!("A{i}"), "start": starts[i], "goal": goals[i] });
            if self.random.random_bool(0.25) {
                agent["waypoints"] = json!([self.cell()]);
            }
            if self.random.random_bool(0.25) {
                let capacity = self.random.random_range(4..=9);
                let initial = self.random.random_range(capacity / 2..=capacity);
                agent["battery"] = json!({ "capacity": capacity, "initial": initial });
            }
            if self.random.random_bool(0.5) {
                let headings = ["north", "east", "south", "west"];
                agent["heading"] = json!(headings.choose(self.random));
            }
            agents.push(agent);
        }
        agents
    }
}
