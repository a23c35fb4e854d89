//! Readers of maps and scenarios never panic on noise, and read back what writers write.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use giveway_formats::movingai::{read_map, read_scenario, to_scene, write_map, write_scenario};
use giveway_model::format::read_text;
use giveway_model::{Agent, Cell, Fault, Grid, Instance, Scene};
use proptest::prelude::*;

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n.G@\nOTW\n";
const SCENARIO: &str =
    "version 1\n0\tm.map\t3\t2\t0\t0\t1\t0\t1.0\n0\tm.map\t3\t2\t1\t0\t0\t0\t1.0\n";

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

/// A fault is a sentence, however long the input.
fn assert_short(fault: &Fault) {
    let text = fault.to_string();
    assert!(text.chars().count() < 400, "{text}");
    assert!(!text.contains(['\n', '\r']), "{text}");
}

fn valid_file() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![MAP, SCENARIO])
}

/// A map row of free cells and obstacles.
fn row_of(width: usize) -> impl Strategy<Value = String> {
    let cells = prop::collection::vec(prop::sample::select(vec!['.', '#']), width);
    cells.prop_map(|cells| cells.into_iter().collect())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bytes_are_read_without_a_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        match read_text(&bytes) {
            Ok(text) => read_all(&text),
            Err(fault) => assert_short(&fault),
        }
    }

    #[test]
    fn text_is_read_without_a_panic(text in "\\PC*|[\\[\\]{}:,\"a-z0-9 \\n]*") {
        read_all(&text);
    }

    #[test]
    fn truncated_files_are_read_without_a_panic(file in valid_file(), at in any::<prop::sample::Index>()) {
        read_all(&file[..at.index(file.len() + 1)]);
    }

    #[test]
    fn mutated_files_are_read_without_a_panic(
        file in valid_file(),
        places in prop::collection::vec((any::<prop::sample::Index>(), any::<char>()), 1..4),
        part in any::<(prop::sample::Index, prop::sample::Index)>(),
    ) {
        let mut letters: Vec<char> = file.chars().collect();
        for (place, letter) in places {
            *place.get_mut(&mut letters) = letter;
        }
        read_all(&letters.iter().collect::<String>());
        // A part of the file, put once more somewhere else.
        let (from, to) = (part.0.index(letters.len()), part.1.index(letters.len()));
        let copy = letters[from.min(to)..from.max(to)].to_vec();
        let again: String = letters[..to].iter().chain(&copy).chain(&letters[to..]).collect();
        read_all(&again);
    }

    #[test]
    fn digits_may_change_without_a_panic(file in valid_file(), number in any::<u64>(), digit in "[0-9]") {
        read_all(&file.replace(&digit, &number.to_string()));
    }

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
            });
        }
        let instance = Instance::new(scene.clone()).unwrap();
        let text = write_scenario("m.map", &instance).unwrap();
        let scenario = read_scenario(&text).unwrap();
        prop_assert_eq!(to_scene("m", &grid, &scenario, None), Ok(scene));
    }
}
