//! `giveway explain SCENE delays`: who costs whom.

use expect_test::expect;
use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::Folder;

/// A corridor with a bay.
const BAY: &str = r###"{ "giveway": 1, "name": "bay", "map": ["....", "#.##"],
  "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] },
             { "name": "A2", "start": [3, 0], "goal": [0, 0] }] }"###;

/// A plan in which one robot loses a step for nothing.
const LAZY: &str = r###"{ "giveway": 1, "paths": {
  "A1": [[0, 0], [1, 0], [1, 1], [1, 1], [1, 1], [1, 0], [2, 0], [3, 0]],
  "A2": [[3, 0], [3, 0], [2, 0], [1, 0], [0, 0]] } }"###;

/// What changes while that plan runs.
const CHANGES: &str = r###"{ "giveway": 1,
  "changes": [{ "at": 3, "change": "add-charger", "cell": [2, 0] }] }"###;

fn folder() -> Folder {
    Folder::with(&[
        ("bay.json", BAY),
        ("lazy.json", LAZY),
        ("changes.json", CHANGES),
    ])
}

fn delays(line: &str) -> Value {
    let run = folder().run(&format!("explain {line} --format json"));
    assert_eq!(run.err, "");
    let answer = serde_json::from_str(&run.out).unwrap();
    fits("delaysResult", &answer);
    answer
}

#[test]
fn who_costs_whom_is_told_in_rows() {
    let run = folder().run("explain bay.json delays");
    let (said, _) = run.answer().rsplit_once("\n\n").unwrap();
    expect![[r#"
        bay: 4 x 2 cells, 2 robots

        Who costs whom?
        2 steps are lost: alone the robots need 6 in all, here 8.
        No plan that is done at 5 loses less.
        This holds no matter how many steps you allow.

           0   1   2   3
         0 .Ab .   .   .Ba
         1 ### .   ### ###
          # obstacle, A start, a goal
          A = A1, B = A2

        time   0    1    2    3    4    5
        A1   0,0  1,0  1,1  1,0  2,0  3,0
        A2   3,0  2,0  1,0  0,0

        Who loses steps, because of whom on its best way alone
          A1     2  A2 (arrives at 5, alone at 3)
          1 robot loses nothing.

        Who costs others
          A2 2

        Where most is lost
          Most is lost at (1, 0): 2 steps (A1 2)."#]]
    .assert_eq(said);
    let answer = delays("bay.json delays");
    assert_eq!(answer["delay"], 2);
    assert_eq!(
        answer["agents"][0]["because"][0]["steps"],
        json!({ "numerator": 2, "denominator": 1 })
    );
    assert_eq!(answer["proof"]["at_least"], 2);
    assert_eq!(answer["proof"]["complete"], true);
}

#[test]
fn a_plan_of_ones_own_says_what_could_be_saved() {
    let run = folder().run("explain bay.json delays --plan lazy.json");
    let (said, _) = run.answer().rsplit_once("\n\n").unwrap();
    expect![[r#"
        bay: 4 x 2 cells, 2 robots

        Who costs whom?
        5 steps are lost: alone the robots need 6 in all, here 11.
        Another plan that is done at 7 loses 3 fewer.
        This holds no matter how many steps you allow.

           0   1   2   3
         0 .Ab .   .   .Ba
         1 ### .   ### ###
          # obstacle, A start, a goal
          A = A1, B = A2

        time   0    1    2    3    4    5    6    7
        A1   0,0  1,0  1,1  1,1  1,1  1,0  2,0  3,0
        A2   3,0  3,0  2,0  1,0  0,0

        Who loses steps, because of whom on its best way alone
          A1     4  A2 (arrives at 7, alone at 3)
          A2     1  nobody (arrives at 4, alone at 3)

        Who costs others
          A2 4, nobody 1

        Where most is lost
          Most is lost from (1, 0) to (1, 1): 4 steps (A1 4).
          Then at (3, 0): 1 step (A2 1)."#]]
    .assert_eq(said);
    let answer = delays("bay.json delays --plan lazy.json --changes changes.json");
    assert_eq!(answer["since"], 3);
    assert_eq!(
        (&answer["delay"], &answer["alone"]),
        (&json!(1), &json!(10))
    );
    assert_eq!(answer["agents"][0]["because"][0]["because"], "nobody");
}

#[test]
fn it_is_about_the_whole_plan() {
    let usage = |line: &str| {
        let run = folder().run(&format!("explain bay.json {line}"));
        assert_eq!(run.exit, Some(2), "{}", run.err);
        run.err
    };
    assert!(usage("delays A1").contains("it stands without other words"));
    assert!(usage("delays --at 1,0").contains("it stands without other words"));
    assert!(usage("delays --proof certificates").contains("--proof is not for the question"));
}
