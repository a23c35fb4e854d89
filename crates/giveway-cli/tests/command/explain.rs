//! `giveway explain`.

use expect_test::expect;
use serde_json::{Value, json};

use crate::reasons::TWO_WALLS;
use crate::run::{Folder, SCENARIO_1, SCENARIO_6, WAREHOUSE, WAREHOUSE_PLAN};

/// The first plan of the published scenario 1.
const PLAN_1: &str = r#"{ "giveway": 1, "paths": {
    "A1": [[2, 2], [2, 1], [1, 1], [0, 1]],
    "A2": [[3, 1], [3, 1], [2, 1], [1, 1], [1, 0]] } }"#;

/// A robot that goes around an obstacle which appears at time 1, and waits once
/// more than it need.
const ALONE: &str = r#"{ "giveway": 1, "map": ["....", "...."],
    "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] }] }"#;
const ALONE_PLAN: &str = r#"{ "giveway": 1, "paths": { "A1":
    [[0, 0], [1, 0], [1, 0], [1, 1], [2, 1], [3, 1], [3, 0]] } }"#;
const ALONE_CHANGES: &str = r#"{ "giveway": 1, "changes": [
    { "at": 1, "change": "add-obstacle", "cell": [2, 0] }] }"#;
/// The same, and another change once it has arrived.
const ALONE_LATER: &str = r#"{ "giveway": 1, "changes": [
    { "at": 1, "change": "add-obstacle", "cell": [2, 0] },
    { "at": 9, "change": "remove-agent", "agent": "A1" }] }"#;

fn scenario_1() -> Folder {
    Folder::with(&[("scene.json", SCENARIO_1), ("plan.json", PLAN_1)])
}

fn warehouse() -> Folder {
    Folder::with(&[("scene.json", WAREHOUSE), ("plan.json", WAREHOUSE_PLAN)])
}

#[test]
fn the_published_scenario_1() {
    let run = scenario_1().run("explain scene.json --plan plan.json wait A2 --at 3,1");
    let text: Vec<&str> = run.answer().lines().collect();
    expect![[r#"
        scenario-1: 4 x 3 cells, 2 robots

        Why does A2 wait at (3, 1)? (wait A2 --at 3,1)
        Needless: If A2 did not wait at (3, 1), it would meet A1 at (2, 1) at time 1. But A1 could wait instead: there is another plan that costs the same.
        This holds no matter how many steps you allow.

        cost           this plan  other plan  difference
        makespan               4           4           -
        sum of costs           7           7           -
        charges                0           0           -
        moves                  6           6           -
        waits                  1           1           -

           0     1     2     3
         0 .     .b    ##### .
         1 .a    .     .a'b' .B
         2 .     .     .A    .
          # obstacle, A start, a goal, a' waypoint
          A = A1, B = A2

        time       0     1     2     3     4
        A1       2,2   2,1   1,1   0,1
          other  2,2  !2,2  !2,1  !1,1  !0,1
        A2       3,1   3,1   2,1   1,1   1,0
          other  3,1  !2,1  !1,1  !1,0
          other: what the robot does in the other plan; ! marks a difference
        No equally good plan is closer to this one.
    "#]]
    .assert_eq(&(text[..text.len().min(27)].join("\n") + "\n"));
}

#[test]
fn json_has_the_specified_keys() {
    let answer = warehouse()
        .run("explain scene.json --plan plan.json slow A1 --format json")
        .json();
    assert_eq!(answer["question"], json!({ "kind": "slow", "agent": "A1" }));
    assert_eq!(answer["verdict"], "costly");
    assert_eq!(
        answer["deltas"],
        json!({ "makespan": 5, "sum-of-costs": 6, "charges": 1 })
    );
    let mut keys: Vec<&String> = answer.as_object().unwrap().keys().collect();
    keys.sort();
    assert_eq!(
        keys,
        [
            "alternative",
            "closest",
            "complete",
            "core",
            "costs",
            "deltas",
            "exhaustive",
            "further_repairs",
            "giveway",
            "pays",
            "question",
            "repairs",
            "stats",
            "verdict",
            "within",
            "witness",
            "words"
        ]
    );
    let fact = answer["core"]["facts"][0].as_object().unwrap();
    let mut keys: Vec<&String> = fact.keys().collect();
    keys.sort();
    assert_eq!(keys, ["agents", "cell", "helps", "kind", "text"]);
}

/// What the command writes is what the schema says.
#[test]
fn answers_keep_to_the_schema() {
    let mut schema: Value = serde_json::from_str(giveway_model::format::schema()).unwrap();
    let object = schema.as_object_mut().unwrap();
    object.remove("anyOf");
    object.insert("$ref".into(), "#/$defs/explainResult".into());
    let validator = jsonschema::draft202012::new(&schema).unwrap();
    let folder = Folder::with(&[
        ("warehouse.json", WAREHOUSE),
        ("warehouse.plan.json", WAREHOUSE_PLAN),
        ("scenario-6.json", SCENARIO_6),
        ("scenario-1.json", SCENARIO_1),
        ("plan.json", PLAN_1),
        ("two-walls.json", TWO_WALLS),
        ("around.json", ALONE),
        ("around.plan.json", ALONE_PLAN),
        ("around.changes.json", ALONE_CHANGES),
    ]);
    for line in [
        "warehouse.json --plan warehouse.plan.json arrival A1",
        "warehouse.json --plan warehouse.plan.json order A1 --first 2,0 --second 4,2",
        "warehouse.json --plan warehouse.plan.json plan",
        "scenario-1.json wait A2",
        "scenario-1.json --plan plan.json wait A2 --from 0 --to 1",
        "scenario-1.json --plan plan.json plan",
        "scenario-6.json unsolvable",
        "two-walls.json unsolvable",
        "around.json --plan around.plan.json --changes around.changes.json plan",
    ] {
        let run = folder.run(&format!("explain {line} --format json"));
        // Which of two equal plans is found first decides whether A2 waits.
        if run.exit == Some(1) && line == "scenario-1.json wait A2" {
            continue;
        }
        let answer: Value = serde_json::from_str(&run.out).unwrap();
        let errors: Vec<String> = validator
            .iter_errors(&answer)
            .map(|error| format!("{error} at {}", error.instance_path()))
            .collect();
        assert_eq!(errors, Vec::<String>::new(), "{line}");
    }
}

#[test]
fn without_a_plan_the_best_one_is_asked_about() {
    let answer = Folder::scene(WAREHOUSE)
        .run("explain scene.json makespan --format json")
        .json();
    assert_eq!(answer["verdict"], "necessary");
    assert!(answer["plan"]["paths"]["A1"].is_array());
}

#[test]
fn what_is_not_so_is_told() {
    let folder = warehouse();
    for (question, said) in [
        (
            "wait A1",
            expect![[r#"
                exit 1
                A1 does not wait. It never waits before its arrival. You can ask: arrival A1
            "#]],
        ),
        (
            "wait A9",
            expect![[r#"
                exit 1
                agent: found "A9", expected one of A1, A2
            "#]],
        ),
        (
            "visit A1 --at 12,0",
            expect![[r#"
                exit 1
                at: found (12, 0), expected a cell of the 10 x 3 map
            "#]],
        ),
        (
            "charge A1 --at 3,2",
            expect![[r#"
                exit 1
                A1 does not charge at (3, 2). It charges at (6, 2) at time 9. You can ask: charge A1 --at 6,2 --time 9
            "#]],
        ),
    ] {
        folder.refuses(
            &format!("explain scene.json --plan plan.json {question}"),
            &said,
        );
    }
}

#[test]
fn a_broken_plan_is_told_with_what_it_breaks() {
    let broken = PLAN_1.replace("[[3, 1], [3, 1], [2, 1]", "[[3, 1], [2, 1]");
    let folder = Folder::with(&[("scene.json", SCENARIO_1), ("plan.json", &broken)]);
    folder.refuses(
        "explain scene.json --plan plan.json arrival A2",
        &expect![[r#"
            exit 1
            A1 and A2 are both at (2, 1) at time 1.
            A1 and A2 are both at (1, 1) at time 2.
        "#]],
    );
}

#[test]
fn what_is_no_question_is_a_wrong_command_line() {
    let folder = scenario_1();
    for (question, said) in [
        ("why A1", "found \"why\", expected one of wait, charge"),
        ("wait", "\"wait\" needs a robot"),
        ("visit A1", "\"visit\" needs --at"),
        ("wait A1 --at 3", "found \"3\", expected a cell X,Y"),
        ("wait A1 --from -1", "found \"-1\", expected a whole number"),
        ("makespan A1", "\"makespan\" does not use \"A1\""),
    ] {
        let run = folder.run(&format!("explain scene.json {question}"));
        assert_eq!((run.exit, run.out.as_str()), (Some(2), ""), "{question}");
        let said = said.to_lowercase();
        assert!(run.err.to_lowercase().contains(&said), "{}", run.err);
    }
}

#[test]
fn why_there_is_no_plan() {
    let run = Folder::scene(SCENARIO_6).run("explain scene.json unsolvable");
    let text = run.answer();
    for part in [
        "Impossible: There is no plan.",
        "A1 and A2 are both at (1, 2) at time 3.",
        "Remove the obstacle at (1, 0): makespan 6, sum of costs 8.",
    ] {
        assert!(text.contains(part), "{part} in\n{text}");
    }
    Folder::scene(SCENARIO_6).refuses(
        "explain scene.json makespan",
        &expect![[r#"
            exit 1
            There is no plan to ask about. You can ask: unsolvable
        "#]],
    );
}

fn around() -> Folder {
    Folder::with(&[
        ("scene.json", ALONE),
        ("plan.json", ALONE_PLAN),
        ("changes.json", ALONE_LATER),
    ])
}

#[test]
fn a_plan_around_which_the_world_changed() {
    let line = "explain scene.json --plan plan.json --changes changes.json --at-time 4 wait A1";
    let folder = around();
    let answer = folder.run(&format!("{line} --format json")).json();
    assert_eq!(answer["since"], 1);
    assert_eq!(answer["verdict"], "improvable");
    assert_eq!(answer["costs"]["makespan"], 5);
    let cells = json!([[0, 0], [1, 0], [1, 1], [2, 1], [3, 1], [3, 0]]);
    assert_eq!(answer["alternative"]["paths"]["A1"], cells);
    let run = folder.run(line);
    let text = run.answer();
    let told = "Improvable: This is about the plan from time 1 on. There \
                is even a better plan in which A1 does not wait: a makespan of 5 instead of 6 \
                and a sum of costs of 5 instead of 6.";
    assert!(text.contains(told), "{text}");
    assert!(
        text.contains("makespan               6           5          -1"),
        "{text}"
    );
    assert!(text.contains("The other plan:"), "{text}");
}

#[test]
fn a_question_about_what_is_past_is_refused() {
    let run = around().run(
        "explain scene.json --plan plan.json --changes changes.json --at-time 4 \
         visit A1 --at 0,0 --time 0",
    );
    assert_eq!(run.exit, Some(1), "{}", run.err);
    let told = "Time 0 is already past: the question is about the plan from time 1 on";
    assert!(run.err.contains(told), "{}", run.err);
}

#[test]
fn changes_need_a_plan_and_have_no_certificate() {
    for line in ["--changes changes.json", "--plan plan.json --at-time 3"] {
        let run = around().run(&format!("explain scene.json {line} wait A1"));
        assert_eq!(run.exit, Some(2), "{line}: {}", run.err);
    }
    let line = "--plan plan.json --changes changes.json --proof new wait A1";
    let run = around().run(&format!("explain scene.json {line}"));
    assert_eq!(run.exit, Some(2), "{}", run.err);
}

/// A lane of two robots in which R2 breaks down at time 3 for 40 steps.
fn lane() -> Folder {
    let folder = Folder::with(&[
        ("lane.json", include_str!("data/lane.json")),
        ("lane.plan.json", include_str!("data/lane.plan.json")),
        ("delay.json", include_str!("data/lane.delay.json")),
    ]);
    let line = "change lane.json lane.plan.json delay.json --format json";
    let adopted = folder.run(line).out;
    std::fs::write(folder.path("adopted.json"), adopted).unwrap();
    folder
}

fn ask_lane(folder: &Folder, question: &str) -> Value {
    let line = format!(
        "explain lane.json --plan adopted.json --changes delay.json {question} --format json"
    );
    folder.run(&line).json()
}

#[test]
fn a_wait_for_a_broken_robot_is_no_past() {
    let folder = lane();
    let answer = ask_lane(&folder, "wait R1 --from 4 --to 40");
    assert_eq!(
        (&answer["since"], &answer["verdict"]),
        (&json!(3), &json!("needless"))
    );
    let words = answer["words"].as_str().unwrap();
    assert!(
        words.contains("R2 is broken down from time 3 to 43"),
        "{words}"
    );
    let path = answer["alternative"]["paths"]["R2"].as_array().unwrap();
    assert!((3..=43).all(|time| path[time] == json!([8, 1])), "{path:?}");
}

#[test]
fn a_breakdown_is_a_fact_with_its_time() {
    let folder = lane();
    for question in [
        "wait R2 --from 3 --to 43",
        "arrival R1",
        "makespan",
        "sum-of-costs",
    ] {
        let answer = ask_lane(&folder, question);
        assert_eq!(
            (&answer["since"], &answer["verdict"]),
            (&json!(3), &json!("necessary"))
        );
        let facts = answer["core"]["facts"].as_array().unwrap();
        let fact = facts
            .iter()
            .find(|fact| fact["kind"] == "breakdown")
            .unwrap();
        assert_eq!(
            fact,
            &json!({ "kind": "breakdown", "agents": ["R2"], "cell": null, "helps": true, "time": 3, "until": 43,
                "text": "R2 is broken down from time 3 to 43" })
        );
    }
}
