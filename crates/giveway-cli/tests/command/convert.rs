//! `giveway convert`.

use std::fs;

use expect_test::expect;

use crate::run::{EMPTY_MAP, EMPTY_SCEN, Folder, WAREHOUSE, WAREHOUSE_PLAN};

fn folder() -> Folder {
    Folder::with(&[
        ("warehouse.json", WAREHOUSE),
        ("plan.json", WAREHOUSE_PLAN),
        ("empty-8-8.map", EMPTY_MAP),
        ("few.scen", EMPTY_SCEN),
    ])
}

#[test]
fn a_scenario_becomes_an_instance() {
    let run = folder().run("convert few.scen --to giveway --agents 2");
    expect![[r#"
        {
          "giveway": 1,
          "name": "few",
          "map": ["........",
                  "........",
                  "........",
                  "........",
                  "........",
                  "........",
                  "........",
                  "........"],
          "agents": [
            { "name": "A1", "start": [0, 0], "goal": [1, 0] },
            { "name": "A2", "start": [5, 3], "goal": [5, 6] }
          ]
        }
    "#]]
    .assert_eq(run.answer());
}

#[test]
fn there_and_back() {
    let folder = folder();
    let first = folder.run("convert few.scen --to giveway");
    fs::write(folder.path("few.json"), first.answer()).unwrap();
    assert_eq!(
        folder.run("convert few.json --to movingai -o out").answer(),
        ""
    );
    assert_eq!(
        folder.run("convert out/few.scen --to giveway").answer(),
        first.out
    );
}

#[test]
fn what_is_lost_is_said() {
    let folder = folder();
    let run = folder.run("convert warehouse.json --to movingai -o out");
    expect![[r#"
        exit 0
        warehouse.json: warning: MovingAI files cannot hold the slow zone (6 cells), the chargers (2 cells), the waypoints of 2 robots, the batteries of 2 robots
    "#]].assert_eq(&run.refusal());
    expect![[r#"
        type octile
        height 3
        width 10
        map
        ..........
        .@@.@@.@@.
        ..........
    "#]]
    .assert_eq(&folder.read("out/warehouse.map"));
    expect![[r#"
        version 1
        0|warehouse.map|10|3|0|0|9|2|0
        0|warehouse.map|10|3|9|2|0|0|0
    "#]]
    .assert_eq(&folder.read("out/warehouse.scen").replace('\t', "|"));
}

#[test]
fn plans_are_written_anew_or_refused() {
    let folder = folder();
    let run = folder.run("convert plan.json --to giveway");
    let lines: Vec<&str> = run.answer().lines().take(3).collect();
    expect![[r#"
        {
          "giveway": 1,
          "paths": {"#]]
    .assert_eq(&lines.join("\n"));
    folder.refuses(
        "convert plan.json --to movingai -o out",
        &expect![[r#"
        exit 1
        plan.json: found a plan, expected an instance, since MovingAI files hold no plans
    "#]],
    );
    assert!(!folder.path("out").exists());
}

#[test]
fn a_map_among_the_files_serves_its_scenario() {
    let folder = folder();
    fs::create_dir(folder.path("maps")).unwrap();
    fs::rename(
        folder.path("empty-8-8.map"),
        folder.path("maps/empty-8-8.map"),
    )
    .unwrap();
    let run = folder.run("convert few.scen maps/empty-8-8.map --to giveway -o out");
    assert_eq!(run.answer(), "");
    let written: Vec<_> = fs::read_dir(folder.path("out")).unwrap().collect();
    assert_eq!(written.len(), 1);
    assert!(folder.read("out/few.json").contains("\"A8\""));
}

#[test]
fn a_map_alone_becomes_an_instance_without_agents() {
    let run = folder().run("convert empty-8-8.map --to giveway");
    assert!(run.answer().contains("\"agents\": []"), "{}", run.out);
}

#[test]
fn several_files_need_a_folder() {
    folder().refuses(
        "convert few.scen --to movingai",
        &expect![[r#"
        exit 2
        error: found 2 files to write, expected a folder for them with --output DIR

        Usage: giveway [OPTIONS] <COMMAND>

        For more information, try '--help'.
    "#]],
    );
}

#[test]
fn what_was_read_is_never_overwritten() {
    let folder = folder();
    folder.refuses(
        "convert warehouse.json --to giveway -o .",
        &expect![[r#"
            exit 2
            error: ./warehouse.json is an input file and would be overwritten, expected another folder for --output

            Usage: giveway [OPTIONS] <COMMAND>

            For more information, try '--help'.
        "#]],
    );
    folder.refuses(
        "convert few.scen --to movingai -o out/..",
        &expect![[r#"
            exit 2
            error: out/../few.scen is an input file and would be overwritten, expected another folder for --output

            Usage: giveway [OPTIONS] <COMMAND>

            For more information, try '--help'.
        "#]],
    );
    assert_eq!(folder.read("warehouse.json"), WAREHOUSE);
    assert_eq!(folder.read("few.scen"), EMPTY_SCEN);
}

#[test]
fn two_files_of_one_name_are_not_mixed_up() {
    let folder = folder();
    fs::create_dir(folder.path("other")).unwrap();
    fs::write(folder.path("other/warehouse.json"), WAREHOUSE).unwrap();
    folder.refuses(
        "convert warehouse.json other/warehouse.json --to giveway -o out",
        &expect![[r#"
            exit 2
            error: found two files to be written to out/warehouse.json, expected names that differ

            Usage: giveway [OPTIONS] <COMMAND>

            For more information, try '--help'.
        "#]],
    );
    assert!(!folder.path("out").exists());
}

#[test]
fn nothing_is_left_beside_the_files() {
    let folder = folder();
    folder
        .run("convert warehouse.json few.scen --to giveway -o out")
        .answer();
    let mut names: Vec<_> = fs::read_dir(folder.path("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["few.json", "warehouse.json"]);
}

#[cfg(unix)]
#[test]
fn a_written_file_is_as_open_as_any() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder();
    folder.run("convert few.scen --to giveway -o out").answer();
    let mode = |name: &str| {
        fs::metadata(folder.path(name))
            .unwrap()
            .permissions()
            .mode()
    };
    assert_eq!(mode("out/few.json"), mode("few.scen"));
}
