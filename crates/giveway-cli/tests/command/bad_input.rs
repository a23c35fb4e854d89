//! Input that is wrong: a clear sentence for each fault, and exit status 1.

use std::fs;

use expect_test::{Expect, expect};

use crate::run::{Folder, WAREHOUSE, two_agents};

/// Solves `scene.json` with these words replaced in it.
fn check(replace: &[(&str, &str)], expect: &Expect) {
    Folder::scene(two_agents(replace)).refuses("solve scene.json", expect);
}

/// Solves `scene.json` with this text.
fn check_text(text: impl AsRef<[u8]>, expect: &Expect) {
    Folder::scene(text).refuses("solve scene.json", expect);
}

#[test]
fn duplicate_starts() {
    check(
        &[("[3, 0]", "[0, 0]")],
        &expect![[r#"
        exit 1
        scene.json: line 7, column 30: agents[1].start: found (0, 0), the start of A1, expected a start of its own
    "#]],
    );
}

#[test]
fn a_goal_in_a_wall() {
    check(
        &[("[0, 1]", "[2, 0]")],
        &expect![[r#"
        exit 1
        scene.json: line 7, column 46: agents[1].goal: found the obstacle (2, 0), expected a free cell
    "#]],
    );
}

#[test]
fn a_waypoint_off_the_map() {
    let waypoint = r#"[0, 1], "waypoints": [[1, 1], [4, 0]]"#;
    check(
        &[("[0, 1]", waypoint)],
        &expect![[r#"
        exit 1
        scene.json: line 7, column 76: agents[1].waypoints[1]: found (4, 0), expected a cell of the 4 x 2 map
    "#]],
    );
}

#[test]
fn an_unknown_key() {
    check(
        &[("\"name\": \"A2\"", "\"nam\": \"A2\"")],
        &expect![[r#"
            exit 1
            scene.json: line 7, column 7: agents[1]: found the unknown key "nam", expected one of name, start, goal, waypoints, battery, heading
        "#]],
    );
}

#[test]
fn a_newer_version() {
    check(
        &[("\"giveway\": 1", "\"giveway\": 2")],
        &expect![[r#"
        exit 1
        scene.json: line 2, column 14: giveway: found version 2 of the format, expected version 1, the only one known here
    "#]],
    );
}

#[test]
fn a_map_row_too_long() {
    check(
        &[("\"....\"", "\".....\"")],
        &expect![[r#"
        exit 1
        scene.json: line 4, column 19: map[1]: found a row of 5 cells, expected 4, as in the first row
    "#]],
    );
}

#[test]
fn an_unknown_map_character() {
    check(
        &[("\"....\"", "\"..@.\"")],
        &expect![[r#"
        exit 1
        scene.json: line 4, column 22: map[1][2]: found "@", expected one of . # ~ + *
    "#]],
    );
}

#[test]
fn bad_words_in_the_objective() {
    check(
        &[("\"map\"", "\"objective\": [\"speed\"], \"map\"")],
        &expect![[r#"
            exit 1
            scene.json: line 4, column 17: objective[0]: found "speed", expected makespan, sum-of-costs, charges, moves, waits or penalty
        "#]],
    );
    check(
        &[("\"map\"", "\"objective\": [\"moves\", \"moves\"], \"map\"")],
        &expect![[r#"
            exit 1
            scene.json: line 4, column 16: objective: found moves twice, expected each cost once
        "#]],
    );
}

#[test]
fn every_fault_has_its_line() {
    check(
        &[
            ("[0, 0]", "[9, 9]"),
            ("[3, 1]", "[2, 0]"),
            ("\"A2\"", "\"A1\""),
        ],
        &expect![[r#"
            exit 1
            scene.json: line 6, column 30: agents[0].start: found (9, 9), expected a cell of the 4 x 2 map
            scene.json: line 6, column 46: agents[0].goal: found the obstacle (2, 0), expected a free cell
            scene.json: line 7, column 15: agents[1].name: found "A1", the name of agents[0], expected a name of its own
        "#]],
    );
}

#[test]
fn more_than_twenty_faults_are_counted() {
    let agents: Vec<String> = (0..30)
        .map(|i| format!(r#"{{ "name": "A{i}", "start": [{i}, 9], "goal": [{i}, 0] }}"#))
        .collect();
    let map = ".".repeat(30);
    let text = format!(
        r#"{{ "giveway": 1, "map": ["{map}"], "agents": [{}] }}"#,
        agents.join(",")
    );
    let run = Folder::scene(text).run("solve scene.json");
    assert_eq!(run.exit, Some(1));
    assert_eq!(run.err.lines().count(), 21);
    assert_eq!(run.err.lines().last(), Some("scene.json: and 10 more"));
}

#[test]
fn an_empty_file() {
    check_text(
        "",
        &expect![[r#"
        exit 1
        scene.json: line 1, column 1: found an empty file, expected a map, a scenario, an instance or a plan of a known format
    "#]],
    );
    check_text(
        " \n\n",
        &expect![[r#"
        exit 1
        scene.json: line 1, column 1: found an empty file, expected a map, a scenario, an instance or a plan of a known format
    "#]],
    );
}

#[test]
fn not_json() {
    check_text(
        "warehouse",
        &expect![[r#"
        exit 1
        scene.json: line 1, column 1: found "warehouse", expected a map, a scenario, an instance or a plan of a known format
    "#]],
    );
    check_text(
        "{ \"giveway\": 1, \"map\": [\"..\"",
        &expect![[r#"
        exit 1
        scene.json: line 1, column 29: found the end of the file inside a list, expected a closing ]
    "#]],
    );
}

#[test]
fn not_utf8() {
    check_text(
        b"{ \"giveway\": 1,\n \"name\": \"\xc3\xa9\xff\" }",
        &expect![[r#"
            exit 1
            scene.json: line 2, column 12: found the byte 0xFF, expected text in UTF-8, UTF-16 or Windows-1252
        "#]],
    );
}

#[test]
fn ten_megabytes_of_noise() {
    // A small generator of its own: the same noise each time.
    let mut state = 1_u64;
    let noise: Vec<u8> = std::iter::repeat_with(|| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 56) as u8
    })
    .take(10 << 20)
    .collect();
    check_text(
        &noise,
        &expect![[r#"
        exit 1
        scene.json: line 1, column 2: found the byte 0x82, expected text in UTF-8, UTF-16 or Windows-1252
    "#]],
    );
    let letters: Vec<u8> = noise.iter().map(|byte| b' ' + byte % 95).collect();
    check_text(
        &letters,
        &expect![[r#"
        exit 1
        scene.json: line 1, column 1: found "-Cf#-AN08R J*q^!-S`T?\M`$+W.XEhdrMK_.O$nYd^{UiOP#N...", expected a map, a scenario, an instance or a plan of a known format
    "#]],
    );
    check_text(
        "[".repeat(10 << 20),
        &expect![[r#"
        exit 1
        scene.json: line 1, column 1: found a list, expected an object
    "#]],
    );
}

#[test]
fn a_missing_file() {
    Folder::scene("").refuses(
        "solve nowhere.json",
        &expect![[r#"
        exit 1
        nowhere.json: found no file of this name, expected a file
    "#]],
    );
    Folder::scene(WAREHOUSE).refuses(
        "check scene.json nowhere.json",
        &expect![[r#"
        exit 1
        nowhere.json: found no file of this name, expected a file
    "#]],
    );
}

#[test]
fn a_folder_instead_of_a_file() {
    let folder = Folder::scene("");
    fs::create_dir(folder.path("maps")).unwrap();
    folder.refuses(
        "solve maps",
        &expect![[r#"
        exit 1
        maps: found a folder, expected a file
    "#]],
    );
}

#[test]
fn a_plan_instead_of_an_instance() {
    let plan = r#"{ "giveway": 1, "paths": {} }"#;
    check_text(
        plan,
        &expect![[r#"
        exit 1
        scene.json: line 1, column 1: found a plan, with "paths", expected an instance, with "map" and "agents"
    "#]],
    );
}

#[test]
fn too_few_agents_for_the_option() {
    Folder::scene(WAREHOUSE).refuses(
        "solve scene.json --agents 3",
        &expect![[r#"
            exit 1
            scene.json: line 9, column 13: agents: found 2 robots, expected 3, as asked with --agents
        "#]],
    );
}

#[test]
fn a_file_whose_name_breaks_lines() {
    let folder = Folder::scene("");
    let output = crate::run::command()
        .args(["solve", "no\nsuch \u{1b}[31m.json"])
        .current_dir(folder.path(""))
        .output()
        .unwrap();
    let run = String::from_utf8(output.stderr).unwrap();
    expect![[r#"
        no\nsuch \u{1b}[31m.json: found no file of this name, expected a file
    "#]]
    .assert_eq(&run);
}
