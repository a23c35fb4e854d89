//! `giveway sizing`: how many robots a floor bears.

use serde_json::Value;

use crate::audit::fits;
use crate::run::Folder;

const FLOOR: &str = r#"{ "giveway": 1, "name": "floor",
  "map": ["..........", "..####.##.", ".+........", "..####.##.", ".........."],
  "agents": [{ "name": "old", "start": [5, 2], "goal": [5, 0] }],
  "zones": [{ "name": "middle", "rect": [2, 2, 8, 2] }],
  "constraints": [{ "kind": "capacity", "zone": "middle", "most": 2 },
                  { "kind": "depart", "agents": ["old"], "from": 3 }] }"#;

const DRAWN: &str = "--starts 0,0..0,4 --goals 9,0..9,4 --back --waypoints 1 --battery 40/20";

fn folder() -> Folder {
    let more = FLOOR.replace(".+........", ".+......+.");
    let bare = r#"{ "giveway": 1, "map": ["..."], "agents": [] }"#;
    Folder::with(&[
        ("floor.json", FLOOR),
        ("more.json", more.as_str()),
        ("bare.json", bare),
    ])
}

fn json(line: &str) -> Value {
    let run = folder().run(&format!("sizing {line} --format json"));
    assert_eq!(run.err, "");
    let answer = serde_json::from_str(&run.out).unwrap();
    fits("sizingResult", &answer);
    answer
}

#[test]
fn robots_are_drawn_onto_the_floor() {
    let answer = json(&format!(
        "floor.json --robots 2..6/2 {DRAWN} --beside more.json"
    ));
    let points = answer["points"].as_array().unwrap();
    let robots: Vec<u64> = points
        .iter()
        .map(|it| it["robots"].as_u64().unwrap())
        .collect();
    assert_eq!(robots, [2, 4, 6]);
    assert_eq!(answer["beside"].as_array().unwrap().len(), 3);
    // The first robots are the same in every plan.
    let starts = |place: usize| {
        let paths = points[place]["plan"]["paths"].as_object().unwrap();
        let first = |name: &str| paths[name][0].clone();
        [first("A1"), first("A2")]
    };
    assert_eq!(starts(0), starts(2));
    let note = answer["notes"].to_string();
    assert!(
        note.contains("name a robot of the instance do not count: 1"),
        "{note}"
    );
}

#[test]
fn each_point_is_what_solve_says() {
    let answer = json("floor.json --robots 1");
    let run = folder().run("solve floor.json --format json");
    let solved: Value = serde_json::from_str(&run.out).unwrap();
    let point = &answer["points"][0];
    for key in ["status", "costs", "plan", "bounds", "complete", "within"] {
        assert_eq!(point[key], solved[key], "{key}");
    }
}

#[test]
fn robots_that_were_drawn_are_solved_by_themselves() {
    let folder = folder();
    let line = format!("sizing floor.json --robots 2..6/2 {DRAWN} --save drawn.json --format json");
    let answer: Value = serde_json::from_str(folder.run(&line).answer()).unwrap();
    for point in answer["points"].as_array().unwrap() {
        let line = format!(
            "solve drawn.json --agents {} --format json",
            point["robots"]
        );
        let solved: Value = serde_json::from_str(folder.run(&line).answer()).unwrap();
        assert_eq!(solved["status"], "optimal");
        for key in ["status", "costs", "plan", "complete", "within"] {
            assert_eq!(point[key], solved[key], "{key} of {}", point["robots"]);
        }
    }
    let run = folder.run("sizing floor.json --robots 1 --save drawn.json");
    assert!(run.err.contains("--starts"), "{}", run.err);
}

#[test]
fn it_is_a_table_for_people_and_for_spreadsheets() {
    let line = format!("sizing floor.json --robots 2..6/2 {DRAWN} --beside more.json");
    let text = folder().run(&line).answer().to_owned();
    for said in [
        "How many robots?",
        "proved",
        "the other floor",
        "robots are late by",
    ] {
        assert!(text.to_lowercase().contains(&said.to_lowercase()), "{text}");
    }
    let run = folder().run(&format!("{line} --csv"));
    let lines: Vec<&str> = run.out.lines().collect();
    assert_eq!(lines.len(), 7, "{}", run.out);
    assert!(lines[1].starts_with("2,this floor,proved,"), "{}", lines[1]);
    assert!(lines[2].starts_with("2,beside,proved,"), "{}", lines[2]);
    let head = "\u{feff}Robots,Floor,Known,Last arrival,Sum of costs,Charges,\"Sum, at least\",\
                \"Sum, each alone\",Mean delay";
    assert_eq!(lines[0], head);
    assert!(lines[1..].iter().all(|line| line.split(',').count() == 9));
}

#[test]
fn bad_numbers_and_cells_are_refused() {
    for (line, said) in [
        ("floor.json --robots 8..2", "the first not above the last"),
        ("floor.json --robots 0..4", "numbers from 1"),
        ("floor.json --robots 1..4/0", "numbers from 1"),
        ("floor.json --robots 2", "from 1 to 1"),
        ("bare.json --robots 1", "from 1 to 0"),
        ("floor.json --robots 2 --starts 0,0..0,4", "--goals"),
        (
            "floor.json --robots 2 --starts here --goals 9,0",
            "two cells",
        ),
        (
            "floor.json --robots 2 --starts 0,0..0,4 --goals 9,0..9,4 --battery 10/20",
            "a level up to it",
        ),
    ] {
        let run = folder().run(&format!("sizing {line}"));
        assert_ne!(run.exit, Some(0), "{line}");
        assert!(run.err.contains(said), "{line}: {}", run.err);
    }
}
