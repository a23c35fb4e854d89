//! Tables of small plans.

use expect_test::{Expect, expect};
use giveway_model::{Agent, Battery, Cell, Scene};

use super::*;

fn agent(name: &str, start: [u32; 2], goal: [u32; 2], battery: Option<Battery>) -> Agent {
    Agent {
        name: name.to_owned(),
        start: Cell::new(start[0], start[1]),
        goal: Some(Cell::new(goal[0], goal[1])),
        waypoints: Vec::new(),
        battery,
        heading: None,
    }
}

fn check(map: &[&str], agents: Vec<Agent>, plan: &str, columns: usize, expect: &Expect) {
    let scene = Scene {
        map: map.iter().map(|&row| row.to_owned()).collect(),
        agents,
        ..Scene::default()
    };
    let plan = serde_json::from_str(plan).unwrap();
    expect.assert_eq(&draw(&Instance::new(scene).unwrap(), &plan, columns));
}

const PLAN: &str = r#"{ "giveway": 1,
    "paths": { "A1": [[0,0],[1,0],null,[2,0],[3,0]], "A2": [[0,1],[1,1],[1,1]] },
    "charges": { "A1": [1] } }"#;

fn agents() -> Vec<Agent> {
    let battery = Battery {
        capacity: 10,
        initial: 3,
    };
    vec![
        agent("A1", [0, 0], [3, 0], Some(battery)),
        agent("A2", [0, 1], [1, 1], None),
    ]
}

const MAP: [&str; 2] = [".*~.", "...."];

#[test]
fn cells_levels_charges_and_transit() {
    check(
        &MAP,
        agents(),
        PLAN,
        100,
        &expect![[r#"
        time      0    1    2    3    4
        A1      0,0  1,0   ..  2,0  3,0
          level   3    2*  10    9    8
        A2      0,1  1,1
          .. in transit on a slow move, * charges
    "#]],
    );
}

#[test]
fn a_narrow_terminal_gets_blocks() {
    check(
        &MAP,
        agents(),
        PLAN,
        22,
        &expect![[r#"
            time      0    1    2
            A1      0,0  1,0   ..
              level   3    2*  10
            A2      0,1  1,1

            time      3    4
            A1      2,0  3,0
              level   9    8
              .. in transit on a slow move, * charges
        "#]],
    );
}

#[test]
fn a_plan_without_paths_has_no_table() {
    let plan = r#"{ "giveway": 1, "paths": {} }"#;
    check(&MAP, agents(), plan, 100, &expect![[r#""#]]);
}

#[test]
fn many_agents_get_a_summary() {
    let row = ".".repeat(41);
    let agents = (0..41)
        .map(|i| agent(&format!("A{i}"), [i, 0], [i, 0], None))
        .collect();
    let plan = r#"{ "giveway": 1, "paths": { "A0": [[0,0]] } }"#;
    let scene = Scene {
        map: vec![row],
        agents,
        ..Scene::default()
    };
    let plan = serde_json::from_str(plan).unwrap();
    let text = draw(&Instance::new(scene).unwrap(), &plan, 100);
    let lines: Vec<&str> = text.lines().take(3).collect();
    expect![[r#"
        [
            "robot                  start        goal  arrival  charges",
            "A0                    (0, 0)      (0, 0)        0        0",
            "A1                    (1, 0)      (1, 0)     none        0",
        ]
    "#]]
    .assert_debug_eq(&lines);
    assert!(text.contains("--format json"));
}
