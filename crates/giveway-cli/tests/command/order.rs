//! `giveway order SCENE`: the order that robots keep without a common clock.

use expect_test::expect;
use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::Folder;

/// Two robots follow each other; the second may wait aside.
const ROW: &str = r#"{ "giveway": 1, "name": "row", "map": ["...."], "units": { "cell": 2, "step": 0.5 },
  "agents": [{ "name": "A1", "start": [1, 0], "goal": [3, 0] },
             { "name": "A2", "start": [0, 0], "goal": [2, 0], "battery": { "capacity": 9, "initial": 4 } }] }"#;

const PLAN: &str = r#"{ "giveway": 1, "paths": {
  "A1": [[1, 0], [2, 0], [3, 0]], "A2": [[0, 0], [0, 0], [1, 0], [2, 0]] } }"#;

/// A plan in which they meet.
const CRASH: &str = r#"{ "giveway": 1, "paths": {
  "A1": [[1, 0], [1, 0], [2, 0], [3, 0]], "A2": [[0, 0], [1, 0], [2, 0]] } }"#;

const CHANGES: &str =
    r#"{ "giveway": 1, "changes": [{ "at": 1, "change": "add-charger", "cell": [1, 0] }] }"#;

fn folder() -> Folder {
    Folder::with(&[
        ("row.json", ROW),
        ("plan.json", PLAN),
        ("crash.json", CRASH),
        ("changes.json", CHANGES),
    ])
}

fn order(line: &str) -> Value {
    let run = folder().run(&format!("order {line} --format json"));
    assert_eq!(run.err, "");
    let answer = serde_json::from_str(&run.out).unwrap();
    fits("orderResult", &answer);
    answer
}

#[test]
fn who_goes_first_is_told_cell_by_cell() {
    let run = folder().run("order row.json plan.json --late A1@(2,0)+3");
    let (said, _) = run.answer().rsplit_once("\n\n").unwrap();
    expect![[r#"
        row: 4 x 1 cells, 2 robots

        In which order?
        2 times a robot comes to a cell after another one: it begins to come no earlier than the other one begins to leave.
        The battery of A2 bears 1 step of lateness.

           0  1  2  3
         0 .B .A .b .a
          A start, a goal
          A = A1, B = A2

        time      0    1    2    3
        A1      1,0  2,0  3,0
        A2      0,0  0,0  1,0  2,0
          level   4    3    2    1

        Who passes each cell, with the slack before
          (1, 0)  A1, A2 (1)
          (2, 0)  A1, A2 (1)

        What if a robot is late?
        If A1 comes 3 steps late to (2, 0), 1 robot is pushed: A2 by 2 steps.
        The last robot arrives at 5, not at 3.
        This does not go well then: The battery of A2 is at -1 at time 5, below the floor of 0.
          arrives  planned   now
          A1             2     5  +3
          A2             3     5  +2"#]].assert_eq(said);
}

#[test]
fn programs_get_links_and_what_lateness_does() {
    let answer = order("row.json plan.json --changes changes.json --late A1@2,0+3");
    let links = &answer["order"]["links"];
    let first = json!({ "cell": [1, 0], "first": { "agent": "A1", "visit": 0, "time": 0 },
        "second": { "agent": "A2", "visit": 1, "time": 1 }, "gap": 0, "slack": 1 });
    assert_eq!(links[0], first);
    assert_eq!(answer["without_slack"], 0);
    let arrivals = json!([{ "agent": "A1", "planned": 2, "now": 5, "most": 3 },
        { "agent": "A2", "planned": 3, "now": 5, "most": 2 }]);
    assert_eq!(answer["late"]["arrivals"], arrivals);
    assert_eq!(answer["late"]["violations"][0]["rule"], "battery");
    let losses =
        json!([{ "loss": "battery", "agent": "A2", "spare": 1 }, { "loss": "changes", "last": 1 }]);
    assert_eq!(answer["losses"], losses);
    // Without a plan the scene is solved.
    let solved = order("row.json");
    assert_eq!(solved["costs"]["makespan"], 2);
    assert_eq!(solved["without_slack"], 2);
    assert!(solved["plan"].is_object());
}

#[test]
fn other_formats_go_to_standard_output() {
    let file = |format: &str| {
        let run = folder().run(&format!("order row.json plan.json --to {format}"));
        assert_eq!(
            run.err,
            "note: The battery of A2 bears 1 step of lateness.\n"
        );
        run.out
    };
    assert!(file("dot").starts_with("digraph order {\n"));
    expect![[r"
        agent,visit,column,row,x_m,y_m,arrives_s,leaves_s,heading_deg
        A1,0,1,0,3,1,0,0,0
        A1,1,2,0,5,1,0.5,0.5,0
        A1,2,3,0,7,1,1,,0
        A2,0,0,0,1,1,0,0.5,0
        A2,1,1,0,3,1,1,1,0
        A2,2,2,0,5,1,1.5,,0
    "]]
    .assert_eq(&file("csv"));
    let points: Value = serde_json::from_str(&file("waypoints")).unwrap();
    assert_eq!(points["waypoints"][1]["x"], 5.0);
    assert_eq!(points["units"], json!({ "cell": 2, "step": 0.5 }));
    let messages: Value = serde_json::from_str(&file("vda5050")).unwrap();
    assert_eq!(messages["orders"].as_array().unwrap().len(), 2);
    assert_eq!(
        messages["updates"][0]["after"],
        json!([{ "serialNumber": "A1", "sequenceId": 2 }])
    );
}

#[test]
fn what_cannot_be_is_refused() {
    let run = folder().run("order row.json crash.json");
    assert_eq!(run.exit, Some(1));
    assert!(run.err.contains("A1"), "{}", run.err);
    let run = folder().run("order row.json plan.json --late A9@(2,0)+3");
    assert!(
        run.err
            .contains("late[0].agent: found \"A9\", expected a robot of the plan"),
        "{}",
        run.err
    );
    let run = folder().run("order row.json plan.json --late A1");
    assert_eq!(run.exit, Some(2));
    assert!(
        run.err.contains("expected a robot, a cell and steps"),
        "{}",
        run.err
    );
}
