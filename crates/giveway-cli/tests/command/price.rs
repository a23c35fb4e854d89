//! `giveway price`, rules of one call, and questions about rules.

use expect_test::expect;
use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::Folder;

/// The feeder of docs/rules.md.
const FEEDER: &str = r###"{ "giveway": 1, "name": "feeder",
  "map": [".......", "##.#.##", "##.#.##", "##.#.##", "......."],
  "agents": [{ "name": "A1", "start": [0, 0], "goal": [0, 4] },
             { "name": "A2", "start": [1, 0], "goal": [3, 4] },
             { "name": "A3", "start": [6, 4], "goal": [5, 0] }],
  "zones": [{ "name": "feeder", "rect": [2, 1, 2, 3] }],
  "constraints": [{ "kind": "capacity", "zone": "feeder", "most": 1, "name": "narrow" },
                  { "kind": "one-way", "lane": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]] }] }"###;

fn folder() -> Folder {
    let deadline = r#"{ "kind": "arrive", "by": 8 }"#;
    Folder::with(&[("feeder.json", FEEDER), ("deadline.json", deadline)])
}

fn price(line: &str) -> Value {
    let run = folder().run(&format!("price {line} --format json"));
    assert_eq!(run.err, "");
    let answer = serde_json::from_str(&run.out).unwrap();
    fits("priceResult", &answer);
    answer
}

#[test]
fn each_rule_has_its_price() {
    let run = folder().run("price feeder.json");
    let (said, _) = run.answer().rsplit_once("\n\n").unwrap();
    expect![[r#"
        note: 2 rules of the scene's own: At most 1 robot in 'feeder'; One way from (0, 0) to (5, 0).

        feeder: 7 x 5 cells, 3 robots

        Optimal with all rules: makespan 10, sum of costs 23, 0 charges.
        This holds no matter how many steps you allow.

           0  1  2  3  4  5  6
         0 .A .B .  .  .  .c .
         1 ## ## .  ## .  ## ##
         2 ## ## .  ## .  ## ##
         3 ## ## .  ## .  ## ##
         4 .a .  .  .b .  .  .C
          # obstacle, A start, a goal
          A = A1, B = A2, C = A3

        time   0    1    2    3    4    5    6    7    8    9   10
        A1   0,0  1,0  2,0  2,0  2,0  2,1  2,2  2,3  2,4  1,4  0,4
        A2   1,0  2,0  2,1  2,2  2,3  2,4  3,4
        A3   6,4  5,4  4,4  4,3  4,2  4,1  4,0  5,0

        Rules
          narrow: At most 1 robot in 'feeder': costs 2 steps of the makespan
            without it: makespan 8, sum of costs 21, 0 charges
          One way from (0, 0) to (5, 0): costs nothing"#]].assert_eq(said);
    let answer = price("feeder.json");
    assert_eq!(answer["status"], "optimal");
    assert_eq!(answer["prices"][0]["price"], "costs");
    assert_eq!(answer["prices"][0]["name"], "narrow");
    assert_eq!(
        answer["prices"][0]["difference"],
        json!({ "makespan": 2, "sum-of-costs": 2, "charges": 0 })
    );
    assert_eq!(answer["conflict"], Value::Null);
}

#[test]
fn a_rule_is_loosened_by_the_least_that_changes_the_costs() {
    let answer = price("feeder.json --loosen 0");
    assert_eq!(answer["prices"].as_array().unwrap().len(), 1);
    let loosened = &answer["loosened"];
    assert_eq!(loosened["settled"], true);
    let looser = &loosened["looser"][0];
    assert_eq!(looser["rule"]["most"], 2);
    assert_eq!(
        (&looser["least"], &looser["exact"]),
        (&json!(true), &json!(true))
    );
    assert_eq!(looser["costs"]["makespan"], 8);
    assert_eq!(looser["difference"]["makespan"], 2);
    let run = folder().run("price feeder.json --loosen 0");
    let said = "Loosened by the least that helps: At most 2 robots in 'feeder'. Then makespan 8, sum of costs 21";
    assert!(run.answer().contains(said), "{}", run.answer());
    let run = folder().run("price feeder.json --loosen 1");
    let said = "This rule has no number and no times to loosen.";
    assert!(run.answer().contains(said), "{}", run.answer());
    let run = folder().run("price feeder.json --loosen 7");
    assert!(
        run.err.contains("the number of a rule that is in force"),
        "{}",
        run.err
    );
}

#[test]
fn rules_that_leave_no_plan_are_told_with_what_helps() {
    let run = folder().run_words(&[
        "price",
        "feeder.json",
        "--constraint",
        "each robot arrives by 8",
    ]);
    let (said, _) = run.answer().rsplit_once("\n\n").unwrap();
    expect![[r#"
        note: Rule: Each robot arrives by 8 (--constraint).
        note: 3 rules of the scene's own: At most 1 robot in 'feeder'; One way from (0, 0) to (5, 0); Each robot arrives by 8.

        feeder: 7 x 5 cells, 3 robots

        No plan with all rules.
        A1, A2 and A3 cannot all arrive.
        This holds no matter how many steps you allow.

           0  1  2  3  4  5  6
         0 .A .B .  .  .  .c .
         1 ## ## .  ## .  ## ##
         2 ## ## .  ## .  ## ##
         3 ## ## .  ## .  ## ##
         4 .a .  .  .b .  .  .C
          # obstacle, A start, a goal
          A = A1, B = A2, C = A3

        Rules
          narrow: At most 1 robot in 'feeder': no plan with it
            without it: makespan 8, sum of costs 21, 0 charges
          One way from (0, 0) to (5, 0): no plan without it, either
          Each robot arrives by 8: no plan with it
            without it: makespan 10, sum of costs 23, 0 charges

        These facts together rule it out:
          - A1 must go from (0, 0) to (0, 4)
          - A2 must go from (1, 0) to (3, 4)
          - A3 must go from (6, 4) to (5, 0)
          - (0, 1) is an obstacle
          - (1, 1) is an obstacle
          - (3, 2) is an obstacle
          - (5, 1) is an obstacle
          - (6, 2) is an obstacle
          - A2 and A3 must not collide
          - The rule 'narrow': "At most 1 robot in 'feeder'"
          - The rule "Each robot arrives by 8"
        These facts alone rule it out, and each of them is needed for that. Leaving out only one of the others does not help, since other facts rule it out, too.
        There is a plan without the rule 'narrow' or the rule "Each robot arrives by 8"."#]].assert_eq(said);
}

#[test]
fn a_rule_of_one_call_is_kept_and_told() {
    let rule = r#"{"kind":"depart","from":3,"agents":["A3"]}"#;
    let run = folder().run_words(&["solve", "feeder.json", "--constraint", rule]);
    assert!(
        run.out
            .contains("Rule: A3 starts from 3 on (--constraint)."),
        "{}",
        run.out
    );
    assert!(run.out.contains("Optimal"), "{}", run.out);
    let usage = |rule: &str| {
        let run = folder().run_words(&["solve", "feeder.json", "--constraint", rule]);
        assert_eq!(run.exit, Some(2), "{}", run.err);
        run.err
    };
    let wrong = usage("no robot in 'attic'");
    assert!(
        wrong.contains("--constraint: zone: found the unknown zone \"attic\""),
        "{wrong}"
    );
    let wrong = usage("no robot in the feeder");
    assert!(
        wrong.contains("found \"the\", expected the name of a zone in single quotes"),
        "{wrong}"
    );
    let wrong = usage(r#"{"kind":"depart"}"#);
    assert!(
        wrong.contains("--constraint: missing field `from`"),
        "{wrong}"
    );
}

#[test]
fn questions_name_a_rule_in_words_or_in_a_file() {
    let asked = folder().run_words(&["explain", "feeder.json", "rule", "each robot arrives by 8"]);
    let in_file = folder().run("explain feeder.json rule --rule deadline.json");
    let told = |run: &crate::run::Run| run.answer().rsplit_once("\n\n").unwrap().0.to_owned();
    assert_eq!(told(&in_file), told(&asked));
    let said = told(&asked);
    expect![[r#"
        note: 2 rules of the scene's own: At most 1 robot in 'feeder'; One way from (0, 0) to (5, 0).

        feeder: 7 x 5 cells, 3 robots

        Why is it not so: "Each robot arrives by 8"? (rule "Each robot arrives by 8")
        Necessary: There is no plan in which this rule holds: "Each robot arrives by 8". These facts together rule it out: A1 must go from (0, 0) to (0, 4); A2 must go from (1, 0) to (3, 4); A3 must go from (6, 4) to (5, 0); (0, 1) and (1, 1), (5, 1), (3, 2) and (6, 2) are obstacles; A2 and A3 must not collide; the rule 'narrow': "At most 1 robot in 'feeder'". It would help to raise the limit of the rule 'narrow' to 2: makespan 8, sum of costs 21.
        This holds no matter how many steps you allow.

           0  1  2  3  4  5  6
         0 .A .B .  .  .  .c .
         1 ## ## .  ## .  ## ##
         2 ## ## .  ## .  ## ##
         3 ## ## .  ## .  ## ##
         4 .a .  .  .b .  .  .C
          # obstacle, A start, a goal
          A = A1, B = A2, C = A3

        time   0    1    2    3    4    5    6    7    8    9   10
        A1   0,0  1,0  2,0  2,0  2,0  2,1  2,2  2,3  2,4  1,4  0,4
        A2   1,0  2,0  2,1  2,2  2,3  2,4  3,4
        A3   6,4  5,4  4,4  4,3  4,2  4,1  4,0  5,0

        These facts together rule it out:
          1 A1 must go from (0, 0) to (0, 4) (needed; would help)
          2 A2 must go from (1, 0) to (3, 4) (needed; would help)
          3 A3 must go from (6, 4) to (5, 0) (needed; would help)
          4 A2 and A3 must not collide (needed; would help)
          5 the rule 'narrow': "At most 1 robot in 'feeder'" (needed; would help)
          6 the aisle from (2, 1) to (2, 3) (3 facts; needed)
          7 the shelf at (5, 1) and (6, 2) (2 facts; needed)
        These facts alone rule it out, and each of them is needed for that. Leaving out only one of the others does not help, since other facts rule it out, too.

        What would help:
          Raise the limit of the rule 'narrow' to 2: makespan 8, sum of costs 21.
          Switch off the rule 'narrow': makespan 8, sum of costs 21.
          Leave A1 out: makespan 7, sum of costs 13.
          Remove the obstacle at (3, 1) and remove the obstacle at (3, 2): makespan 8, sum of costs 23.
          Leave A2 out: makespan 8, sum of costs 15.
          Leave A3 out: makespan 8, sum of costs 16.
          Remove the obstacle at (5, 1) and remove the obstacle at (5, 2): makespan 8, sum of costs 23."#]].assert_eq(&said);
    let folder_with_proof = folder();
    let line = "explain feeder.json rule --rule deadline.json --proof shown";
    assert_eq!(folder_with_proof.run(line).exit, Some(0));
    let checked = folder_with_proof.run("verify shown");
    assert_eq!(checked.exit, Some(0), "{}", checked.out);
    assert!(checked.out.contains("this rule holds"), "{}", checked.out);
    let so = folder().run_words(&["explain", "feeder.json", "rule", "each robot arrives by 10"]);
    assert_eq!(so.exit, Some(1));
    assert!(
        so.err.contains("It is so: this plan keeps the rule"),
        "{}",
        so.err
    );
    let so = folder().run_words(&[
        "explain",
        "feeder.json",
        "rule",
        "at most 1 robot in 'feeder'",
    ]);
    assert!(
        so.err.contains("It is so: the scene has this rule"),
        "{}",
        so.err
    );
    let free = folder().run_words(&[
        "explain",
        "feeder.json",
        "rule",
        "each step in 'feeder' costs 2",
    ]);
    assert!(free.err.contains("forbids nothing"), "{}", free.err);
}
