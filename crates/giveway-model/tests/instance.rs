//! Every fault that a scene may have.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use giveway_model::format::native;
use giveway_model::{Instance, MAX_AGENTS, MAX_SIDE, Scene};

/// Checks a scene of a map, its rows set apart by blanks, and of agents in JSON;
/// compares the faults.
#[track_caller]
fn check(map: &str, agents: &[&str], expected: &[&str]) {
    check_scene(scene(map, agents), expected);
}

#[track_caller]
fn check_scene(scene: Scene, expected: &[&str]) {
    let found: Vec<String> = match Instance::new(scene) {
        Ok(_) => Vec::new(),
        Err(faults) => faults.iter().map(ToString::to_string).collect(),
    };
    assert_eq!(found, expected);
}

fn scene(map: &str, agents: &[&str]) -> Scene {
    let map: Vec<&str> = map.split_whitespace().collect();
    let map = serde_json::to_string(&map).unwrap();
    let agents = agents.join(",");
    native::read_scene(&format!(
        "{{\"giveway\": 1, \"map\": {map}, \"agents\": [{agents}]}}"
    ))
    .unwrap()
}

const A: &str = r#"{ "name": "A", "start": [0, 0], "goal": [1, 0] }"#;

#[test]
fn no_agents_are_fine() {
    check(".", &[], &[]);
}

#[test]
fn an_agent_that_is_at_its_goal_is_fine() {
    check(
        ".",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [0, 0] }"#],
        &[],
    );
}

#[test]
fn a_map_without_rows() {
    check(
        "",
        &[],
        &["map: found no rows, expected at least one row of cells"],
    );
}

#[test]
fn a_map_of_empty_rows() {
    let scene = Scene {
        map: vec![String::new(), String::new()],
        ..Scene::default()
    };
    check_scene(
        scene,
        &["map[0]: found an empty row, expected at least one cell"],
    );
}

#[test]
fn a_row_of_another_length() {
    check(
        ".. ...",
        &[],
        &["map[1]: found a row of 3 cells, expected 2, as in the first row"],
    );
    check(
        ".. .. .",
        &[],
        &["map[2]: found a row of 1 cells, expected 2, as in the first row"],
    );
}

#[test]
fn a_character_that_no_map_has() {
    check(
        ".. .x",
        &[],
        &["map[1][1]: found \"x\", expected one of . # ~ + *"],
    );
}

#[test]
fn an_empty_name() {
    check(
        "..",
        &[r#"{ "name": "", "start": [0, 0], "goal": [1, 0] }"#],
        &["agents[0].name: found an empty name, expected a name"],
    );
}

#[test]
fn a_name_used_twice() {
    check(
        ".. ..",
        &[A, r#"{ "name": "A", "start": [0, 1], "goal": [1, 1] }"#],
        &["agents[1].name: found \"A\", the name of agents[0], expected a name of its own"],
    );
}

#[test]
fn off_the_map() {
    check(
        ".. ..",
        &[r#"{ "name": "A", "start": [2, 0], "goal": [0, 2], "waypoints": [[4294967295, 0]] }"#],
        &[
            "agents[0].start: found (2, 0), expected a cell of the 2 x 2 map",
            "agents[0].goal: found (0, 2), expected a cell of the 2 x 2 map",
            "agents[0].waypoints[0]: found (4294967295, 0), expected a cell of the 2 x 2 map",
        ],
    );
}

#[test]
fn in_an_obstacle() {
    check(
        "#. ..",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [0, 0], "waypoints": [[1, 0], [0, 0]] }"#],
        &[
            "agents[0].start: found the obstacle (0, 0), expected a free cell",
            "agents[0].goal: found the obstacle (0, 0), expected a free cell",
            "agents[0].waypoints[1]: found the obstacle (0, 0), expected a free cell",
        ],
    );
}

#[test]
fn chargers_and_the_slow_zone_are_no_obstacles() {
    check(
        "+~*",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [1, 0], "waypoints": [[2, 0]] }"#],
        &[],
    );
}

#[test]
fn a_waypoint_listed_twice() {
    check(
        "..",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [0, 0], "waypoints": [[1, 0], [1, 0]] }"#],
        &["agents[0].waypoints[1]: found (1, 0) again, expected each waypoint once"],
    );
}

#[test]
fn a_start_or_goal_may_be_a_waypoint() {
    check(
        "..",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [1, 0], "waypoints": [[1, 0], [0, 0]] }"#],
        &[],
    );
}

#[test]
fn a_start_that_two_agents_share() {
    check(
        ".. ..",
        &[A, r#"{ "name": "B", "start": [0, 0], "goal": [1, 1] }"#],
        &["agents[1].start: found (0, 0), the start of A, expected a start of its own"],
    );
}

#[test]
fn a_goal_that_two_agents_share_where_agents_stay() {
    let b = r#"{ "name": "B", "start": [0, 1], "goal": [1, 0] }"#;
    check(
        ".. ..",
        &[A, b],
        &["agents[1].goal: found (1, 0), the goal of A, \
             expected a goal of its own, since robots stay at their goals"],
    );
    let mut scene = scene(".. ..", &[A, b]);
    scene.rules.at_goal = giveway_model::AtGoal::Vanish;
    check_scene(scene, &[]);
}

#[test]
fn a_battery_above_its_capacity() {
    check(
        "..",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [1, 0],
               "battery": { "capacity": 3, "initial": 4 } }"#],
        &["agents[0].battery.initial: found 4, expected at most the capacity, 3"],
    );
}

#[test]
fn a_battery_that_begins_below_the_floor_is_no_fault_of_the_input() {
    let mut scene = scene(
        "..",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [1, 0],
               "battery": { "capacity": 0, "initial": 0 } }"#],
    );
    scene.rules.battery_floor = 5;
    check_scene(scene, &[]);
}

#[test]
fn beyond_the_limits() {
    let side = MAX_SIDE as usize + 1;
    let wide = Scene {
        map: vec![".".repeat(side)],
        ..Scene::default()
    };
    check_scene(
        wide,
        &["map: found a map of 2049 x 1 cells, expected at most 2048 x 2048"],
    );
    let agent = scene(
        ".",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [0, 0] }"#],
    )
    .agents;
    let crowded = Scene {
        map: vec![".".into()],
        agents: agent.into_iter().cycle().take(MAX_AGENTS + 1).collect(),
        ..Scene::default()
    };
    check_scene(
        crowded,
        &["agents: found 10001 robots, expected at most 10000"],
    );
    check(
        "..",
        &[r#"{ "name": "A", "start": [0, 0], "goal": [1, 0],
               "battery": { "capacity": 1000001, "initial": 0 } }"#],
        &["agents[0].battery.capacity: found 1000001, expected at most 1000000"],
    );
}

#[test]
fn a_scene_comes_back_as_it_was() {
    let scene = scene("+. ~*", &[A]);
    let instance = Instance::new(scene.clone()).unwrap();
    assert_eq!(instance.to_scene(), scene);
}
