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
    expect![[r#""#]].assert_eq(said);
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
fn rules_that_leave_no_plan_are_told_with_what_helps() {
    let run = folder().run_words(&[
        "price",
        "feeder.json",
        "--constraint",
        "each robot arrives by 8",
    ]);
    let (said, _) = run.answer().rsplit_once("\n\n").unwrap();
    expect![[r#""#]].assert_eq(said);
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
        wrong.contains("--constraint: zone: found \"attic\""),
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
    assert_eq!(in_file.answer(), asked.answer());
    let (said, _) = asked.answer().rsplit_once("\n\n").unwrap();
    expect![[r#""#]].assert_eq(said);
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
