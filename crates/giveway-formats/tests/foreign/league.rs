//! Results of the League of Robot Runners: a published one of 2023, and small ones
//! of every year.

use giveway_formats::{Combined, Format, Heading, Refused, recognise, write};
use giveway_model::check::Rule;
use giveway_model::{Cell, Plan};
use serde_json::{Value, json};

use crate::support::{comes_back, data, opened, refused, violations};

fn with_map(result: &Value) -> Combined {
    let map = data("plans/warehouse_small.map");
    let text = result.to_string();
    opened(&[("warehouse_small.map", &map), ("r.json", &text)]).unwrap()
}

fn published() -> Value {
    serde_json::from_str(&data("plans/warehouse_small_2023.lorr.json")).unwrap()
}

#[test]
fn the_published_result_of_2023_is_read_as_it_was_run() {
    let text = data("plans/warehouse_small_2023.lorr.json");
    assert_eq!(recognise(&text), Ok(Format::League));
    let read = with_map(&published());
    assert_eq!(read.instance.agents().len(), 60);
    let plan = &read.plans[0];
    assert!(plan.fit.is_perfect(), "{:?}", plan.fit);
    assert_eq!(plan.claimed.makespan, Some(103));
    assert_eq!(plan.claimed.sum_of_costs, Some(60 * 103));
    // The first robot goes ahead to the east, then turns to the south.
    let path = plan.plan.path("A1");
    assert_eq!(
        &path[..4],
        [(32, 2), (33, 2), (33, 2), (33, 3)].map(|at| Some(Cell::from(at)))
    );
    let looks = &plan.headings["A1"];
    assert_eq!(looks[..3], [Heading::East, Heading::East, Heading::South]);
    // It finished task 0, whose cell is row 22, column 44.
    assert_eq!(read.instance.agents()[0].waypoints, [Cell::new(44, 22)]);
    assert!(plan.notes[0].starts_with("The robots turn"));
    assert!(plan.notes[1].starts_with("The file lists 24 errors of its planner."));
}

/// The result lists what its planner proposed wrongly. Where a proposal is refused,
/// all robots wait, so what they did in fact is legal. Of each proposal the League
/// names the first conflict that it meets; the check here finds the others, too.
#[test]
fn what_the_robots_did_is_legal_and_what_the_planner_proposed_is_not() {
    let result = published();
    let read = with_map(&result);
    assert_eq!(violations(&read.instance, &read.plans[0]), []);

    let letters = |key: &str| -> Vec<Vec<String>> {
        let paths = result[key].as_array().unwrap().iter();
        let split = |path: &Value| {
            path.as_str()
                .unwrap()
                .split(',')
                .map(str::to_owned)
                .collect()
        };
        paths.map(split).collect()
    };
    let (actual, proposed) = (letters("actualPaths"), letters("plannerPaths"));
    let mut conflicts = 0;
    for error in result["errors"].as_array().unwrap() {
        let time = error[2].as_u64().unwrap() as usize;
        if error[3] == "incorrect vector size" {
            // The planner proposed nothing at all: this is no conflict of robots.
            assert!(proposed.iter().all(|path| path[time - 1] == "T"));
            continue;
        }
        assert_eq!(error[3], "vertex conflict");
        conflicts += 1;
        let so_far = actual.iter().zip(&proposed).map(|(did, would)| {
            let mut path = did[..time - 1].to_vec();
            path.push(would[time - 1].clone());
            Value::from(path.join(","))
        });
        let mut until_then = result.clone();
        until_then["actualPaths"] = so_far.collect();
        let read = with_map(&until_then);
        let robot = |i: usize| error[i].as_u64().unwrap() + 1;
        let mut robots = [robot(0), robot(1)];
        robots.sort_unstable();
        let names = robots.map(|robot| format!("A{robot}")).to_vec();
        let found = violations(&read.instance, &read.plans[0]);
        assert!(found.contains(&(Rule::Vertex, time, names)), "{found:?}");
        // What goes before is what the robots did: nothing is wrong there.
        assert!(found.iter().all(|(_, when, _)| *when == time), "{found:?}");
    }
    assert_eq!(conflicts, 11);
}

const ROOM: &str = "type octile\nheight 3\nwidth 4\nmap\n....\n.S.E\n@...\n";

fn in_room(result: &Value) -> Combined {
    let text = result.to_string();
    opened(&[("room.map", ROOM), ("room.json", &text)]).unwrap()
}

fn cells(plan: &Plan, agent: &str) -> Vec<(u32, u32)> {
    let path = plan.path(agent).iter();
    path.map(|cell| (*cell).unwrap().into()).collect()
}

#[test]
fn in_the_action_model_mapf_up_raises_the_row_and_r_goes_right() {
    let read = in_room(&json!({
        "actionModel": "MAPF", "AllValid": "Yes", "teamSize": 2,
        "start": [[0, 1, "N/A"], [2, 3, "N/A"]],
        "actualPaths": ["U,R,W,U", "D,L,D,L"],
        "errors": [], "events": [[], []], "tasks": [],
    }));
    assert!(
        read.plans[0]
            .words
            .contains(&("up".to_owned(), "to the row below (y + 1)".to_owned()))
    );
    let plan = &read.plans[0].plan;
    assert_eq!(cells(plan, "A1"), [(1, 0), (1, 1), (2, 1), (2, 1), (2, 2)]);
    // It meets the first robot at (2, 1), and goes through it from there.
    assert_eq!(cells(plan, "A2"), [(3, 2), (3, 1), (2, 1), (2, 0), (1, 0)]);
    let both = vec!["A1".to_owned(), "A2".to_owned()];
    let found = violations(&read.instance, &read.plans[0]);
    assert_eq!(found, [(Rule::Vertex, 2, both)]);
}

#[test]
fn errands_of_2024_that_are_done_become_waypoints() {
    // Their program writes both letters where a robot looks to the south.
    let text = include_str!("../data/plans/small-league-2024.json");
    let read = in_room(&serde_json::from_str(text).unwrap());
    let agent = &read.instance.agents()[0];
    assert_eq!(agent.waypoints, [Cell::new(1, 1), Cell::new(3, 1)]);
    assert_eq!(agent.goal, Some(Cell::new(3, 1)));
    let plan = &read.plans[0];
    assert_eq!(
        cells(&plan.plan, "A1"),
        [(1, 0), (1, 1), (1, 1), (2, 1), (3, 1)]
    );
    assert_eq!(plan.headings["A1"][2], Heading::East);
    assert_eq!(violations(&read.instance, plan), []);
}

#[test]
fn ticks_of_2026_are_steps_and_a_wait_interrupts_a_move() {
    let text = include_str!("../data/plans/small-league-2026.json");
    let read = in_room(&serde_json::from_str(text).unwrap());
    let plan = &read.plans[0];
    let path = cells(&plan.plan, "A1");
    assert_eq!(path.len(), 12);
    assert_eq!(path.iter().filter(|at| **at == (0, 0)).count(), 4);
    assert_eq!(path.iter().filter(|at| **at == (1, 0)).count(), 7);
    assert_eq!(path[11], (1, 1));
    assert_eq!(plan.headings["A1"][6..8], [Heading::East, Heading::South]);
}

#[test]
fn a_plan_is_written_as_a_result_of_2024_and_comes_back() {
    let read = with_map(&published());
    let written = comes_back(Format::League, &read);
    assert_eq!(written.losses, ["the objective"]);
    let result: Value = serde_json::from_str(&written.files[1].1).unwrap();
    assert_eq!(result["version"], "2024 LoRR");
    assert_eq!(result["actionModel"], "MAPF_T");
    assert_eq!(result["AllValid"], "Yes");
    assert_eq!(
        result["numTaskFinished"],
        result["events"].as_array().unwrap().len()
    );

    let alone = write(Format::League, "it", Some(&read.instance), None).unwrap_err();
    assert_eq!(alone.found, "an instance");
}

#[test]
fn faults_have_their_place_and_keys() {
    let text = |start: &str, path: &str, rest: &str| {
        format!(
            "{{\n\"actionModel\": \"MAPF_T\",\n\"start\": [{start}],\n\"actualPaths\": [\"{path}\"]{rest}\n}}"
        )
    };
    let cases = [
        (
            text("[0, 0, \"E\"]", "F,X", ""),
            "line 4, column 20: actualPaths[0][2]: found \"X\", expected one of F R C W T",
        ),
        (
            text("[0, 0, \"E\"]", "FF", ""),
            "line 4, column 19: actualPaths[0][1]: found \"F\", expected a comma",
        ),
        (
            text("[0, 0, \"N/A\"]", "F", ""),
            "line 3, column 11: start[0]: found the heading \"N/A\", expected E, S, W or N",
        ),
        (
            text("[0, 3000000000, \"E\"]", "F", ""),
            "line 3, column 15: start[0][1]: found the number 3000000000, expected a whole number from -2147483648 to 2147483647",
        ),
        (
            text("", "F", ""),
            "line 4, column 16: actualPaths: found 1 path, expected 0, one for each start",
        ),
        (
            text("[0, 0, \"E\"]", "[(0,0,0,0,0):(F 2000000000)]", ""),
            "line 4, column 17: actualPaths[0]: found a plan of over 24000000 steps, expected at most 24000000 steps of all robots",
        ),
        (
            text("[0, 0, \"E\"]", "[(0,0,0,0,0):(F 2)][(3,", ""),
            "line 4, column 39: actualPaths[0][21]: found \"3\", expected 2, the next tick",
        ),
        (
            text("[0, 0, \"E\"]", "F", ", \"tasks\": [[1, 2]]"),
            "line 4, column 33: tasks[0]: found a task written in another way, expected [id, row, column] or [id, release, [row, column, ..]]",
        ),
        (
            text("[0, 0, \"E\"]", "F", ", \"events\": [[1, 9, 0, 1]]"),
            "line 4, column 38: events[0][1]: found robot 9, expected one of the 1 robots, from 0",
        ),
    ];
    for (text, said) in cases {
        assert_eq!(refused(&text).to_string(), said, "{text}");
    }
}

#[test]
fn an_errand_or_a_start_in_an_obstacle_has_its_place() {
    let result = |column: u32, tasks: &str| {
        format!(
            "{{\"actionModel\": \"MAPF\",\n\"start\": [[0, 0], [0, {column}]],\n\"actualPaths\": [\"R\", \"W\"],\n\
             \"events\": [[1, 0, 7, 1], [1, 0, 8, 2]],\n\"tasks\": [[7, 0, [0, 1]],\n{tasks}]}}"
        )
    };
    let cases = [
        (
            result(2, "[8, 0, [0, 1, 2, 0]]"),
            "line 6, column 1: tasks[1]: found the obstacle (0, 2), expected a free cell",
        ),
        (
            result(2, "[8, 0, [0, 1, 9, 1]]"),
            "line 6, column 1: tasks[1]: found (1, 9), expected a cell of the 4 x 3 map",
        ),
        (
            result(9, "[8, 0, [0, 1]]"),
            "line 2, column 19: start[1]: found (9, 0), expected a cell of the 4 x 3 map",
        ),
    ];
    for (text, said) in cases {
        match opened(&[("room.map", ROOM), ("room.json", &text)]) {
            Err(Refused::File { file, faults }) => {
                assert_eq!(file, "room.json");
                assert_eq!(faults[0].to_string(), said, "{text}");
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn without_its_map_a_result_asks_for_it() {
    let text = published().to_string();
    let error = opened(&[("a.json", &text)]).unwrap_err();
    assert!(format!("{error:?}").contains(
        "a.json does not name its map: open the map (.map) that the plan was made for, too."
    ));
}
