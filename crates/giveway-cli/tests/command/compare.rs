//! `giveway compare`.

use expect_test::expect;
use serde_json::{Value, json};

use crate::run::{Folder, two_agents};

fn folder() -> Folder {
    let plan = |one: &str, other: &str| {
        format!(r#"{{ "giveway": 1, "paths": {{ "A1": {one}, "A2": {other} }} }}"#)
    };
    let first = plan(
        "[[0,0],[0,1],[1,1],[2,1],[3,1]]",
        "[[3,0],[3,1],[2,1],[1,1],[0,1]]",
    );
    let second = plan(
        "[[0,0],[1,0],[1,1],[2,1],[3,1]]",
        "[[3,0],[3,0],[3,1],[2,1],[1,1],[0,1]]",
    );
    Folder::with(&[
        ("two.json", two_agents(&[])),
        ("first.json", first),
        ("second.json", second),
    ])
}

#[test]
fn plans_stand_side_by_side() {
    let run = folder().run("compare two.json first.json second.json");
    expect![[r#"
        two: 4 x 2 cells, 2 robots

                         first.json  second.json  difference
        legal           1 violation  1 violation
        makespan                  4            5          +1
        sum of costs              8            9          +1
        charges                   0            0           0
        moves                     8            8           0
        waits                     0            1          +1

        2 robots: 0 the same, 1 retimed, 1 rerouted.
          A1 is rerouted: at time 1 it is at (0, 1) in the first plan and at (1, 0) in the second; it arrives at time 4 in both.
          A2 is retimed: at time 1 it is at (3, 1) in the first plan and at (3, 0) in the second; it arrives at time 4 and at time 5.
    "#]].assert_eq(run.answer());
}

#[test]
fn programs_get_an_object() {
    let run = folder().run("compare two.json first.json second.json --format json");
    let answer = run.json();
    let mut schema: Value = serde_json::from_str(giveway_model::format::schema()).unwrap();
    schema.as_object_mut().unwrap().remove("anyOf");
    schema["$ref"] = json!("#/$defs/compareResult");
    let validator = jsonschema::draft202012::new(&schema).unwrap();
    assert!(validator.is_valid(&answer), "{answer}");
    assert_eq!(answer["plans"][1]["file"], "second.json");
    assert_eq!(answer["agents"][0]["difference"], "rerouted");
    assert_eq!(answer["agents"][1]["difference"], "retimed");
    assert_eq!(answer["deltas"]["sum-of-costs"], 1);
}

#[test]
fn two_plans_are_needed() {
    folder().refuses(
        "compare two.json first.json",
        &expect![[r#"
        exit 2
        error: found 1 plan, expected two plans

        Usage: giveway [OPTIONS] <COMMAND>

        For more information, try '--help'.
    "#]],
    );
}
