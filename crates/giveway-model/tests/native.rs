//! The project's own JSON: what is read, what is refused and with which words.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

use giveway_model::format::native::{
    read_instance, read_plan, read_scene, write_plan, write_scene,
};
use giveway_model::format::read_text;
use giveway_model::{AtGoal, Cell, Cost, Fault, Objective};

/// An instance of five lines, in which one part is replaced by another.
fn spoilt(part: &str, by: &str) -> String {
    const GOOD: &str = r##"{
  "giveway": 1,
  "map": ["..", "#."],
  "agents": [
    { "name": "A", "start": [0, 0], "goal": [1, 1], "waypoints": [[1, 0]], "battery": { "capacity": 3, "initial": 3 } }
  ]
}"##;
    assert!(GOOD.contains(part));
    GOOD.replacen(part, by, 1)
}

/// The one fault of an instance, as a person reads it.
#[track_caller]
fn check(text: &str, expected: &str) {
    let faults = read_instance(text).unwrap_err();
    let [fault] = faults.as_slice() else {
        panic!("{faults:?}");
    };
    assert_eq!(fault.to_string(), expected);
}

#[track_caller]
fn check_plan(text: &str, expected: &str) {
    assert_eq!(read_plan(text).unwrap_err().to_string(), expected);
}

#[test]
fn the_defaults_are_filled_in() {
    let instance = read_instance(&spoilt("3", "3")).unwrap();
    assert_eq!(instance.name(), "");
    assert_eq!(instance.rules().at_goal, AtGoal::Stay);
    assert_eq!(instance.rules().battery_floor, 0);
    assert_eq!(*instance.objective(), Objective::default());
}

#[test]
fn the_sample_of_the_format_is_read() {
    let scene = read_scene(
        r#"{
  "giveway": 1,
  "name": "warehouse",
  "map": ["..~~~~~~..",
          ".##.##.##.",
          "...+..+..."],
  "rules": { "at_goal": "vanish", "battery_floor": 2 },
  "objective": ["moves", "sum-of-costs"],
  "agents": [
    { "name": "A1", "start": [0, 0], "goal": [9, 2], "waypoints": [[2, 0], [4, 2]],
      "battery": { "capacity": 10, "initial": 10 } }
  ]
}"#,
    )
    .unwrap();
    assert_eq!(scene.rules.at_goal, AtGoal::Vanish);
    assert_eq!(scene.objective.costs(), [Cost::Moves, Cost::SumOfCosts]);
    assert_eq!(scene.agents[0].waypoints[1], Cell::new(4, 2));
}

#[test]
fn carriage_returns_and_a_byte_order_mark_are_fine() {
    let text = spoilt("3", "3").replace('\n', "\r\n");
    let marked = format!("\u{feff}{text}\r\n");
    assert_eq!(read_instance(&marked), read_instance(&spoilt("3", "3")));
    check(
        &marked.replace("\"goal\"", "\"gaol\""),
        "line 5, column 37: agents[0]: found the unknown key \"gaol\", \
         expected one of name, start, goal, waypoints, battery, heading",
    );
}

#[test]
fn an_empty_file() {
    for text in ["", " \r\n ", "\u{feff}"] {
        check(
            text,
            "line 1, column 1: found an empty file, expected a JSON object",
        );
    }
}

#[test]
fn noise_is_refused_in_a_short_sentence() {
    let noise = "noise ".repeat(2_000_000);
    check(
        &noise,
        "line 1, column 1: found \"n\", expected a JSON object",
    );
    let text = spoilt("\"A\"", &format!("\"A\", \"{noise}\": 3"));
    assert!(read_instance(&text).unwrap_err()[0].to_string().len() < 250);
    let text = spoilt("[0, 0]", &format!("\"{noise}\""));
    assert!(read_instance(&text).unwrap_err()[0].to_string().len() < 250);
}

#[test]
fn what_is_no_json() {
    check(
        "{",
        "line 1, column 2: found the end of the file inside an object, expected a closing }",
    );
    check(
        &spoilt("\"agents\"", "agents"),
        "line 4, column 3: found \"a\", expected a key in double quotes",
    );
    check(
        &spoilt("\"#.\"],", "\"#.\"]"),
        "line 4, column 3: found a double quote, expected a comma or a closing }",
    );
    check(
        &spoilt("}\n  ]", "},\n  ]"),
        "line 6, column 3: found a comma after the last entry, expected no comma there",
    );
    check(
        &spoilt("\"A\"", "\"A"),
        "line 5, column 20: found \"s\", expected a comma or a closing }",
    );
    check(
        &spoilt("  ]\n}", "  ]\n}\nmore"),
        "line 8, column 1: found \"m\", expected the end of the file",
    );
}

#[test]
fn a_newer_version_is_refused_by_name() {
    check(
        &spoilt("\"giveway\": 1", "\"speed\": 2, \"giveway\": 7"),
        "line 2, column 26: giveway: found version 7 of the format, \
         expected version 1, the only one known here",
    );
}

#[test]
fn a_file_without_a_version() {
    check(
        &spoilt("\"giveway\": 1,", ""),
        "line 1, column 1: found no key \"giveway\", expected one here",
    );
}

#[test]
fn unknown_keys_are_refused_with_their_place() {
    check(
        &spoilt("\"map\"", "\"mapp\""),
        "line 3, column 3: found the unknown key \"mapp\", \
         expected one of giveway, name, map, rules, objective, agents, assumptions, zones, constraints, units",
    );
    check(
        &spoilt("\"initial\"", "\"level\": 3, \"initial\""),
        "line 5, column 104: agents[0].battery: found the unknown key \"level\", \
         expected capacity or initial",
    );
}

#[test]
fn repeated_keys_are_refused() {
    check(
        &spoilt(
            "\"map\": [\"..\", \"#.\"],",
            "\"map\": [\"..\"], \"map\": [\"..\"],",
        ),
        "line 3, column 18: found the key \"map\" again, expected each key once",
    );
}

#[test]
fn values_of_another_type() {
    check(
        &spoilt("[0, 0]", "[0, -1]"),
        "line 5, column 33: agents[0].start[1]: found the number -1, \
         expected a whole number from 0 to 4294967295",
    );
    check(
        &spoilt("[0, 0]", "[0, 0, 0]"),
        "line 5, column 29: agents[0].start: found a list of 3, expected a cell [x, y]",
    );
    check(
        &spoilt("[0, 0]", "[0]"),
        "line 5, column 29: agents[0].start: found a list of one, expected a cell [x, y]",
    );
    check(
        &spoilt("\"A\"", "1.5"),
        "line 5, column 15: agents[0].name: found the number 1.5, expected a text in double quotes",
    );
    check(
        &spoilt("[\"..\", \"#.\"]", "\"..#.\""),
        "line 3, column 10: map: found the text \"..#.\", expected a list",
    );
}

#[test]
fn a_list_is_no_object() {
    check(
        &spoilt("{ \"capacity\": 3, \"initial\": 3 }", "[3, 3]"),
        "line 5, column 87: agents[0].battery: found a list, \
         expected an object with capacity and initial",
    );
    check("[1]", "line 1, column 1: found a list, expected an object");
}

#[test]
fn rules_and_objectives_by_name_only() {
    let with = |more: &str| spoilt("\"map\"", &format!("{more},\n  \"map\""));
    check(
        &with("\"rules\": { \"at_goal\": \"sleep\" }"),
        "line 3, column 25: rules.at_goal: found \"sleep\", expected stay or vanish",
    );
    check(
        &with("\"rules\": { \"at_goal\": { \"stay\": null } }"),
        "line 3, column 25: rules.at_goal: found an object, expected a text in double quotes",
    );
    check(
        &with("\"objective\": [\"speed\"]"),
        "line 3, column 17: objective[0]: found \"speed\", \
         expected makespan, sum-of-costs, charges, moves, waits or penalty",
    );
    check(
        &with("\"objective\": [\"moves\", \"moves\"]"),
        "line 3, column 16: objective: found moves twice, expected each cost once",
    );
    check(
        &with("\"objective\": []"),
        "line 3, column 16: objective: found no cost, expected at least one",
    );
}

#[test]
fn faults_of_the_problem_have_their_line_and_column() {
    check(
        &spoilt("[1, 1]", "[0, 1]"),
        "line 5, column 45: agents[0].goal: found the obstacle (0, 1), expected a free cell",
    );
    check(
        &spoilt("\"#.\"", "\"#x\""),
        "line 3, column 19: map[1][1]: found \"x\", expected one of . # ~ + *",
    );
    check(
        &spoilt("[[1, 0]]", "[[1, 0], [1, 0]]"),
        "line 5, column 75: agents[0].waypoints[1]: found (1, 0) again, \
         expected each waypoint once",
    );
    check(
        &spoilt("\"initial\": 3", "\"initial\": 4"),
        "line 5, column 115: agents[0].battery.initial: found 4, \
         expected at most the capacity, 3",
    );
}

#[test]
fn columns_count_characters() {
    check(
        &spoilt("\"A\"", "\"\u{e4}\u{1f916}\", \"x\": 1"),
        "line 5, column 21: agents[0]: found the unknown key \"x\", \
         expected one of name, start, goal, waypoints, battery, heading",
    );
}

#[test]
fn another_kind_of_file_is_named() {
    check(
        "{ \"giveway\": 1, \"paths\": {} }",
        "line 1, column 1: found a plan, with \"paths\", \
         expected an instance, with \"map\" and \"agents\"",
    );
    check_plan(
        &spoilt("3", "3"),
        "line 1, column 1: found an instance, with \"map\" and \"agents\", \
         expected a plan, with \"paths\"",
    );
}

#[test]
fn two_paths_of_one_agent() {
    check_plan(
        "{ \"giveway\": 1, \"paths\": { \"A\": [[0,0]],\n \"A\": [[1,0]] } }",
        "line 2, column 2: paths: found \"A\" twice, expected each robot once",
    );
    check_plan(
        "{ \"giveway\": 1, \"paths\": {}, \"charges\": { \"A\": [], \"A\": [1] } }",
        "line 1, column 52: charges: found \"A\" twice, expected each robot once",
    );
}

#[test]
fn entries_of_a_path_that_are_no_cells() {
    check_plan(
        "{ \"giveway\": 1, \"paths\": { \"A 1\": [[0,0], 7] } }",
        "line 1, column 43: paths[\"A 1\"][1]: found the number 7, expected a cell [x, y]",
    );
}

#[test]
fn bytes_that_are_no_text() {
    let fault = read_text(b"{\n \"\xc3\xa9\xff\": 3}").unwrap_err();
    assert_eq!(
        fault.to_string(),
        "line 2, column 4: found the byte 0xFF, expected text in UTF-8, UTF-16 or Windows-1252"
    );
    assert_eq!(read_text(b"\xef\xbb\xbf{}"), Ok("{}".into()));
}

#[test]
fn a_scene_is_written_for_people() {
    let text = r##"{
  "giveway": 1,
  "name": "a \"b\", c: {d}",
  "map": ["..~",
          "#.*"],
  "rules": { "at_goal": "vanish", "battery_floor": 1 },
  "objective": ["moves", "waits"],
  "agents": [
    { "name": "A1, {x}", "start": [0, 0], "goal": [2, 0] },
    { "name": "A2", "start": [1, 0], "goal": [2, 1], "waypoints": [[1, 1], [2, 0]], "battery": { "capacity": 9, "initial": 8 } }
  ]
}
"##;
    assert_eq!(
        read_scene(text).map(|scene| write_scene(&scene)).as_deref(),
        Ok(text)
    );
}

#[test]
fn a_plan_is_written_for_people() {
    let text = r#"{
  "giveway": 1,
  "paths": {
    "A1": [[0, 0], [1, 0], null, [2, 0]],
    "B, {2}": [[0, 1]]
  },
  "charges": {
    "A1": [1, 3]
  },
  "from": {
    "A1": 2
  }
}
"#;
    assert_eq!(
        read_plan(text).map(|plan| write_plan(&plan)).as_deref(),
        Ok(text)
    );
    let empty = "{\n  \"giveway\": 1,\n  \"paths\": {},\n  \"charges\": {}\n}\n";
    assert_eq!(
        read_plan(empty).map(|plan| write_plan(&plan)).as_deref(),
        Ok(empty)
    );
}

#[test]
fn many_faults_are_located_fast() {
    let agent = r#"{ "name": "A", "start": [9, 9], "goal": [0, 0] }"#;
    let agents = vec![agent; 4000].join(",");
    let text = format!("{{ \"giveway\": 1, \"map\": [\"..\"], \"agents\": [{agents}] }}");
    let faults = read_instance(&text).unwrap_err();
    assert!(faults.len() > 8000);
    assert!(faults.iter().all(|fault: &Fault| fault.line == Some(1)));
}
