//! Random changes of scenes with rules of their own, as JSON.

use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use super::{Spot, scene_with_rules};
use crate::random::numbers;

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
