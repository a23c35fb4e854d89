//! MovingAI scenarios and their maps.

use std::fs;

use expect_test::expect;

use crate::run::{EMPTY_MAP, EMPTY_SCEN, Folder, Run};

fn folder() -> Folder {
    Folder::with(&[
        ("empty-8-8.map", EMPTY_MAP),
        ("few.scen", EMPTY_SCEN),
        ("small.map", "type octile\nheight 1\nwidth 3\nmap\n...\n"),
    ])
}

/// How many agents the scenario becomes, and the notes on the way.
fn agents(run: &Run) -> (usize, &str) {
    assert_eq!(run.exit, Some(0), "{}", run.err);
    let scene: serde_json::Value = serde_json::from_str(&run.out).unwrap();
    (scene["agents"].as_array().unwrap().len(), &run.err)
}

#[test]
fn the_map_is_found_beside_the_scenario() {
    let folder = folder();
    assert_eq!(
        agents(&folder.run("convert few.scen --to giveway")),
        (8, "")
    );
    assert_eq!(
        agents(&folder.run("convert few.scen --to giveway --agents 3")),
        (3, "")
    );
}

#[test]
fn folders_in_the_name_of_the_map_are_left_out() {
    let folder = folder();
    let scen = EMPTY_SCEN.replace("empty-8-8.map", "maps\\standard/empty-8-8.map");
    fs::write(folder.path("few.scen"), scen).unwrap();
    assert_eq!(
        agents(&folder.run("convert few.scen --to giveway")),
        (8, "")
    );
}

#[test]
fn the_map_is_given() {
    let folder = folder();
    fs::rename(folder.path("empty-8-8.map"), folder.path("other.map")).unwrap();
    folder.refuses("solve few.scen", &expect![[r#"
        exit 1
        few.scen: found no map "empty-8-8.map" beside the scenario, expected its map there or with --map
    "#]]);
    let (n, note) = {
        let run = folder.run("convert few.scen --to giveway --map other.map");
        let (n, note) = agents(&run);
        (n, note.to_owned())
    };
    assert_eq!(n, 8);
    expect![[r#"
        note: few.scen is made for the map empty-8-8.map; other.map is used for it
    "#]]
    .assert_eq(&note);
    let quiet = folder.run("convert few.scen --to giveway --map other.map --quiet");
    assert_eq!(agents(&quiet), (8, ""));
}

#[test]
fn a_scenario_on_standard_input_needs_its_map() {
    let folder = folder();
    let run = folder.run_with("convert - --to giveway --map empty-8-8.map", EMPTY_SCEN);
    assert_eq!(agents(&run), (8, ""));
    let run = folder.run_with("solve -", EMPTY_SCEN);
    expect![[r#"
        exit 1
        standard input: found a scenario for the map "empty-8-8.map", expected that map with --map as well
    "#]].assert_eq(&run.refusal());
}

#[test]
fn line_ends_do_not_matter() {
    let folder = folder();
    fs::write(folder.path("few.scen"), EMPTY_SCEN.replace('\n', "\r\n")).unwrap();
    fs::write(
        folder.path("empty-8-8.map"),
        EMPTY_MAP.trim_end().replace('\n', "\r\n"),
    )
    .unwrap();
    assert_eq!(
        agents(&folder.run("convert few.scen --to giveway")),
        (8, "")
    );
}

#[test]
fn a_scenario_for_another_map() {
    folder().refuses(
        "solve few.scen --map small.map",
        &expect![[r#"
        exit 1
        note: few.scen is made for the map empty-8-8.map; small.map is used for it
        few.scen: line 2: found a map of 8 x 8 cells, expected 3 x 1, the size of the map given
    "#]],
    );
}

#[test]
fn more_agents_than_lines() {
    folder().refuses(
        "solve few.scen --agents 9",
        &expect![[r#"
            exit 1
            few.scen: found a scenario for 8 robots, expected one for 9
        "#]],
    );
}

#[test]
fn a_map_alone_is_no_instance() {
    folder().refuses("solve small.map", &expect![[r#"
        exit 1
        small.map: found a map, which has no robots, expected an instance, such as a scenario of this map
    "#]]);
}

#[test]
fn a_scenario_with_a_missing_column() {
    let folder = folder();
    fs::write(
        folder.path("few.scen"),
        "version 1\n0\tempty-8-8.map\t8\t8\t0\t0\n",
    )
    .unwrap();
    folder.refuses("solve few.scen", &expect![[r#"
        exit 1
        few.scen: line 2, column 1: found 6 columns, expected nine columns: bucket, map, width, height, start x, start y, goal x, goal y, length
    "#]]);
}

#[test]
fn the_map_of_a_scenario_has_faults_of_its_own() {
    let folder = folder();
    let map = EMPTY_MAP.replacen("........", ".........", 1);
    fs::write(folder.path("empty-8-8.map"), map).unwrap();
    folder.refuses(
        "solve few.scen",
        &expect![[r#"
        exit 1
        empty-8-8.map: line 5, column 9: found a row of 9 cells, expected 8, the width in the header
    "#]],
    );
}
