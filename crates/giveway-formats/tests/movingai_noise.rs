//! Readers of maps and scenarios never panic on noise, and read back what writers write.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use giveway_formats::movingai::{read_map, read_scenario, to_scene, write_map, write_scenario};
use giveway_model::{Agent, Cell, Grid, Instance, Scene};
use proptest::prelude::*;

use texts::assert_short;

#[path = "../../giveway-model/tests/noise/texts.rs"]
mod texts;

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n.G@\nOTW\n";
const SCENARIO: &str =
    "version 1\n0\tm.map\t3\t2\t0\t0\t1\t0\t1.0\n0\tm.map\t3\t2\t1\t0\t0\t0\t1.0\n";

const FILES: [&str; 2] = [MAP, SCENARIO];

/// Gives a text to both readers, and what they read to what makes a scene of it.
fn read_all(text: &str) {
    let grid = read_map(text).unwrap_or_else(|fault| {
        assert_short(&fault);
        read_map(MAP).unwrap()
    });
    match read_scenario(text) {
        Ok(scenario) => drop(to_scene("n", &grid, &scenario, None)),
        Err(fault) => assert_short(&fault),
    }
}

/// A map row of free cells and obstacles.
fn row_of(width: usize) -> impl Strategy<Value = String> {
    let cells = prop::collection::vec(prop::sample::select(vec!['.', '#']), width);
    cells.prop_map(|cells| cells.into_iter().collect())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn maps_and_scenarios_come_back_from_what_is_written(
        rows in (1_usize..6).prop_flat_map(|n| prop::collection::vec(row_of(n), 1..6)),
        picks in prop::collection::vec(any::<(prop::sample::Index, prop::sample::Index)>(), 0..5),
    ) {
        let grid = Grid::from_rows(&rows).unwrap();
        prop_assert_eq!(read_map(&write_map(&grid)), Ok(grid.clone()));
        let mut free: Vec<Cell> = grid.cells().filter(|(_, g)| g.is_vertex()).map(|(c, _)| c).collect();
        let mut goals = free.clone();
        let mut scene = Scene { name: "m".into(), map: rows, ..Scene::default() };
        for (start, goal) in picks {
            if free.is_empty() {
                break;
            }
            scene.agents.push(Agent {
                name: format!("A{}", scene.agents.len() + 1),
                start: free.remove(start.index(free.len())),
                goal: Some(goals.remove(goal.index(goals.len()))),
                waypoints: Vec::new(),
                battery: None,
                heading: None,
            });
        }
        let instance = Instance::new(scene.clone()).unwrap();
        let text = write_scenario("m.map", &instance).unwrap();
        let scenario = read_scenario(&text).unwrap();
        prop_assert_eq!(to_scene("m", &grid, &scenario, None), Ok(scene));
    }
}
