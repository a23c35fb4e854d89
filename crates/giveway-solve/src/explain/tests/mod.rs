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
mod helping;
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

/// Two agents that cross, so that one has to make room for the other, and eight that drive a lane each: many
/// agents, of which two decide.
fn crossing_among_lanes() -> (Instance, Plan) {
    let lanes: Vec<String> = (3..11)
        .map(|y| format!(r#"{{ "name": "L{y}", "start": [0, {y}], "goal": [3, {y}] }}"#))
        .collect();
    let map = ["....", "@.@@", "@@@@"].into_iter().chain(["...."; 8]);
    let map: Vec<String> = map
        .map(|row| format!("{row:?}").replace('@', "#"))
        .collect();
    let instance = format!(
        r#"{{ "giveway": 1, "objective": ["sum-of-costs"], "map": [{}], "agents": [
            {{ "name": "a", "start": [0, 0], "goal": [3, 0] }},
            {{ "name": "b", "start": [3, 0], "goal": [0, 0] }}, {}] }}"#,
        map.join(", "),
        lanes.join(", ")
    );
    let lanes = (3..11).map(|y| format!(r#""L{y}": [[0, {y}], [1, {y}], [2, {y}], [3, {y}]]"#));
    let plan = format!(
        r#"{{ "giveway": 1, "paths": {{
            "a": [[0, 0], [1, 0], [1, 1], [1, 0], [2, 0], [3, 0]],
            "b": [[3, 0], [2, 0], [1, 0], [0, 0]], {} }} }}"#,
        lanes.collect::<Vec<_>>().join(", ")
    );
    read(&instance, &plan)
}
