//! What files of others say, and what is lost of them, by the command.

use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::Folder;

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";
const SCENARIO: &str = "version 1\n0\ta.map\t3\t2\t0\t0\t2\t0\t2\n";
const PATHS: &str = "Agent 0: (0,0)->(0,1)->(0,2)->\n";

/// Two robots in a lane of one row: one can pass the other only where it leaves.
const LANE: &str = r#"{ "giveway": 1, "map": ["..."], "agents": [
    { "name": "A1", "start": [1, 0], "goal": [2, 0] }, { "name": "A2", "start": [0, 0], "goal": [1, 0] } ] }"#;

#[test]
fn a_bound_that_is_claimed_and_wrong_is_told() {
    let table = "map_name,agents,lower_cost,solution_cost,solution_plan\na,1,9,2,rr\n";
    let folder = Folder::with(&[("a.map", MAP), ("a.scen", SCENARIO), ("t.csv", table)]);
    let run = folder.run("audit t.csv a.map a.scen --format json -q");
    let told: Value = serde_json::from_str(&run.out).unwrap();
    fits("auditResult", &told);
    assert_eq!(
        told["claimed_bounds"],
        json!([{ "of": "sum-of-costs", "claimed": 9, "proved": 2, "legal": 2, "is_wrong": true }])
    );
    let text = folder.run("audit t.csv a.map a.scen -q").out;
    assert!(
        text.contains("at least 9. That is wrong as it is counted here: a legal plan has 2."),
        "{text}"
    );
    std::fs::write(folder.path("t.csv"), table.replace(",9,", ",1,")).unwrap();
    let text = folder.run("audit t.csv a.map a.scen -q").out;
    assert!(
        text.contains("at least 1; at least 2 is proved here."),
        "{text}"
    );
}

#[test]
fn a_number_that_only_happens_to_fit_is_no_explanation() {
    let result = |soc: u32, steps: &str| format!("agents=1\nsoc={soc}\nsolution=\n{steps}");
    let legal = "0:(0,0),\n1:(1,0),\n2:(2,0),\n";
    let folder = Folder::with(&[
        ("a.map", MAP.to_owned()),
        ("a.scen", SCENARIO.to_owned()),
        ("legal.txt", result(3, legal)),
        ("jump.txt", result(2, "0:(0,0),\n1:(2,0),\n")),
    ]);
    let text = folder.run("audit legal.txt a.map a.scen -q").out;
    assert!(
        text.contains("It would be the number of cells of all paths, starts too."),
        "{text}"
    );
    let text = folder.run("audit jump.txt a.map a.scen -q").out;
    assert!(text.contains("sum of costs is 2; it is 1 here."), "{text}");
    assert!(
        !text.contains("would be") && !text.contains("not known why"),
        "{text}"
    );
}

#[test]
fn where_robots_look_is_lost_and_told() {
    let result = r#"{"actionModel": "MAPF_T", "start": [[0, 0, "E"]], "actualPaths": ["F,F"]}"#;
    let folder = Folder::with(&[("a.map", MAP), ("r.json", result)]);
    for to in ["lorr", "paths.txt", "giveway"] {
        let run = folder.run(&format!("convert r.json a.map --to {to} --output {to}-out"));
        assert_eq!(run.exit, Some(0), "{run:?}");
        assert!(run.err.contains("where 1 robot look"), "{}", run.err);
    }
}

#[test]
fn a_scenario_without_its_version_is_read_by_every_command() {
    let bare = SCENARIO.replace("version 1\n", "");
    let folder = Folder::with(&[("a.map", MAP), ("a.scen", &bare), ("p.txt", PATHS)]);
    for line in [
        "solve a.scen",
        "check a.scen p.txt",
        "audit a.scen a.map p.txt",
        "convert a.scen --to giveway",
    ] {
        let run = folder.run(line);
        assert_eq!(run.exit, Some(0), "{line}: {run:?}");
        let said = run.out + &run.err;
        assert!(said.contains("no line \"version 1\""), "{line}: {said}");
    }
}

#[test]
fn a_plan_of_another_rule_hints_at_it() {
    // A1 leaves the map at its goal; A2 goes through.
    let scene = r#"{ "giveway": 1, "map": ["..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [1, 0] }, { "name": "A2", "start": [2, 0], "goal": [0, 0] } ] }"#;
    let changes = r#"{ "giveway": 1, "changes": [{ "at": 1, "change": "delay-agent", "agent": "A2", "steps": 1 }] }"#;
    let folder = Folder::with(&[("s.json", scene), ("c.json", changes)]);
    let solved = folder.run("solve s.json --at-goal vanish --format json -q");
    std::fs::write(folder.path("r.json"), &solved.out).unwrap();
    let hint = "legal where robots vanish at their goals: --at-goal vanish";
    let checked = folder.run("check s.json r.json");
    assert_eq!(checked.exit, Some(1));
    assert!(checked.out.contains(hint), "{}", checked.out);
    let told: Value =
        serde_json::from_str(&folder.run("check s.json r.json --format json -q").out).unwrap();
    assert!(told["notes"].to_string().contains(hint), "{told}");
    for line in [
        "explain s.json --plan r.json arrival A1",
        "change s.json r.json c.json",
    ] {
        let run = folder.run(line);
        assert_eq!(run.exit, Some(1), "{line}: {run:?}");
        assert!(run.err.contains(hint), "{line}: {}", run.err);
    }
    let legal = folder.run("check s.json r.json --at-goal vanish");
    assert!(!legal.out.contains("judges it so"), "{}", legal.out);
}

#[test]
fn a_plan_below_the_floor_says_which_floor_it_keeps() {
    let scene = r#"{ "giveway": 1, "map": ["..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0], "battery": { "capacity": 9, "initial": 5 } } ] }"#;
    let plan = r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0]] } }"#;
    let changes = r#"{ "giveway": 1, "changes": [{ "at": 1, "change": "delay-agent", "agent": "A1", "steps": 1 }] }"#;
    let folder = Folder::with(&[("s.json", scene), ("p.json", plan), ("c.json", changes)]);
    let run = folder.run("change s.json p.json c.json --floor 5");
    assert_eq!(run.exit, Some(1), "{run:?}");
    let said = "The plan is legal with a battery floor of 3 or less, and the floor is 5 here: --floor 3 judges it so.";
    assert!(run.err.contains(said), "{}", run.err);
}

#[test]
fn an_answer_without_a_plan_is_told_as_such() {
    let folder = Folder::with(&[("s.json", LANE)]);
    let plan = folder.run("solve s.json --format json -q").out;
    std::fs::write(folder.path("p.json"), &plan).unwrap();
    let explained = folder
        .run("explain s.json --plan p.json plan --format json -q")
        .out;
    std::fs::write(folder.path("e.json"), &explained).unwrap();
    let run = folder.run("check s.json e.json");
    assert_eq!(run.exit, Some(1));
    let said = "e.json: line 1, column 1: found the answer to a question, which has no plan, expected a plan, such as the one that was asked about";
    assert!(run.err.contains(said), "{}", run.err);
    std::fs::write(
        folder.path("i.json"),
        r#"{ "giveway": 1, "status": "impossible", "plan": null }"#,
    )
    .unwrap();
    let run = folder.run("check s.json i.json");
    assert!(
        run.err.contains("says that there is no plan (impossible)"),
        "{}",
        run.err
    );
}

#[test]
fn a_line_for_each_plan_finds_its_map_by_its_scenario() {
    let other = "type octile\nheight 1\nwidth 3\nmap\n...\n";
    let folder = Folder::with(&[
        ("a.map", MAP),
        ("b.map", other),
        ("a.scen", SCENARIO),
        ("p.txt", PATHS),
    ]);
    let run = folder.run("audit --jsonl a.map b.map a.scen p.txt");
    let told: Value = serde_json::from_str(&run.out).unwrap();
    assert_eq!(
        (run.exit, &told["legal"]),
        (Some(0), &json!(true)),
        "{told}"
    );
    let run = folder.run("audit --jsonl a.map b.map p.txt");
    let told: Value = serde_json::from_str(&run.out).unwrap();
    let said = "It is open which map p.txt is for: a.map, b.map.";
    assert!(told["error"].as_str().unwrap().starts_with(said), "{told}");
}

#[test]
fn columns_of_a_comparison_have_room_for_violations() {
    let jump = "Agent 0: (0,0)->(0,2)->\n";
    let folder = Folder::with(&[
        ("a.map", MAP),
        ("a.scen", SCENARIO),
        ("p", PATHS),
        ("q", jump),
    ]);
    let text = folder.run("compare a.map a.scen p q").out;
    let line = text.lines().find(|line| line.starts_with("legal")).unwrap();
    let words: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(words, ["legal", "yes", "1", "violation"], "{text}");
}
