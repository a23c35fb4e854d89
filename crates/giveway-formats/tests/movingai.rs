//! The standard benchmark's maps and scenarios.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use giveway_formats::Part;
use giveway_formats::movingai::{
    losses, read_map, read_scenario, to_scene, write_map, write_scenario,
};
use giveway_model::format::native::read_instance;
use giveway_model::{Cell, Fault, Grid, Instance};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n.G@\nOTW\n";
const SCENARIO: &str = "version 1\n\
    0\tm.map\t3\t2\t0\t0\t1\t0\t1.0\n\
    0\tm.map\t3\t2\t1\t0\t0\t0\t1.0\n\
    0\tm.map\t3\t2\t0\t0\t0\t0\t0\n";

macro_rules! published {
    ($name:literal, $scenario:literal) => {
        (
            include_str!(concat!("data/movingai/", $name, ".map")),
            include_str!(concat!("data/movingai/", $name, "-", $scenario, ".scen")),
        )
    };
}

#[track_caller]
fn check_map(text: &str, expected: &str) {
    assert_eq!(message(read_map(text)), expected);
}

#[track_caller]
fn check_scenario(text: &str, expected: &str) {
    assert_eq!(message(read_scenario(text)), expected);
}

/// The fault of the first agents of a scenario on the map above.
#[track_caller]
fn check_scene(scenario: &str, agents: Option<usize>, expected: &str) {
    let grid = read_map(MAP).unwrap();
    let scenario = read_scenario(scenario).unwrap();
    assert_eq!(message(to_scene("m", &grid, &scenario, agents)), expected);
}

fn message<T: std::fmt::Debug>(result: Result<T, Fault>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn the_height_comes_first_in_a_map() {
    assert_eq!(read_map(MAP).unwrap().rows(), ["..#", "###"]);
}

#[test]
fn carriage_returns_and_a_missing_last_newline_are_fine() {
    let crlf = MAP.replace('\n', "\r\n");
    assert_eq!(read_map(&crlf), read_map(MAP));
    assert_eq!(read_map(MAP.trim_end()), read_map(MAP));
    assert_eq!(read_map(&format!("{MAP}\n\n")), read_map(MAP));
    let crlf = SCENARIO.replace('\n', "\r\n");
    assert_eq!(read_scenario(&crlf), read_scenario(SCENARIO));
    assert_eq!(read_scenario(SCENARIO.trim_end()), read_scenario(SCENARIO));
}

#[test]
fn a_map_that_is_none() {
    let header = "a header of type, height, width and map";
    check_map(
        "",
        &format!("line 1, column 1: found the end of the file, expected {header}"),
    );
    check_map(
        "type octile\nheight 2\nmap\n",
        "line 3, column 1: found no line \"width\" in the header, expected \"width\" and a number",
    );
    check_map(
        "noise",
        "line 1, column 1: found \"noise\", expected type, height, width or map",
    );
    check_map(
        &MAP.replace("octile", "hex"),
        "line 1, column 6: found \"hex\", expected octile",
    );
    check_map(
        &MAP.replace("height 2", "height"),
        "line 2, column 7: found the end of the line, expected a whole number from 1 to 2048",
    );
    check_map(
        &MAP.replace("width 3", "width 3000"),
        "line 3, column 7: found \"3000\", expected a whole number from 1 to 2048",
    );
}

#[test]
fn rows_that_are_not_as_the_header_says() {
    check_map(
        &MAP.replace(".G@", ".G@."),
        "line 5, column 4: found a row of 4 cells, expected 3, the width in the header",
    );
    check_map(
        &MAP.replace("OTW", "OT"),
        "line 6, column 3: found a row of 2 cells, expected 3, the width in the header",
    );
    check_map(
        &MAP.replace("OTW\n", ""),
        "line 5, column 1: found 1 rows, expected 2, the height in the header",
    );
    check_map(
        &format!("{MAP}...\n"),
        "line 7, column 1: found \"...\", expected no row after the 2 of the header",
    );
    check_map(
        &MAP.replace(".G@", ".X@"),
        "line 5, column 2: found \"X\", expected one of . G S E @ O T W",
    );
}

#[test]
fn the_width_comes_first_in_a_scenario() {
    let scenario = read_scenario(SCENARIO).unwrap();
    assert_eq!(scenario.map_name(), Some("m.map"));
    let route = &scenario.routes[1];
    assert_eq!((route.line, route.width, route.height), (3, 3, 2));
    assert_eq!(
        (route.start, route.goal),
        (Cell::new(1, 0), Cell::new(0, 0))
    );
}

#[test]
fn versions_and_columns_as_they_are_found() {
    for version in ["version 1.0", "version 1 ", "version  1.00"] {
        let text = SCENARIO.replace("version 1", version);
        assert_eq!(read_scenario(&text), read_scenario(SCENARIO));
    }
    let blanks = SCENARIO.replace('\t', "  ");
    assert_eq!(read_scenario(&blanks), read_scenario(SCENARIO));
    let named = SCENARIO.replace("m.map", "my map.map");
    assert_eq!(
        read_scenario(&named).unwrap().map_name(),
        Some("my map.map")
    );
    assert_eq!(read_scenario("version 1").unwrap().routes, []);
}

#[test]
fn a_scenario_that_is_none() {
    check_scenario(
        "",
        "line 1, column 1: found an empty file, expected \"version 1\" and a line for each robot",
    );
    check_scenario(
        "version 2\n",
        "line 1, column 1: found \"version 2\", expected \"version 1\"",
    );
    let columns = "nine columns: bucket, map, width, height, \
        start x, start y, goal x, goal y, length";
    check_scenario(
        "version 1\n0\tm.map\t3\n",
        &format!("line 2, column 1: found 3 columns, expected {columns}"),
    );
    check_scenario(
        "version 1\n0\tm.map\t3\t2\t0\tone\t1\t0\t1.0\n",
        "line 2, column 15: found \"one\", expected a whole number from 0",
    );
    check_scenario(
        "version 1\n0\tm.map\t3\t2\t0\t0\t1\t0\tlong\n",
        "line 2, column 21: found \"long\", expected a length",
    );
}

#[test]
fn agents_are_the_first_lines_in_order() {
    let grid = read_map(MAP).unwrap();
    let scenario = read_scenario(SCENARIO).unwrap();
    let scene = to_scene("m", &grid, &scenario, Some(2)).unwrap();
    let names: Vec<&str> = scene.agents.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names, ["A1", "A2"]);
    assert_eq!(scene.name, "m");
    assert!(Instance::new(scene).is_ok());
    let nobody = to_scene("m", &grid, &scenario, Some(0)).unwrap();
    assert_eq!(nobody.agents, []);
}

#[test]
fn a_cell_shared_by_lines_matters_only_among_the_agents_taken() {
    check_scene(
        SCENARIO,
        None,
        "line 4: found the start (0, 0), which is that of line 2 too, expected a start of its own",
    );
}

#[test]
fn more_agents_than_lines() {
    check_scene(
        SCENARIO,
        Some(4),
        "found a scenario for 3 robots, expected one for 4",
    );
}

#[test]
fn a_scenario_for_another_map() {
    check_scene(
        "version 1\n0\tm.map\t2\t3\t0\t0\t1\t0\t1\n",
        None,
        "line 2: found a map of 2 x 3 cells, expected 3 x 2, the size of the map given",
    );
    check_scene(
        "version 1\n0\tm.map\t3\t2\t0\t0\t1\t0\t1\n0\tn.map\t3\t2\t1\t0\t0\t0\t1\n",
        None,
        "line 3: found the map \"n.map\", expected \"m.map\", as in the first line",
    );
}

#[test]
fn a_start_or_goal_where_nobody_can_be() {
    check_scene(
        "version 1\n0\tm.map\t3\t2\t2\t0\t1\t0\t1\n",
        None,
        "line 2: found the start (2, 0) in an obstacle, expected a free cell",
    );
    check_scene(
        "version 1\n0\tm.map\t3\t2\t0\t0\t3\t0\t1\n",
        None,
        "line 2: found the goal (3, 0), expected a cell of the 3 x 2 map",
    );
}

#[test]
fn published_files_come_back_from_what_is_written() {
    for (map, scenario) in [
        published!("empty-8-8", "random-1"),
        published!("random-32-32-20", "random-1"),
        published!("warehouse-10-20-10-2-1", "random-1"),
    ] {
        let grid = read_map(map).unwrap();
        assert_eq!(read_map(&write_map(&grid)).as_ref(), Ok(&grid));
        let scenario = read_scenario(scenario).unwrap();
        let name = scenario.map_name().unwrap();
        let scene = to_scene("x", &grid, &scenario, None).unwrap();
        let instance = Instance::new(scene.clone()).unwrap();
        assert_eq!(instance.agents().len(), scenario.routes.len());
        assert_eq!(losses(&instance), []);
        let written = read_scenario(&write_scenario(name, &instance).unwrap()).unwrap();
        assert_eq!(to_scene("x", &grid, &written, None), Ok(scene));
    }
}

#[test]
fn maps_may_be_wider_than_high() {
    let (map, _) = published!("warehouse-10-20-10-2-1", "random-1");
    let grid = read_map(map).unwrap();
    assert_eq!((grid.width(), grid.height()), (161, 63));
}

#[test]
fn what_is_lost_is_told() {
    let instance = read_instance(
        r#"{ "giveway": 1, "map": ["~*.", "+.."], "rules": { "at_goal": "vanish" },
             "objective": ["moves"],
             "agents": [
               { "name": "A1", "start": [0, 0], "goal": [1, 1], "waypoints": [[2, 0]] },
               { "name": "B", "start": [0, 1], "goal": [1, 1],
                 "battery": { "capacity": 1, "initial": 1 } } ] }"#,
    )
    .unwrap();
    let lost = losses(&instance);
    let counts: Vec<(Part, usize)> = lost.iter().map(|it| (it.part, it.count)).collect();
    assert_eq!(
        counts,
        [
            (Part::SlowZone, 2),
            (Part::Chargers, 2),
            (Part::Waypoints, 1),
            (Part::Batteries, 1),
            (Part::Vanish, 1),
            (Part::Objective, 1),
            (Part::Names, 1),
        ]
    );
    assert_eq!(lost[0].to_string(), "the slow zone (2 cells)");
    assert_eq!(lost[3].to_string(), "the batteries of 1 robot");
}

#[test]
fn a_map_name_that_no_reader_could_tell_is_refused() {
    let grid = Grid::from_rows(&["."]).unwrap();
    let scene = to_scene("", &grid, &read_scenario("version 1").unwrap(), None).unwrap();
    let instance = Instance::new(scene).unwrap();
    assert!(write_scenario("a\tb", &instance).is_err());
    assert!(write_scenario("", &instance).is_err());
    assert_eq!(
        write_scenario("a b", &instance).as_deref(),
        Ok("version 1\n")
    );
}
