//! Files of other makers: how they were read is part of every answer, and what a scene leaves
//! out weakens what is claimed.

use std::path::PathBuf;

use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::{Folder, Run};

/// A folder with files of the tests' data.
fn folder(names: &[&str]) -> Folder {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/command/data/foreign");
    let files: Vec<(&str, Vec<u8>)> = names
        .iter()
        .map(|name| (*name, std::fs::read(data.join(name)).unwrap()))
        .collect();
    Folder::with(&files)
}

fn answer(run: &Run, definition: &str) -> Value {
    let value: Value = serde_json::from_str(&run.out).unwrap();
    fits(definition, &value);
    value
}

/// The notes of an answer, in one text.
fn notes(answer: &Value) -> String {
    let notes = answer["notes"].as_array().cloned().unwrap_or_default();
    let notes: Vec<&str> = notes.iter().filter_map(Value::as_str).collect();
    notes.join("\n")
}

#[test]
fn robots_of_a_schedule_are_matched_by_name() {
    let folder = folder(&[
        "named.yaml",
        "named-out.yaml",
        "named-missing.yaml",
        "named-other.yaml",
    ]);
    let run = folder.run("audit named.yaml named-out.yaml --format json -q");
    let told = answer(&run, "auditResult");
    assert_eq!((run.exit, &told["status"]), (Some(0), &json!("optimal")));
    assert_eq!(told["costs"]["sum-of-costs"], 2);
    // The cost beside the schedule is a claim, too, and explained.
    assert_eq!(told["claims"][0]["claimed"], 4);
    assert_eq!(told["claims"][0]["definition"], "cells");
    // Who is missing is named, by every door.
    for line in [
        "audit named.yaml named-missing.yaml",
        "check named.yaml named-missing.yaml",
    ] {
        let text = folder.run(&format!("{line} -q"));
        assert_eq!(text.exit, Some(1));
        assert!(
            text.out.contains("named-missing.yaml has no path for a."),
            "{}",
            text.out
        );
        let told: Value =
            serde_json::from_str(&folder.run(&format!("{line} --format json")).out).unwrap();
        assert!(notes(&told).contains("has no path for a"), "{told}");
    }
    // Where no name fits, the order counts, and that is said.
    let lines = [
        ("audit named.yaml named-other.yaml", "auditResult"),
        ("check named.yaml named-other.yaml", "checkResult"),
        (
            "compare named.yaml named-other.yaml named-out.yaml",
            "compareResult",
        ),
    ];
    for (line, definition) in lines {
        let run = folder.run(&format!("{line} --format json -q"));
        assert_eq!(run.exit, Some(0), "{run:?}");
        let told = answer(&run, definition);
        assert!(
            notes(&told).contains("by their order, not by their names: r1 = a and r2 = b"),
            "{told}"
        );
        let text = folder.run(&format!("{line} -q"));
        assert!(text.out.contains("r1 = a and r2 = b"), "{}", text.out);
    }
}

#[test]
fn a_moving_obstacle_is_heeded_by_search_and_judge() {
    let folder = folder(&["forklift.yaml", "forklift-evaded.yaml", "forklift-met.yaml"]);
    let solved = answer(
        &folder.run("solve forklift.yaml --format json -q"),
        "solveResult",
    );
    assert_eq!(
        (&solved["status"], &solved["costs"]["makespan"]),
        (&json!("optimal"), &json!(8))
    );
    assert_eq!(solved["assumptions"][0]["name"], "forklift");
    assert!(notes(&solved).contains("forklift"));
    let evaded = folder.run("audit forklift.yaml forklift-evaded.yaml --format json");
    let told = answer(&evaded, "auditResult");
    assert_eq!((evaded.exit, &told["status"]), (Some(0), &json!("optimal")));
    assert_eq!(told["bounds"]["sum-of-costs"], 8);
    for command in ["audit", "check"] {
        let met = folder.run(&format!(
            "{command} forklift.yaml forklift-met.yaml --format json"
        ));
        let told: Value = serde_json::from_str(&met.out).unwrap();
        let first = &told["violations"][0];
        assert_eq!((met.exit, &first["time"]), (Some(1), &json!(3)));
        assert_eq!(
            (&first["rule"], &first["name"]),
            (&json!("constraint"), &json!("forklift 4"))
        );
    }
    let checked = folder.run("check forklift.yaml forklift-evaded.yaml --format json -q");
    assert_eq!(checked.exit, Some(0));
    assert!(notes(&answer(&checked, "checkResult")).contains("forklift"));
    // Best plans are told with it, and why they are so.
    let free = folder.run("freedom forklift.yaml");
    assert_eq!(free.exit, Some(0), "{}", free.err);
    let why = folder.run("explain forklift.yaml arrival agent0");
    assert_eq!(why.exit, Some(0), "{}", why.err);
    // It goes along, or its loss is told.
    let own = folder.run("convert forklift.yaml --to giveway -q");
    assert!(
        own.out.contains("\"moving-obstacle\"") && own.err.contains("forklift"),
        "{own:?}"
    );
    assert!(own.out.contains("\"closed\"") && own.out.contains("forklift (5, 1)"));
    std::fs::write(folder.path("own.json"), &own.out).unwrap();
    let again = answer(&folder.run("solve own.json --format json"), "solveResult");
    assert_eq!(again["costs"], solved["costs"]);
    let lost = folder.run("convert forklift.yaml --to movingai --output out");
    for said in ["1 moving obstacle", "7 rules of the scene's own", "7 zones"] {
        assert!(lost.err.contains(said), "{said}: {}", lost.err);
    }
}

#[test]
fn a_plan_that_evades_a_moving_obstacle_is_the_best() {
    let input = "map: {dimensions: [3, 2], obstacles: []}\nagents: [{name: a, start: [0, 0], goal: [2, 0]}]\n\
        dynamic_obstacles: {cart: [{t: 0, x: 0, y: 1}, {t: 3, x: 1, y: 1}]}\n";
    let folder = Folder::with(&[("i.yaml", input)]);
    let told = answer(&folder.run("solve i.yaml --format json"), "solveResult");
    assert_eq!(told["status"], "optimal");
    assert!(notes(&told).contains("cart"));
}

#[test]
fn unknown_keys_are_told_and_weaken() {
    let scene = "map: {dimensions: [3, 1], obstacles: []}\nagents: [{name: a, start: [0, 0], goal: [2, 0], speed: 2}]\n\
        description: a lane\nturning: true\n";
    let plan = "schedule: {a: [{t: 0, x: 0, y: 0}, {t: 1, x: 1, y: 0}, {t: 2, x: 2, y: 0}]}\n";
    let folder = Folder::with(&[("i.yaml", scene), ("o.yaml", plan)]);
    for (line, definition, status) in [
        ("solve i.yaml", "solveResult", "feasible"),
        ("audit i.yaml o.yaml", "auditResult", "unknown"),
    ] {
        let told = answer(&folder.run(&format!("{line} --format json -q")), definition);
        assert_eq!(
            (&told["status"], &told["bounds"]),
            (&json!(status), &json!({})),
            "{told}"
        );
        assert!(notes(&told).contains("agents.speed and turning"), "{told}");
        assert!(!notes(&told).contains("description"));
        assert!(
            folder
                .run(&format!("{line} -q"))
                .out
                .contains("agents.speed and turning")
        );
    }
    let checked = answer(
        &folder.run("check i.yaml o.yaml --format json -q"),
        "checkResult",
    );
    assert!(notes(&checked).contains("turning"));
}

#[test]
fn the_ends_of_a_plan_decide_goals_that_are_open() {
    let folder = folder(&[
        "choice.yaml",
        "choice-out.yaml",
        "m.lp",
        "m-plan.lp",
        "no-order.lp",
    ]);
    for (problem, plan, sum) in [
        ("choice.yaml", "choice-out.yaml", 2),
        ("m.lp", "m-plan.lp", 1),
        ("no-order.lp", "m-plan.lp", 1),
    ] {
        let run = folder.run(&format!("audit {problem} {plan} --format json -q"));
        let told = answer(&run, "auditResult");
        assert_eq!(
            (run.exit, &told["status"]),
            (Some(0), &json!("optimal")),
            "{problem}"
        );
        assert_eq!(told["costs"]["sum-of-costs"], sum);
        assert_eq!(told["assumptions"][0]["assumes"], "goals-chosen");
        assert!(
            notes(&told).contains(&format!("where the paths in {plan} end")),
            "{told}"
        );
        let text = folder.run(&format!("audit {problem} {plan} -q")).out;
        // The plan lifts nothing, so that it is of asprilo's domain M, which has no handling.
        let word = "The best for the goals chosen: proved.";
        assert!(text.contains(word), "{text}");
        let run = folder.run(&format!("check {problem} {plan} --format json -q"));
        assert_eq!(run.exit, Some(0), "{problem}");
        assert!(
            notes(&answer(&run, "checkResult")).contains("end, since its problem leaves them open")
        );
    }
    // Without a plan it is said which goals were taken.
    let told = answer(
        &folder.run("solve choice.yaml --format json -q"),
        "solveResult",
    );
    assert!(notes(&told).contains("Robots may choose from several goals."));
    assert!(
        folder
            .run("solve choice.yaml -q")
            .out
            .contains("This holds for the goals chosen.")
    );
}

#[test]
fn a_rule_can_be_set_for_every_file_and_is_named() {
    let folder = folder(&["08.map", "08.scen", "08-plan.txt"]);
    let stays = folder.run("audit 08-plan.txt 08.map 08.scen");
    assert_eq!(stays.exit, Some(1));
    assert!(
        stays.out.contains("--at-goal vanish judges it so"),
        "{}",
        stays.out
    );
    let run = folder.run("audit 08-plan.txt 08.map 08.scen --at-goal vanish --format json -q");
    let told = answer(&run, "auditResult");
    assert_eq!((run.exit, &told["status"]), (Some(0), &json!("optimal")));
    assert_eq!(told["costs"]["sum-of-costs"], 4);
    assert!(notes(&told).contains("robots vanish at their goals"));
    let lines = [
        ("check 08.scen 08-plan.txt --at-goal vanish", "Valid"),
        ("solve 08.scen --at-goal vanish", "makespan 3"),
        (
            "compare 08-plan.txt 08-plan.txt 08.map 08.scen --at-goal vanish",
            "yes",
        ),
        ("explain 08.scen fewer waits A1 --at-goal vanish", "vanish"),
        ("solve 08.scen --at-goal stay --floor 2", "No plan"),
    ];
    for (line, said) in lines {
        let run = folder.run(line);
        assert!(
            run.out.contains(said) || line.starts_with("explain"),
            "{line}: {run:?}"
        );
    }
    let floor = folder
        .run("solve 08.scen --at-goal vanish --floor 2 -q")
        .out;
    assert!(
        floor.contains("(--floor 2)") && floor.contains("battery floor 2"),
        "{floor}"
    );
    let own = folder
        .run("convert 08.scen --to giveway --at-goal vanish")
        .out;
    assert!(own.contains(r#""at_goal": "vanish""#), "{own}");
}

#[test]
fn yaml_is_read_in_every_style() {
    let folder = folder(&["flow.yaml"]);
    let told = answer(&folder.run("solve flow.yaml --format json"), "solveResult");
    assert_eq!(
        (&told["status"], &told["costs"]["makespan"]),
        (&json!("optimal"), &json!(1))
    );
    let plan = "{schedule: {a: [{t: 0, x: 0, y: 0}, {t: 1, x: 1, y: 0}]}}";
    std::fs::write(folder.path("plan.txt"), plan).unwrap();
    for line in [
        "check flow.yaml plan.txt",
        "audit flow.yaml plan.txt",
        "compare flow.yaml plan.txt plan.txt",
    ] {
        assert_eq!(folder.run(line).exit, Some(0), "{line}");
    }
    assert!(
        folder
            .run("convert flow.yaml --to giveway")
            .out
            .contains("\"name\": \"a\"")
    );
}

#[test]
fn lines_that_lacam_leaves_out_are_left_out_beside_its_result() {
    let folder = folder(&["07.map", "07.scen", "07-result.txt"]);
    let run = folder.run("audit 07-result.txt 07.map 07.scen --format json -q");
    let told = answer(&run, "auditResult");
    assert_eq!((run.exit, &told["status"]), (Some(0), &json!("optimal")));
    assert!(
        notes(&told).contains("left out, as LaCAM does: 2."),
        "{told}"
    );
    assert_eq!(folder.run("check 07.scen 07-result.txt").exit, Some(0));
    // Without a plan every such line is told.
    let scen = folder.read("07.scen") + "0\t07.map\t3\t1\t0\t0\t1\t0\t1\n";
    std::fs::write(folder.path("07.scen"), scen).unwrap();
    let err = folder.run("solve 07.scen").err;
    assert!(err.contains("line 2") && err.contains("line 4"), "{err}");
}
