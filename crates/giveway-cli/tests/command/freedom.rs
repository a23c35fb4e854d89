//! `giveway freedom`.

use std::fs;

use expect_test::expect;
use giveway_proof::bundle::archive;
use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::{Folder, WAREHOUSE, WAREHOUSE_PLAN, two_agents};

/// Two robots that cross on a map of 4 x 2.
fn folder() -> Folder {
    Folder::with(&[
        ("two.json", two_agents(&[]).as_str()),
        ("warehouse.json", WAREHOUSE),
        ("plan.json", WAREHOUSE_PLAN),
    ])
}

/// What `--format json` writes, which must fit the schema.
fn freedom(folder: &Folder, line: &str) -> Value {
    let run = folder.run(&format!("freedom {line} --format json"));
    assert_eq!(run.err, "");
    let answer = serde_json::from_str(&run.out).unwrap();
    fits("freedomResult", &answer);
    answer
}

#[test]
fn all_parts_are_told() {
    let run = folder().run("freedom two.json");
    let (said, work) = run.answer().rsplit_once("\n\n").unwrap();
    assert!(work.contains("s CPU"));
    expect![[r#"
        two: 4 x 2 cells, 2 robots

        Optimal: makespan 6, sum of costs 10, 0 charges. There are 7 best plans.
        This holds no matter how many steps you allow.

           0  1  2  3
         0 .A .  ## .B
         1 .b .  .  .a
          # obstacle, A start, a goal
          A = A1, B = A2

        time   0    1    2    3    4    5    6
        A1   0,0  1,0  1,0  1,0  1,1  2,1  3,1
        A2   3,0  3,1  2,1  1,1  0,1

        Backbone: 7 of 10 steps are the same in every best plan.
          A1      3 of 6 steps; free in the steps from time 0, 1, 2
          A2      4 of 4 steps

        Best plans: There are 7 best plans.
          A1      7 ways
          A2      1 way
          7 × 1 = 7 best plans

        Slack:
          A1 has no step to spare somewhere on its way; it arrives no later in any best plan
          A2 has no step to spare somewhere on its way; it arrives no later in any best plan

        Critical cells: 3 cells cannot be closed without loss.
          Close (1, 0): no plan is left
          Close (1, 1): no plan is left
          Close (2, 1): no plan is left

        The most different best plan: Another best plan differs in 2 places. No best plan differs in more.
        time       0     1     2     3     4     5     6
        A1       0,0   1,0   1,0   1,0   1,1   2,1   3,1
          other  0,0  !0,1  !1,1   1,0   1,1   2,1   3,1
        A2       3,0   3,1   2,1   1,1   0,1
          other: what the robot does in the other plan; ! marks a difference
    "#]].assert_eq(&format!("{said}\n"));
}

#[test]
fn parts_that_are_named_are_told_alone() {
    let folder = folder();
    let answer = freedom(&folder, "warehouse.json --plan plan.json --backbone");
    assert_eq!(answer["status"], "optimal");
    assert_eq!(answer["about"], "given");
    let keys: Vec<&String> = answer.as_object().unwrap().keys().collect();
    for absent in [
        "plans", "slack", "critical", "farthest", "pending", "reason",
    ] {
        assert!(!keys.iter().any(|key| *key == absent), "{absent}");
    }
    assert_eq!(
        answer["backbone"]["A1"][0],
        json!({ "time": 0, "cell": answer["plan"]["paths"]["A1"][0], "always": true, "only": false })
    );
}

#[test]
fn plans_are_counted_up_to_a_number() {
    let folder = folder();
    let counted = |line: &str| {
        let plans = freedom(&folder, line)["plans"].clone();
        (plans["count"].clone(), plans["known"].clone())
    };
    assert_eq!(
        counted("two.json --count 6"),
        (json!(6), json!("more-than"))
    );
    assert_eq!(counted("two.json --count 7"), (json!(7), json!("exactly")));
    assert_eq!(
        counted("two.json --count 0"),
        (json!(0), json!("more-than"))
    );
}

#[test]
fn all_of_it_fits_the_schema() {
    let folder = folder();
    let answer = freedom(&folder, "two.json");
    assert_eq!(answer["plans"]["count"], 7);
    let cell = |at: Value| {
        let cells = answer["critical"].as_array().unwrap();
        let mut found = cells.iter().filter(|it| it["cell"] == at);
        found.next().unwrap().clone()
    };
    assert_eq!(cell(json!([1, 0]))["status"], "impossible");
    assert_eq!(cell(json!([0, 0]))["needed"], "start");
    let answer = freedom(&folder, "warehouse.json");
    assert_eq!(answer["complete"], true);
    fits("freedomResult", &freedom(&folder, "two.json --within 3"));
}

#[test]
fn without_time_all_is_said_to_be_open() {
    let folder = folder();
    let answer = freedom(&folder, "warehouse.json --time-limit 0.000001");
    assert_eq!(answer["status"], "unknown");
    assert!(answer.get("backbone").is_none());
    let run = folder.run("freedom warehouse.json --time-limit 0.000001");
    assert_eq!(run.exit, Some(3));
}

#[test]
fn a_plan_that_is_not_the_best_is_put_aside() {
    let folder = folder();
    let slow = r#"{ "giveway": 1, "paths": {
        "A1": [[0,0],[0,1],[1,1],[1,0],[1,0],[1,1],[2,1],[3,1]],
        "A2": [[3,0],[3,1],[3,1],[2,1],[1,1],[0,1]] } }"#;
    fs::write(folder.path("slow.json"), slow).unwrap();
    let run = folder.run("freedom two.json --plan slow.json --backbone");
    let about = "Your plan is not the best. This is about a better one.";
    assert!(run.answer().contains(about), "{}", run.out);
    let crash = r#"{ "giveway": 1, "paths": {
        "A1": [[0,0],[1,0],[1,1],[2,1],[3,1]],
        "A2": [[3,0],[3,1],[2,1],[1,1],[0,1]] } }"#;
    fs::write(folder.path("crash.json"), crash).unwrap();
    let run = folder.run("freedom two.json --plan crash.json");
    assert_eq!((run.exit, run.out.as_str()), (Some(1), ""));
}

#[test]
fn each_claim_has_a_certificate_of_its_own() {
    let folder = folder();
    let run = folder.run("freedom two.json --backbone --critical --proof shown");
    run.answer_but_for_notes();
    expect![[r#"
        shown: certificates, 13 claims with a proof, 3 claims with a search
    "#]]
    .assert_eq(&run.err);
    let mut names: Vec<String> = fs::read_dir(folder.path("shown"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    expect![[r#"
        best
        robot-1-at-3
        robot-1-at-4
        robot-1-at-5
        robot-1-at-6
        robot-2-at-1
        robot-2-at-2
        robot-2-at-3
        robot-2-at-4
        without-1-0
        without-1-1
        without-2-1
    "#]]
    .assert_eq(&(names.join("\n") + "\n"));
    let mut said = String::new();
    for name in names {
        let line = format!("verify shown/{name} --format json");
        let report = folder.run(&line).json();
        assert_eq!(report["accepted"], true, "{name}: {report}");
        assert_ne!(report["certified"], "not-certified", "{name}: {report}");
        said += report["conclusion"].as_str().unwrap();
        said.push('\n');
    }
    expect![[r#"
        Together: the plan is optimal, its costs compared in the order of the objective.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A1 is not at (1, 0) at time 3.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A1 is not at (1, 1) at time 4.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A1 is not at (2, 1) at time 5.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A1 is not at (3, 1) at time 6.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A2 is not at (3, 1) at time 1.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A2 is not at (2, 1) at time 2.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A2 is not at (1, 1) at time 3.
        Together: there is no plan with makespan at most 6, sum of costs at most 10 and charges at most 0 in which A2 is not at (0, 1) at time 4.
        Together: there is no plan.
        Together: there is no plan.
        Together: there is no plan.
    "#]].assert_eq(&said);
}

#[test]
fn all_certificates_are_verified_at_once_as_folders_and_as_an_archive() {
    let folder = folder();
    folder
        .run("freedom two.json --backbone --proof shown")
        .answer_but_for_notes();
    let run = folder.run("verify shown");
    assert_eq!(run.exit, Some(0), "{}", run.err);
    assert!(run.out.starts_with("best\nAccepted"), "{}", run.out);
    assert!(
        run.out.ends_with("9 of 9 certificates accepted.\n"),
        "{}",
        run.out
    );

    let mut bundles = archive::Bundles::new();
    for entry in fs::read_dir(folder.path("shown")).unwrap() {
        let entry = entry.unwrap();
        let files = fs::read_dir(entry.path()).unwrap().map(|file| {
            let file = file.unwrap();
            let name = file.file_name().into_string().unwrap();
            (name, fs::read(file.path()).unwrap())
        });
        let name = entry.file_name().into_string().unwrap();
        bundles.insert(name, files.collect());
    }
    let bytes = archive::pack(&bundles).unwrap();
    fs::write(folder.path("shown.zip"), &bytes).unwrap();
    let packed = folder.run("verify shown.zip");
    assert_eq!(packed.out, run.out);
    let json = folder.run("verify shown.zip --format json").json();
    assert_eq!(json["certificates"]["robot-1-at-3"]["accepted"], true);

    // One that was changed, a file that is none, an archive that was cut off.
    let plan = bundles
        .get_mut("best")
        .unwrap()
        .get_mut("plan.json")
        .unwrap();
    plan.push(b'\n');
    fs::write(folder.path("changed.zip"), archive::pack(&bundles).unwrap()).unwrap();
    let changed = folder.run("verify changed.zip");
    assert_eq!(changed.exit, Some(1), "{}", changed.out);
    assert!(
        changed.out.ends_with("8 of 9 certificates accepted.\n"),
        "{}",
        changed.out
    );
    fs::write(folder.path("cut.zip"), &bytes[..bytes.len() / 2]).unwrap();
    for none in ["cut.zip", "two.json"] {
        let run = folder.run(&format!("verify {none}"));
        assert_eq!((run.exit, run.out.as_str()), (Some(1), ""), "{none}");
        assert!(
            run.err.contains("a zip archive of certificates"),
            "{}",
            run.err
        );
    }
}

#[test]
fn a_changed_certificate_is_rejected() {
    let folder = folder();
    folder
        .run("freedom two.json --backbone --proof shown")
        .answer_but_for_notes();
    let drat = folder.path("shown/robot-1-at-3/no-plan.drat");
    let proof = fs::read_to_string(&drat).unwrap();
    fs::write(&drat, format!("{proof}1 0\n")).unwrap();
    assert_eq!(folder.run("verify shown/robot-1-at-3").exit, Some(1));
}
