//! Reasons, judged by other means than those that found them.

mod ask;
mod breakdowns;
mod contrast;
mod few_states;
mod fewest;
mod further;
mod growing;
mod half_way;
mod handed_on;
mod how;
mod late;
mod layers;
mod left;
mod lone_walks;
mod losses;
mod own_plan;
mod reach;
mod repairs;
mod rest;
mod rule_waits;
mod still_open;
mod unsolvable;
mod waits;
mod words;

use giveway_model::{Instance, Plan, format::native};

/// An instance and a plan as they are written in files.
fn read(instance: &str, plan: &str) -> (Instance, Plan) {
    let instance = native::read_instance(instance).unwrap();
    (instance, native::read_plan(plan).unwrap())
}

/// Scenario 1 of Bogatarkan (2021), and its two optimal plans.
fn scenario_1() -> (Instance, Plan, Plan) {
    let instance = r#"{ "giveway": 1, "map": ["..#.", "....", "...."], "agents": [
        { "name": "A1", "start": [2, 2], "goal": [0, 1], "waypoints": [[2, 1]] },
        { "name": "A2", "start": [3, 1], "goal": [1, 0], "waypoints": [[2, 1]] }] }"#;
    let first = r#"{ "giveway": 1, "paths": {
        "A1": [[2, 2], [2, 1], [1, 1], [0, 1]],
        "A2": [[3, 1], [3, 1], [2, 1], [1, 1], [1, 0]] } }"#;
    let second = r#"{ "giveway": 1, "paths": {
        "A1": [[2, 2], [2, 2], [2, 1], [1, 1], [0, 1]],
        "A2": [[3, 1], [2, 1], [1, 1], [1, 0]] } }"#;
    let (instance, first) = read(instance, first);
    let second = native::read_plan(second).unwrap();
    (instance, first, second)
}
