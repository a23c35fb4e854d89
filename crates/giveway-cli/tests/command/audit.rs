//! `giveway audit`.

use std::fs;
use std::path::PathBuf;

use expect_test::expect;
use serde_json::{Value, json};

use crate::run::{EMPTY_MAP, EMPTY_SCEN, Folder, WAREHOUSE, WAREHOUSE_PLAN, two_agents};

fn plan(one: &str, other: &str) -> String {
    format!(r#"{{ "giveway": 1, "paths": {{ "A1": {one}, "A2": {other} }} }}"#)
}

/// Two robots that cross on a map of 4 x 2, and plans for them.
pub(crate) fn folder() -> Folder {
    let best = plan(
        "[[0,0],[1,0],[1,1],[2,1],[3,1]]",
        "[[3,0],[3,0],[3,1],[2,1],[1,1],[0,1]]",
    );
    let scene = two_agents(&[]);
    Folder::with(&[
        ("warehouse.json", WAREHOUSE),
        ("warehouse.plan.json", WAREHOUSE_PLAN),
        ("two.json", scene.as_str()),
        ("crash.json", best.as_str()),
        (
            "slow.json",
            &plan(
                "[[0,0],[0,1],[1,1],[1,1],[2,1],[2,1],[3,1]]",
                "[[3,0],[3,1],[3,1],[2,1]]",
            ),
        ),
    ])
}

/// What `--format json` writes, which must fit the schema.
fn audit(folder: &Folder, line: &str) -> (Option<i32>, Value) {
    let run = folder.run(&format!("audit {line} --format json"));
    assert_eq!(run.err, "");
    let answer = serde_json::from_str(&run.out).unwrap();
    fits("auditResult", &answer);
    (run.exit, answer)
}

/// Holds a value against a definition of the schema.
pub(crate) fn fits(definition: &str, value: &Value) {
    let schema: Value = serde_json::from_str(giveway_model::format::schema()).unwrap();
    let mut schema = schema;
    schema.as_object_mut().unwrap().remove("anyOf");
    schema["$ref"] = json!(format!("#/$defs/{definition}"));
    let validator = jsonschema::draft202012::new(&schema).unwrap();
    let result = validator.validate(value);
    assert!(result.is_ok(), "{result:?}");
}

#[test]
fn the_best_plan_is_proved_to_be_it() {
    let run = folder().run("audit warehouse.json warehouse.plan.json");
    let (said, work) = run.answer().rsplit_once("\n\n").unwrap();
    assert!(work.contains("s CPU"));
    expect![[r#"
        warehouse: 10 x 3 cells, 2 robots

        Recognised as
          file    warehouse.plan.json
          format  Giveway's own JSON, as Giveway writes it (giveway)
          map     warehouse, 10 x 3 cells
          robots  2

        The best: proved.

        cost                  this plan  proved at least
        makespan                     18               18
        sum of costs                 35               35
        charges                       3                3
        moves                        30                -
        waits                         0                -
    "#]]
    .assert_eq(&format!("{said}\n"));
}

#[test]
fn a_plan_that_is_not_the_best_is_so_far_from_it() {
    let folder = folder();
    let line = "warehouse.json long.json";
    let mut long: Value = serde_json::from_str(WAREHOUSE_PLAN).unwrap();
    let path = long["paths"]["A2"].as_array_mut().unwrap();
    // It waits where it charges, so that its battery lasts.
    path.insert(4, json!([6, 2]));
    long["charges"]["A2"] = json!([4, 14]);
    fs::write(folder.path("long.json"), long.to_string()).unwrap();
    let (exit, answer) = audit(&folder, line);
    assert_eq!(
        (exit, &answer["status"]),
        (Some(0), &json!("feasible")),
        "{answer}"
    );
    assert_eq!(answer["legal"], true);
    assert_eq!(answer["search"], "optimal");
    let own = answer["costs"]["makespan"].as_f64().unwrap();
    let best = answer["better_costs"]["makespan"].as_f64().unwrap();
    assert_eq!(answer["gap"].as_f64(), Some((own - best) / best));
    let text = folder.run(&format!("audit {line}"));
    assert!(
        text.answer().contains("5.6 % above the best"),
        "{}",
        text.out
    );
}

#[test]
fn an_illegal_plan_has_every_violation_and_costs_as_it_stands() {
    let folder = folder();
    let (exit, answer) = audit(&folder, "two.json crash.json");
    assert_eq!((exit, &answer["status"]), (Some(1), &json!("illegal")));
    assert_eq!(answer["violations"][0]["rule"], "vertex");
    assert_eq!(answer["costs"]["sum-of-costs"], 9);
    assert_eq!(answer["gap"], Value::Null);
    assert!(answer["better"].is_object());
    let run = folder.run("audit two.json crash.json --objective sum-of-costs");
    assert_eq!(run.exit, Some(1));
    let (_, said) = run.out.split_once("Illegal").unwrap();
    let (said, _) = said.rsplit_once("\n\n").unwrap();
    expect![[r#"
        Illegal: 1 violation of the rules.
          vertex: A1 and A2 are both at (2, 1) at time 3.
        Its sum of costs is 9, and every legal plan has at least 10. So it had to break a rule.
        A legal plan was found: sum of costs 10; it is the best: proved.
        Robots that go another way in the legal plan: 0; the same way at other times: 2; that do the same: 0.

        cost                  this plan  proved at least      better plan
        sum of costs                  9               10               10
        makespan                      5                -                6
        charges                       0                -                0
        moves                         8                -                8
        waits                         1                -                2
    "#]].assert_eq(&format!("Illegal{said}\n"));
}

#[test]
fn every_kind_of_violation_is_found() {
    let cases = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../giveway-model/tests/plans");
    let mut rules = std::collections::BTreeSet::new();
    for entry in fs::read_dir(cases.join("broken")).unwrap() {
        let text = fs::read_to_string(entry.unwrap().path()).unwrap();
        let case: Value = serde_json::from_str(&text).unwrap();
        let folder = Folder::with(&[
            ("scene.json", case["instance"].to_string()),
            ("plan.json", case["plan"].to_string()),
        ]);
        let (exit, answer) = audit(&folder, "scene.json plan.json");
        assert_eq!(
            (exit, &answer["status"]),
            (Some(1), &json!("illegal")),
            "{case}"
        );
        let found = answer["violations"].as_array().unwrap();
        let expected = case["violations"].as_array().unwrap();
        assert_eq!(found.len(), expected.len(), "{case}");
        for (found, expected) in found.iter().zip(expected) {
            assert_eq!(found["rule"], expected["rule"], "{case}");
            rules.insert(found["rule"].to_string());
        }
    }
    assert!(rules.len() >= 10, "{rules:?}");
}

#[test]
fn a_scenario_finds_its_map_beside_it() {
    let folder = Folder::with(&[("few.scen", EMPTY_SCEN), ("empty-8-8.map", EMPTY_MAP)]);
    let solved = folder.run("solve few.scen --format json --objective makespan");
    fs::write(folder.path("solved.json"), solved.answer()).unwrap();
    let (exit, answer) = audit(&folder, "few.scen solved.json --objective makespan");
    assert_eq!((exit, &answer["status"]), (Some(0), &json!("optimal")));
    assert_eq!(answer["agents"], 8);
    fs::create_dir(folder.path("maps")).unwrap();
    fs::rename(folder.path("empty-8-8.map"), folder.path("maps/other.map")).unwrap();
    folder.refuses(
        "audit few.scen solved.json",
        &expect![[r#"
        exit 1
        few.scen is for the map empty-8-8: open empty-8-8.map, too. Or give it with --map.
    "#]],
    );
    let found = folder.run("audit few.scen solved.json --map maps/other.map");
    assert!(found.answer().contains("robots"));
}

#[test]
fn files_that_do_not_belong_together_are_refused() {
    let folder = folder();
    folder.refuses(
        "audit two.json",
        &expect![[r#"
        exit 1
        There is no plan in these files.
    "#]],
    );
    folder.refuses(
        "audit crash.json",
        &expect![[r#"
        exit 1
        There is no scene in these files.
    "#]],
    );
    folder.refuses(
        "audit two.json warehouse.json crash.json",
        &expect![[r#"
            exit 1
            Open one scene at a time: two.json and warehouse.json are of the same kind.
        "#]],
    );
    folder.refuses("audit two.json crash.json slow.json", &expect![[r#"
        exit 2
        error: found 2 plans, expected one; --jsonl audits each of them, and giveway compare compares two

        Usage: giveway [OPTIONS] <COMMAND>

        For more information, try '--help'.
    "#]]);
    folder.refuses(
        "audit two.json crash.json --report r.txt",
        &expect![[r#"
            exit 2
            error: found the report r.txt, expected a name that ends in .html, .md or .json

            Usage: giveway [OPTIONS] <COMMAND>

            For more information, try '--help'.
        "#]],
    );
}

#[test]
fn a_plan_from_standard_input_is_audited_too() {
    let folder = folder();
    let run = folder.run_with("audit warehouse.json - --format json", WAREHOUSE_PLAN);
    assert_eq!(run.json()["status"], "optimal");
}
