//! Every problem, in its sentence and on its cell.

use giveway_model::{Agent, AtGoal, Battery, Cell, Scene};

use crate::{Draft, sample};

/// A scene of agents from start to goal by way of waypoints.
fn scene(rows: &[&str], agents: &[&[(u32, u32)]]) -> Scene {
    let agent = |(index, cells): (usize, &&[(u32, u32)])| Agent {
        name: format!("A{}", index + 1),
        start: cells[0].into(),
        goal: Some(cells[1].into()),
        waypoints: cells[2..].iter().map(|&cell| cell.into()).collect(),
        battery: None,
        heading: None,
    };
    Scene {
        map: rows.iter().map(|&row| row.to_owned()).collect(),
        agents: agents.iter().enumerate().map(agent).collect(),
        ..Scene::default()
    }
}

fn told(scene: Scene) -> Vec<(Option<Cell>, String)> {
    let draft = Draft::new(scene).unwrap();
    let problems = draft.problems().iter();
    problems.map(|p| (p.cell, p.sentence())).collect()
}

fn sentences(scene: Scene) -> Vec<String> {
    told(scene)
        .into_iter()
        .map(|(_, sentence)| sentence)
        .collect()
}

#[test]
fn a_sound_scene_has_none() {
    assert_eq!(told(sample::draft().scene().clone()), []);
    assert_eq!(told(scene(&["..#"], &[&[(0, 0), (0, 0)]])), []);
}

#[test]
fn cells_that_cannot_be_stood_on() {
    let scene = scene(&["#.", ".#"], &[&[(0, 0), (1, 1), (5, 0)]]);
    assert_eq!(
        told(scene),
        [
            (
                Some(Cell::new(0, 0)),
                "The start of A1 is on an obstacle, at (0, 0).".to_owned()
            ),
            (
                Some(Cell::new(1, 1)),
                "The goal of A1 is on an obstacle, at (1, 1).".to_owned()
            ),
            (
                Some(Cell::new(5, 0)),
                "The waypoint of A1 is off the map, at (5, 0).".to_owned()
            ),
        ]
    );
}

#[test]
fn what_two_agents_share() {
    let mut shared = scene(&["..."], &[&[(0, 0), (2, 0)], &[(0, 0), (2, 0)]]);
    assert_eq!(
        sentences(shared.clone()),
        [
            "A1 and A2 both start at (0, 0).",
            "A1 and A2 both end at (2, 0), where only one can stay."
        ]
    );
    shared.rules.at_goal = AtGoal::Vanish;
    shared.agents[1].start = Cell::new(1, 0);
    assert_eq!(told(shared.clone()), []);
    shared.agents[1].name = "A1".to_owned();
    assert_eq!(sentences(shared), ["Two robots are called A1."]);
}

#[test]
fn the_smaller_part_is_walled_in() {
    let map = [".#..", "##..", "...."];
    let walled = scene(&map, &[&[(0, 0), (3, 2)]]);
    let expect = "A1 is walled in at (0, 0): no way leads to its goal (3, 2).";
    assert_eq!(told(walled), [(Some(Cell::new(0, 0)), expect.to_owned())]);
    let far = scene(&map, &[&[(3, 2), (2, 2), (0, 0)]]);
    let expect = "A1 cannot reach its waypoint (0, 0): every way is closed.";
    assert_eq!(told(far), [(Some(Cell::new(0, 0)), expect.to_owned())]);
}

fn with_battery(mut scene: Scene, capacity: u32, initial: u32) -> Vec<String> {
    scene.agents[0].battery = Some(Battery { capacity, initial });
    sentences(scene)
}

#[test]
fn a_battery_that_does_not_last() {
    let straight = || scene(&["....."], &[&[(0, 0), (4, 0)]]);
    assert_eq!(with_battery(straight(), 4, 4), [""; 0]);
    let short = "The battery of A1 does not last to its goal (4, 0).";
    assert_eq!(with_battery(straight(), 4, 3), [short]);
    let mut floor = straight();
    floor.rules.battery_floor = 1;
    assert_eq!(with_battery(floor, 4, 4), [short]);
}

#[test]
fn a_charge_takes_no_time() {
    let charger = || scene(&["..+..."], &[&[(0, 0), (5, 0)]]);
    // Full after the step that leaves the charger.
    assert_eq!(with_battery(charger(), 2, 2), [""; 0]);
    assert_eq!(with_battery(charger(), 2, 1).len(), 1);
    let farther = scene(&["..+...."], &[&[(0, 0), (6, 0)]]);
    assert_eq!(with_battery(farther, 2, 2).len(), 1);
}

#[test]
fn slow_moves_take_two() {
    let slow = || scene(&[".~~."], &[&[(0, 0), (3, 0)]]);
    assert_eq!(with_battery(slow(), 4, 4), [""; 0]);
    assert_eq!(with_battery(slow(), 4, 3).len(), 1);
    let charged = scene(&["*~."], &[&[(0, 0), (2, 0)]]);
    // The slow move ends with one less than full.
    assert_eq!(with_battery(charged, 2, 0), [""; 0]);
}

#[test]
fn a_waypoint_from_which_there_is_no_way_on() {
    let detour = || scene(&["...", "#.#", "#.#"], &[&[(0, 0), (2, 0), (1, 2)]]);
    assert_eq!(with_battery(detour(), 6, 6), [""; 0]);
    let expect = "The battery of A1 lasts to its waypoint (1, 2), but not on to its goal.";
    assert_eq!(with_battery(detour(), 6, 5), [expect]);
    let dead = "The battery of A1 does not last to its waypoint (1, 2).";
    assert_eq!(with_battery(detour(), 6, 2), [dead]);
}

#[test]
fn what_only_validation_knows_is_told_as_it_is() {
    let mut twice = scene(&[".."], &[&[(0, 0), (1, 0), (1, 0)]]);
    twice.agents[0].waypoints.push(Cell::new(1, 0));
    let told = told(twice);
    assert_eq!(told.len(), 1);
    assert!(told[0].1.contains("each waypoint once"), "{told:?}");
}

#[test]
fn many_batteries_on_a_large_map_are_left_to_the_solver() {
    let row = ".".repeat(256);
    let rows = vec![row.as_str(); 256];
    let mut large = scene(&rows, &[&[(0, 0), (255, 255)]]);
    large.agents[0].battery = Some(Battery {
        capacity: 509,
        initial: 509,
    });
    assert_eq!(told(large), []);
}
