//! Random scenes of two rooms with one passage between them, as JSON: the same seed and number
//! give the same scene for ever.

use rand::RngExt;
use rand::seq::{IndexedRandom, SliceRandom};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use crate::random::numbers;

type Spot = (usize, usize);

/// A scene of 2 to 4 agents, most of which have to change rooms.
pub fn scene_with_gate(seed: u64, number: u64) -> Value {
    let random = &mut numbers(seed, number);
    let agents = *[2, 3, 3, 4].choose(random).unwrap();
    let height = *[2, 3].choose(random).unwrap();
    let length = *[1, 1, 2, 3].choose(random).unwrap();
    let gap = random.random_range(0..height);
    let widths = [random.random_range(1..=2), random.random_range(1..=2)];
    let width = widths[0] + length + widths[1];
    let slow = *[0.0, 0.0, 0.3].choose(random).unwrap();
    let [mut rooms, mut passage] = [[Vec::new(), Vec::new()], [Vec::new(), Vec::new()]];
    let mut rows = vec![String::new(); height];
    for (y, row) in rows.iter_mut().enumerate() {
        for x in 0..width {
            let side = usize::from(x >= widths[0] + length);
            let is_room = x < widths[0] || side == 1;
            // Now and then there is a second way, or the room has a pillar.
            let is_free = if is_room {
                !random.random_bool(0.05)
            } else {
                y == gap || random.random_bool(0.03)
            };
            row.push(match (is_free, random.random_bool(slow)) {
                (false, _) => '#',
                (true, false) => '.',
                (true, true) => '~',
            });
            if is_free && is_room {
                rooms[side].push((x, y));
            } else if is_free {
                passage[0].push((x, y));
            }
        }
    }
    let [narrow, wide] = &mut passage;
    wide.clone_from(narrow);
    for room in &rooms {
        wide.extend(room.iter().filter(|_| random.random_bool(0.3)));
    }
    if rooms.iter().any(|room| room.len() < agents) {
        return scene_with_gate(seed.wrapping_add(1), number);
    }
    let agents = agents_of(random, &rooms, &passage[0], agents);
    let mut scene = json!({
        "giveway": 1, "map": rows, "agents": agents, "objective": ["makespan"],
        "rules": { "at_goal": if random.random_bool(0.3) { "vanish" } else { "stay" } },
    });
    let mut rules = Vec::new();
    if random.random_bool(0.5) {
        let cells = passage.choose(random).unwrap();
        scene["zones"] = json!([{ "name": "gate", "cells": cells }]);
        let most = *[1, 1, 2].choose(random).unwrap();
        rules.push(json!({ "kind": "capacity", "zone": "gate", "most": most }));
    }
    if random.random_bool(0.3) {
        rules.push(json!({ "kind": "gap", "steps": random.random_range(1..=2) }));
    }
    if random.random_bool(0.15) {
        rules.push(json!({ "kind": "turns", "quarter": 1 }));
    }
    scene["constraints"] = json!(rules);
    scene
}

/// Agents with a start in one room and mostly a goal in the other.
fn agents_of(
    random: &mut ChaCha8Rng,
    rooms: &[Vec<Spot>; 2],
    passage: &[Spot],
    count: usize,
) -> Vec<Value> {
    let [mut starts, mut goals] = [rooms.clone(), rooms.clone()];
    for cells in starts.iter_mut().chain(&mut goals) {
        cells.shuffle(random);
    }
    let is_one_way = random.random_bool(0.5);
    let mut agents = Vec::new();
    for i in 0..count {
        let side = if is_one_way { 0 } else { i % 2 };
        let other = if random.random_bool(0.9) {
            1 - side
        } else {
            side
        };
        let (Some(start), Some(goal)) = (starts[side].pop(), goals[other].pop()) else {
            continue;
        };
        let mut agent = json!({ "name": format!("A{i}"), "start": start, "goal": goal });
        if random.random_bool(0.2) {
            let cells = [rooms[0].as_slice(), rooms[1].as_slice(), passage];
            agent["waypoints"] = json!(cells.choose(random).unwrap().choose(random));
            if agent["waypoints"].is_null() {
                agent["waypoints"] = json!([]);
            } else {
                agent["waypoints"] = json!([agent["waypoints"]]);
            }
        }
        if random.random_bool(0.1) {
            agent["battery"] = json!({ "capacity": 14, "initial": 14 });
        }
        agents.push(agent);
    }
    agents
}
