//! Problems with rules that scenes do not have: bounds hold, plans that are found claim nothing.

use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::{Folder, Run};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";

/// A robot that looks to the east, with what it does; moves and turns take so many ticks.
fn result(actions: &str, ticks: u32) -> String {
    let path = json!([actions]);
    let start = json!([[0, 0, "E"]]);
    json!({ "actionModel": "MAPF_T", "agentMaxCounter": ticks, "start": start, "actualPaths": path })
        .to_string()
}

fn answer(run: &Run, definition: &str) -> Value {
    let value: Value = serde_json::from_str(&run.out).unwrap();
    fits(definition, &value);
    value
}

#[test]
fn a_plan_of_robots_that_turn_is_compared_with_plans_that_turn() {
    let turning = result("R,F", 1);
    let folder = Folder::with(&[("a.map", MAP), ("turning.json", &turning)]);
    let told = answer(
        &folder.run("audit turning.json a.map --format json -q"),
        "auditResult",
    );
    assert_eq!(
        (&told["status"], &told["bounds"]["sum-of-costs"]),
        (&json!("optimal"), &json!(2))
    );
    assert!(
        told["assumptions"].as_array().is_none_or(Vec::is_empty),
        "{told}"
    );
    let text = folder.run("audit turning.json a.map -q").out;
    assert!(text.contains("The best: proved."), "{text}");
}

#[test]
fn a_plan_of_long_moves_is_compared_with_the_bound_and_with_no_plan_of_ours() {
    let (slow, ahead) = (
        result("[(0,0,0,0,0):(R 2,F 2)]", 2),
        result("[(0,0,0,0,0):(F 1)]", 1),
    );
    let folder = Folder::with(&[("a.map", MAP), ("slow.json", &slow), ("ahead.json", &ahead)]);
    let told = answer(
        &folder.run("audit slow.json a.map --format json -q"),
        "auditResult",
    );
    assert_eq!(
        (&told["legal"], &told["status"]),
        (&json!(true), &json!("feasible"))
    );
    assert_eq!(
        (&told["better"], &told["search"]),
        (&Value::Null, &json!("unknown"))
    );
    assert_eq!(told["bounds"], json!({ "sum-of-costs": 2 }));
    assert_eq!(
        told["assumptions"],
        json!([{ "assumes": "rule-left-out", "rule": "long-moves" }])
    );
    let text = folder.run("audit slow.json a.map -q").out;
    assert!(text.contains("At most 100.0 % above the best"), "{text}");
    assert!(text.contains("a move takes several steps"), "{text}");
    assert!(!text.contains("proved."), "{text}");

    // What costs no more than the bound is the best with long moves, too.
    let told = answer(
        &folder.run("audit ahead.json a.map --format json -q"),
        "auditResult",
    );
    assert_eq!(told["status"], "optimal");
    let text = folder.run("audit ahead.json a.map -q").out;
    assert!(text.contains("No plan costs less: proved."), "{text}");
}

#[test]
fn an_illegal_plan_is_given_no_legal_one_beside_it() {
    let both = json!({
        "actionModel": "MAPF_T", "agentMaxCounter": 2, "start": [[0, 0, "E"], [0, 2, "W"]],
        "actualPaths": ["[(0,0,0,0,0):(F 4)]", "[(0,0,2,2,0):(F 4)]"],
    });
    let both = both.to_string();
    let folder = Folder::with(&[("a.map", MAP), ("r.json", &both)]);
    let told = answer(
        &folder.run("audit r.json a.map --format json -q"),
        "auditResult",
    );
    assert_eq!(
        (&told["status"], &told["better"]),
        (&json!("illegal"), &Value::Null)
    );
    assert_eq!(told["bounds"], json!({ "sum-of-costs": 9 }));
}

#[test]
fn the_plan_of_a_problem_of_the_league_turns() {
    let problem = r#"{ "mapFile": "a.map", "agentFile": "a.agents", "taskFile": "a.tasks" }"#;
    let folder = Folder::with(&[
        ("p.json", problem),
        ("a.map", MAP),
        ("a.agents", "1\n0\n"),
        ("a.tasks", "1\n5\n"),
    ]);
    let told = answer(&folder.run("solve p.json --format json -q"), "solveResult");
    assert_eq!(told["status"], "optimal");
    assert_eq!(
        (&told["bounds"]["makespan"], &told["costs"]["makespan"]),
        (&json!(4), &json!(4))
    );
    let line = "solve p.json --pareto --objective makespan,moves --format json -q";
    let front = answer(&folder.run(line), "paretoResult");
    assert_eq!(front["status"], "optimal");
    // It goes along in a file of our own.
    let own = folder.run("convert p.json --to giveway -q").out;
    std::fs::write(folder.path("own.json"), &own).unwrap();
    let again = answer(
        &folder.run("solve own.json --format json -q"),
        "solveResult",
    );
    assert_eq!(
        (&again["status"], &again["costs"]["makespan"]),
        (&json!("optimal"), &json!(4))
    );
}

/// A robot that is walled off from the goal that was chosen for it.
const WALLED: &str = r##"{ "giveway": 1, "map": [".#."],
    "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }],
    "assumptions": [{ "assumes": "goals-chosen" }] }"##;

#[test]
fn no_plan_for_the_goals_chosen_says_nothing_of_other_goals() {
    let folder = Folder::scene(WALLED);
    for line in [
        "solve scene.json --format json -q",
        "solve scene.json --pareto --objective makespan,moves --format json -q",
    ] {
        let told: Value = serde_json::from_str(&folder.run(line).out).unwrap();
        assert_eq!(told["status"], "unknown", "{line}");
        assert_eq!(told["complete"], false, "{line}");
        assert_eq!(told["ended"], "assumptions", "{line}");
    }
}

#[test]
fn beside_an_unknown_key_nothing_is_claimed() {
    let with_key = |map: &str| {
        WALLED
            .replace(".#.", map)
            .replace("\"goals-chosen\"", "\"unknown-key\", \"key\": \"speed\"")
    };
    for (map, status) in [("...", "feasible"), (".#.", "unknown")] {
        let folder = Folder::scene(with_key(map));
        let run = folder.run("solve scene.json --format json -q");
        let told: Value = serde_json::from_str(&run.out).unwrap();
        assert_eq!(told["status"], status);
        assert_eq!(
            (&told["complete"], &told["within"], &told["bounds"]),
            (&json!(false), &Value::Null, &json!({})),
            "{map}"
        );
        let front =
            folder.run("solve scene.json --pareto --objective makespan,moves --format json -q");
        let told: Value = serde_json::from_str(&front.out).unwrap();
        assert_eq!(
            (&told["status"], &told["complete"]),
            (&json!(status), &json!(false))
        );
    }
}
