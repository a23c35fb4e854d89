//! `giveway change`, and `giveway check --changes`.

use std::io::Write as _;
use std::process::Stdio;
use std::time::Duration;

use expect_test::expect;
use serde_json::{Value, json};

use crate::run::{Folder, command};

const SCENE: &str = include_str!("../../../../tests/data/seed/dynamic-3x3.json");
const PLAN: &str = include_str!("../../../../tests/data/seed/dynamic-3x3.plan.json");
const LATER: &str = include_str!("../../../../tests/data/seed/dynamic-3x3.plan-t1.json");
const CHANGES: &str = include_str!("../../../../tests/data/seed/dynamic-3x3.changes.json");

fn folder() -> Folder {
    Folder::with(&[
        ("scene.json", SCENE),
        ("plan.json", PLAN),
        ("later.json", LATER),
        ("changes.json", CHANGES),
    ])
}

/// The answer as JSON, which must be of the schema.
fn answer(folder: &Folder, line: &str) -> Value {
    let answer = folder.run(line).json();
    let mut schema: Value = serde_json::from_str(giveway_model::format::schema()).unwrap();
    schema["$ref"] = "#/$defs/changeResult".into();
    schema.as_object_mut().unwrap().remove("anyOf");
    let result = jsonschema::draft202012::validate(&schema, &answer);
    assert!(result.is_ok(), "{result:?}");
    answer
}

#[test]
fn the_example_of_the_paper() {
    let answer = answer(
        &folder(),
        "change scene.json later.json changes.json --format json",
    );
    let revise = &answer["methods"]["revise"];
    assert_eq!(revise["costs"]["makespan"], 5);
    assert_eq!(
        revise["plan"]["paths"]["A4"],
        json!([[0, 2], [0, 1], [0, 0]])
    );
    assert_eq!(revise["plan"]["from"], json!({ "A3": 1, "A4": 2 }));
    assert_eq!(revise["retimed"], json!(["A1", "A2", "A3"]));
    assert_eq!(
        (&revise["added"], &revise["freed"]),
        (&json!(["A4"]), &json!([]))
    );
    assert_eq!(answer["methods"]["replan"]["costs"]["makespan"], 4);
    assert_eq!(
        (&answer["adopted"], &answer["history"]),
        (&json!("revise"), &json!([]))
    );
}

/// A horizon before the change: only what is past by then can be within it.
#[test]
fn a_horizon_that_is_over_already() {
    let folder = folder();
    let line = "change scene.json later.json changes.json --format json --within 1";
    let too_soon = answer(&folder, line);
    for method in ["revise", "replan"] {
        let found = &too_soon["methods"][method];
        assert_eq!(
            (&found["status"], &found["within"]),
            (&json!("impossible"), &json!(1))
        );
        assert_eq!(found["cause"]["within"], 1);
    }
    let late =
        r#"{ "giveway": 1, "changes": [{ "at": 9, "change": "add-obstacle", "cell": [1, 1] }] }"#;
    let folder = Folder::with(&[
        ("scene.json", SCENE),
        ("plan.json", PLAN),
        ("late.json", late),
    ]);
    let line = |within: u32| {
        format!("change scene.json plan.json late.json --format json --within {within}")
    };
    let status = |within| answer(&folder, &line(within))["methods"]["revise"]["status"].clone();
    assert_eq!(
        (status(3), status(4)),
        (json!("impossible"), json!("optimal"))
    );
}

#[test]
fn a_history_is_saved_and_loaded_again() {
    let folder = folder();
    let line = "change scene.json plan.json changes.json --format json";
    let answer = answer(&folder, line);
    assert_eq!(answer["history"][0]["at"], 1);
    assert_eq!(answer["history"][0]["adopted"], "revise");
    let saved = serde_json::to_string(&answer).unwrap();
    let check = "check scene.json - --changes changes.json --format json";
    let checked = folder.run_with(check, &saved).json();
    assert_eq!(checked["valid"], true);
    assert_eq!(checked["costs"], answer["methods"]["revise"]["costs"]);
    // The plan knows all changes: nothing is left to do.
    let again = "change scene.json - changes.json";
    let again = folder.run_with(again, &saved);
    assert!(
        again
            .answer()
            .contains("The plan already knows all of these changes")
    );
}

#[test]
fn a_column_for_each_method() {
    let line = "change scene.json later.json changes.json --method revise,tunnel=0,replan";
    let text = folder().run(line);
    let told: Vec<&str> = text.answer().lines().take(17).collect();
    let told = told.join("\n") + "\n";
    // How much work it is may change, and how long it takes.
    let told: Vec<&str> = told
        .lines()
        .filter(|line| !line.starts_with("CPU") && !line.starts_with("conflicts"))
        .collect();
    expect![[r#"
        dynamic-3x3: 3 x 3 cells, 2 robots

        Changes at time 2
                              before      revise    tunnel=0      replan
        plan                             optimal     optimal     optimal
        makespan                   4           5           5           4
        sum of costs              12          19          19          16
        charges                    0           0           0           0
        moves                     11          13          13          13
        waits                      0           3           3           0
        kept                                   0           0           2
        re-timed                               3           3           0
        re-routed                              0           0           1
        added                                  1           1           1
        freed                                  0           0           0"#]]
    .assert_eq(&told.join("\n"));
}

#[test]
fn a_change_that_contradicts_the_world_is_refused_with_its_place() {
    let folder = folder();
    let changes = "{ \"giveway\": 1,\n  \"changes\": [\n    \
        { \"at\": 1, \"change\": \"add-obstacle\", \"cell\": [1, 0] } ] }";
    std::fs::write(folder.path("bad.json"), changes).unwrap();
    let refusal = expect![[r#"
        exit 1
        bad.json: line 3, column 5: changes[0]: found an obstacle at (1, 0), where A1 is at time 1, expected a cell that is free then
    "#]];
    folder.refuses("change scene.json plan.json bad.json", &refusal);
    folder.refuses("check scene.json plan.json --changes bad.json", &refusal);
    folder.refuses("change scene.json plan.json scene.json", &expect![[r#"
        exit 1
        scene.json: line 1, column 1: found an instance, with "map" and "agents", expected a list of changes, with "changes"
    "#]]);
    folder.refuses(
        "change scene.json plan.json changes.json --method rush",
        &expect![[r#"
            exit 2
            error: invalid value 'rush' for '--method <LIST>': found "rush", expected revise, tunnel=W or replan

            For more information, try '--help'.
        "#]],
    );
}

#[test]
fn an_obstacle_on_a_path_frees_one_agent_and_says_why() {
    let folder = folder();
    let changes = r#"{ "giveway": 1, "changes":
        [{ "at": 1, "change": "add-obstacle", "cell": [2, 2] },
         { "at": 1, "change": "set-goal", "agent": "A1", "cell": [2, 0] }] }"#;
    std::fs::write(folder.path("c.json"), changes).unwrap();
    let answer = answer(&folder, "change scene.json plan.json c.json --format json");
    let revise = &answer["methods"]["revise"];
    assert_eq!(revise["freed"], json!(["A1"]));
    assert_eq!(revise["cause"]["kind"], "obstacle");
    assert_eq!(revise["cause"]["cell"], json!([2, 2]));
    assert_eq!(
        (&revise["cause"]["within"], &revise["cause"]["agent"]),
        (&Value::Null, &json!("A1"))
    );
    assert_eq!(revise["kept"], json!(["A2"]));
}

/// A breakdown of 10,000 steps is taken, a longer one refused with that limit.
#[test]
fn delays_have_a_limit_that_is_named() {
    for (steps, is_taken) in [
        (5000_u32, true),
        (10_000, true),
        (10_001, false),
        (4_000_000, false),
    ] {
        let delay = format!(
            r#"{{ "giveway": 1, "changes": [ {{ "at": 3, "change": "delay-agent", "agent": "R2", "steps": {steps} }} ] }}"#
        );
        let folder = Folder::with(&[
            ("lane.json", include_str!("data/lane.json").to_owned()),
            (
                "lane.plan.json",
                include_str!("data/lane.plan.json").to_owned(),
            ),
            ("delay.json", delay),
        ]);
        let run = folder.run("check lane.json lane.plan.json --changes delay.json");
        if is_taken {
            assert!(!run.err.contains("at most"), "{steps}: {}", run.err);
        } else {
            let told = format!("found a delay of {steps} steps, expected at most 10000");
            assert!(run.err.contains(&told), "{steps}: {}", run.err);
            assert_eq!(run.exit, Some(1), "{steps}");
        }
    }
}

/// As for `solve`, the time that reading takes is part of the limit.
#[test]
fn what_reading_takes_is_part_of_the_limit() {
    let folder = folder();
    let run = |wait: Duration| {
        let line = "change scene.json plan.json - --method replan --time-limit 2 --format json";
        let mut child = command()
            .args(line.split_whitespace())
            .current_dir(folder.path(""))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        std::thread::sleep(wait);
        let mut input = child.stdin.take().unwrap();
        input.write_all(CHANGES.as_bytes()).unwrap();
        drop(input);
        let output = child.wait_with_output().unwrap();
        serde_json::from_slice::<Value>(&output.stdout).unwrap()["methods"]["replan"].clone()
    };
    assert_eq!(run(Duration::ZERO)["status"], "optimal");
    let late = run(Duration::from_secs(3));
    assert_ne!(late["status"], "optimal", "{late}");
    assert_eq!(late["ended"], "time", "{late}");
}
