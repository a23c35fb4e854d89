//! `giveway check`.

use expect_test::expect;

use crate::run::{Folder, SCENARIO_1, WAREHOUSE, WAREHOUSE_PLAN};

fn folder() -> Folder {
    let broken = WAREHOUSE_PLAN.replace("\"A1\": [9]", "\"A1\": [8]");
    Folder::with(&[
        ("warehouse.json", WAREHOUSE),
        ("plan.json", WAREHOUSE_PLAN),
        ("broken.json", &broken),
        ("scenario-1.json", SCENARIO_1),
    ])
}

#[test]
fn the_printed_plan_has_the_printed_batteries() {
    expect![[r#"
        warehouse: 10 x 3 cells, 2 robots

        Valid: makespan 18, sum of costs 35, 3 charges, 30 moves, 0 waits.

           0   1   2   3   4   5   6   7   8   9
         0 .Ab .   ~a' ~   ~   ~b' ~   ~a' .   .
         1 .   ### ### .   ### ### .   ### ### .
         2 .   .b' .   +   .a' .   +   .   .   .Ba
          # obstacle, ~ slow zone, + charger, A start, a goal, a' waypoint
          A = A1, B = A2

        time      0    1    2    3    4    5    6    7    8    9
        A1      0,0  1,0  2,0   ..  3,0  3,1  3,2  4,2  5,2  6,2
          level  10    9    8    7    6    5    4    3    2    1*
        A2      9,2  8,2  7,2  6,2  6,1  6,0   ..  5,0   ..  4,0
          level   8    7    6    5*  10    9    8    7    6    5

        time     10   11   12   13   14   15   16   17   18
        A1      6,1  6,0   ..  7,0  8,0  9,0  9,1  9,2
          level  10    9    8    7    6    5    4    3
        A2       ..  3,0  3,1  3,2  2,2  1,2  0,2  0,1  0,0
          level   4    3    2    1*  10    9    8    7    6
          .. in transit on a slow move, * charges
    "#]]
    .assert_eq(folder().run("check warehouse.json plan.json").answer());
}

#[test]
fn a_broken_plan_is_told_and_ends_with_1() {
    let run = folder().run("check warehouse.json broken.json");
    assert_eq!((run.exit, run.err.as_str()), (Some(1), ""));
    let told: Vec<&str> = run.out.lines().skip(2).take(4).collect();
    expect![[r#"
        Not valid: 2 violations.
          charge: A1 charges at time 8, but there is no charger at (5, 2).
          battery: The battery of A1 is at -1 at time 11, below the floor of 0.
        Costs of the plan: makespan 18, sum of costs 35, 3 charges, 30 moves, 0 waits."#]]
    .assert_eq(&told.join("\n"));
}

#[test]
fn json_has_the_verdict() {
    let run = folder().run("check warehouse.json broken.json --format json");
    assert_eq!((run.exit, run.err.as_str()), (Some(1), ""));
    expect![[r#"
        {
          "giveway": 1,
          "valid": false,
          "costs": {
            "makespan": 18,
            "sum-of-costs": 35,
            "charges": 3,
            "moves": 30,
            "waits": 0
          },
          "violations": [{
            "rule": "charge",
            "agents": ["A1"],
            "cell": [5, 2],
            "time": 8,
            "message": "A1 charges at time 8, but there is no charger at (5, 2)."
          }, {
            "rule": "battery",
            "agents": ["A1"],
            "cell": [6, 0],
            "time": 11,
            "message": "The battery of A1 is at -1 at time 11, below the floor of 0."
          }]
        }
    "#]]
    .assert_eq(&run.out);
}

#[test]
fn a_result_with_a_plan_is_a_plan() {
    let result = format!(r#"{{ "giveway": 1, "status": "optimal", "plan": {WAREHOUSE_PLAN} }}"#);
    let run = folder().run_with("check warehouse.json -", &result);
    assert!(run.answer().contains("Valid"), "{}", run.out);
}

#[test]
fn a_fault_in_the_plan_of_a_result_has_its_line() {
    let result = "{ \"status\": \"optimal\",\n  \"plan\": { \"giveway\": 1, \"path\": {} } }";
    let run = folder().run_with("check warehouse.json -", result);
    expect![[r#"
        exit 1
        standard input: line 2, column 27: found the unknown key "path", expected one of giveway, paths, charges, from, until, knows, slept
    "#]].assert_eq(&run.refusal());
}

#[test]
fn a_result_without_a_plan() {
    let run = folder().run_with(
        "check warehouse.json -",
        r#"{ "status": "impossible", "plan": null }"#,
    );
    expect![[r#"
        exit 1
        standard input: line 1, column 1: found a result that says that there is no plan (impossible), expected a plan
    "#]]
    .assert_eq(&run.refusal());
}

#[test]
fn an_instance_instead_of_a_plan() {
    folder().refuses("check warehouse.json scenario-1.json", &expect![[r#"
        exit 1
        scenario-1.json: line 1, column 1: found an instance, with "map" and "agents", expected a plan, with "paths"
    "#]]);
}
