//! Random scenes with rules of their own, as JSON: the same seed and number give the same
//! scene for ever.

use rand::RngExt;
use rand::seq::{IndexedRandom, SliceRandom};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use crate::random::numbers;

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

    fn zone(&mut self) -> Value {
        let count = self.random.random_range(1..=self.free.len().min(4));
        let mut cells = self.free.clone();
        cells.shuffle(self.random);
        cells.truncate(count);
        let name = format!("zone {}", self.zones.len());
        self.zones.push(json!({ "name": name, "cells": cells }));
        json!(name)
    }

    fn times(&mut self, rule: &mut Value) {
        let from = self.random.random_range(0..=5);
        match self.random.random_range(0..4) {
            0 => rule["from"] = json!(from),
            1 => rule["to"] = json!(from),
            2 => {
                rule["from"] = json!(from);
                rule["to"] = json!(from + self.random.random_range(0..=4));
            }
            _ => {}
        }
    }

    fn at(&mut self) -> Value {
        let agent = self.random.random_range(0..self.agents);
        json!({ "agent": format!("A{agent}"), "cell": self.cell() })
    }

    /// A rule of a kind; `null` where the map has none.
    fn rule(&mut self, kind: &str) -> Value {
        let mut rule = json!({ "kind": kind });
        match kind {
            "capacity" => {
                rule["zone"] = self.zone();
                rule["most"] = json!(self.random.random_range(0..=2));
                self.times(&mut rule);
            }
            "closed" => {
                rule["zone"] = self.zone();
                self.times(&mut rule);
            }
            "one-way" => {
                let mut lane = vec![self.cell()];
                for _ in 0..self.random.random_range(1..=3) {
                    let (x, y) = lane[lane.len() - 1];
                    let next = |&&(a, b): &&Spot| a.abs_diff(x) + b.abs_diff(y) == 1;
                    let next: Vec<&Spot> = self.free.iter().filter(next).collect();
                    let next = next.into_iter().filter(|spot| !lane.contains(spot));
                    let next: Vec<&Spot> = next.collect();
                    let Some(&&next) = next.choose(self.random) else {
                        break;
                    };
                    lane.push(next);
                }
                if lane.len() < 2 {
                    return Value::Null;
                }
                rule["lane"] = json!(lane);
            }
            "gap" => rule["steps"] = json!(self.random.random_range(1..=3)),
            "apart" => {
                rule["distance"] = json!(self.random.random_range(2..=3));
                self.times(&mut rule);
            }
            "sequence" => {
                let cells = (0..self.random.random_range(1..=3)).map(|_| self.cell());
                let cells: Vec<Spot> = cells.collect();
                rule["cells"] = json!(cells);
                rule["agent"] = json!(format!("A{}", self.random.random_range(0..self.agents)));
                return rule;
            }
            "visit" => {
                rule["cell"] = json!(self.cell());
                let stay = self.random.random_range(0..=2);
                rule["stay"] = json!(stay);
                self.times(&mut rule);
                if let Some(to) = rule["to"].as_u64() {
                    rule["to"] = json!(to + stay + 2);
                }
            }
            "arrive" => {
                let by = self.random.random_range(2..=9);
                if self.random.random_bool(0.6) {
                    rule["from"] = json!(self.random.random_range(0..=by));
                }
                if rule["from"].is_null() || self.random.random_bool(0.4) {
                    rule["by"] = json!(by);
                }
            }
            "late" => {
                rule["kind"] = json!("arrive");
                rule["by"] = json!(self.random.random_range(0..=5));
                rule["weight"] = json!(self.random.random_range(1..=5));
            }
            "depart" => rule["from"] = json!(self.random.random_range(0..=4)),
            "before" => {
                rule["first"] = self.at();
                rule["second"] = self.at();
                return rule;
            }
            "no-waiting" => {
                rule["zone"] = self.zone();
                rule["most"] = json!(self.random.random_range(0..=2));
            }
            "turns" => rule["quarter"] = json!(self.random.random_range(1..=2)),
            _ => {
                rule["zone"] = self.zone();
                rule["weight"] = json!(self.random.random_range(1..=5));
            }
        }
        if self.random.random_bool(0.4) {
            let mut names: Vec<String> = (0..self.agents).map(|i| format!("A{i}")).collect();
            names.shuffle(self.random);
            names.truncate(self.random.random_range(1..=self.agents));
            rule["agents"] = json!(names);
        }
        rule
    }
}

/// A scene whose plan is to go on when the world changes, and a rule for it that begins
/// later: the last of those of some kinds. The makespan counts first.
pub fn scene_to_change(seed: u64, number: u64, kinds: &[&str]) -> (Value, Value) {
    let mut scene = scene_with_rules(seed, number, kinds);
    let rules = scene["constraints"].as_array_mut();
    let rule = rules.and_then(Vec::pop).unwrap_or_default();
    let costs = scene["objective"].as_array().cloned().unwrap_or_default();
    let others = costs.into_iter().filter(|cost| *cost != "makespan");
    let costs: Vec<Value> = [json!("makespan")].into_iter().chain(others).collect();
    scene["objective"] = json!(costs);
    (scene, rule)
}

/// What changes at one time: mostly a rule that begins or is gone, and other things. Some
/// contradict the world.
pub fn changes_of_rules(
    seed: u64,
    number: u64,
    (scene, rule): (&Value, &Value),
    makespan: u32,
) -> Vec<Value> {
    let random = &mut numbers(seed ^ 0x21e5, number);
    let at = random.random_range(0..=makespan + 1);
    let rules = scene["constraints"].as_array().map_or(0, Vec::len);
    let agents = scene["agents"].as_array().map_or(0, Vec::len);
    let mut changes = Vec::new();
    let which = random.random_range(0..10);
    if which < 6 {
        changes.push(json!({ "change": "add-constraint", "constraint": rule }));
    } else if which < 8 && rules > 0 {
        let index = random.random_range(0..rules);
        changes.push(json!({ "change": "remove-constraint", "index": index }));
    }
    if changes.is_empty() || random.random_bool(0.5) {
        let agent = format!("A{}", random.random_range(0..agents));
        let rows: Vec<&str> = scene["map"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(Value::as_str)
            .collect();
        let cells = rows.iter().enumerate().flat_map(|(y, row)| {
            let free = row.chars().enumerate().filter(|(_, c)| *c != '#');
            free.map(move |(x, _)| (x, y))
        });
        let cells: Vec<Spot> = cells.collect();
        let cell = |random: &mut ChaCha8Rng| *cells.choose(random).unwrap();
        changes.push(match random.random_range(0..8) {
            0..=3 => {
                let steps = random.random_range(1..=5);
                json!({ "change": "delay-agent", "agent": agent, "steps": steps })
            }
            4 => json!({ "change": "remove-agent", "agent": agent }),
            5 => json!({ "change": "set-goal", "agent": agent, "cell": cell(random) }),
            6 if agents < 3 => {
                let new = json!({ "name": "N", "start": cell(random), "goal": cell(random) });
                json!({ "change": "add-agent", "agent": new })
            }
            _ => json!({ "change": "add-obstacle", "cell": cell(random) }),
        });
    }
    for change in &mut changes {
        change["at"] = json!(at);
    }
    changes
}
