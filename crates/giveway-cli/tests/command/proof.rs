//! `solve --proof` and `verify`.

use std::fs;

use expect_test::expect;

use crate::run::{Folder, SCENARIO_1, SCENARIO_6, WAREHOUSE, WAREHOUSE_PLAN};

fn folder() -> Folder {
    Folder::with(&[
        ("warehouse.json", WAREHOUSE),
        ("plan.json", WAREHOUSE_PLAN),
        ("scenario-1.json", SCENARIO_1),
        ("scenario-6.json", SCENARIO_6),
    ])
}

/// The text of a verification, without what may differ from version to version:
/// how large formulas and proofs are.
fn verified(folder: &Folder, dir: &str) -> String {
    let text = folder.run(&format!("verify {dir}")).answer().to_owned();
    // How many steps proofs have is not of interest here.
    let without = |line: &str| match line.split_once(" checked: ") {
        Some((proofs, steps)) => {
            let more = steps.split_once("steps").map(|(_, more)| more);
            format!("{proofs} checked{}", more.unwrap_or_default())
        }
        None => line.split(" (").next().unwrap_or_default().to_owned(),
    };
    let lines: Vec<String> = text.lines().map(without).collect();
    lines.join("\n")
}

#[test]
fn an_optimum_is_certified_cost_by_cost() {
    let folder = folder();
    let run = folder.run("solve warehouse.json --proof certificate --format json");
    assert_eq!(run.exit, Some(0));
    expect!["certificate: a certificate, 3 claims with a proof\n"].assert_eq(&run.err);
    expect![[r#"
        Accepted: every file is as it was written.
          proof          There is no plan with makespan at most 17.
          proof          There is no plan with makespan at most 18 and sum of costs at most 34.
          proof          There is no plan with makespan at most 18, sum of costs at most 35 and charges at most 2.
        Together: the plan is optimal, its costs compared in the order of the objective.
        Proved. 3 proofs were checked."#]]
    .assert_eq(&verified(&folder, "certificate"));
    let readme = folder.read("certificate/README.md");
    assert!(readme.contains("Together: the plan is optimal"), "{readme}");
    let json = folder.run("verify certificate --format json").json();
    assert_eq!(json["accepted"], true);
    assert_eq!(json["claims"][0]["kind"], "proof");
    assert_eq!(json["claims"][0]["claim"]["most"]["makespan"], 17);
}

#[test]
fn that_there_is_no_plan_rests_on_search_and_on_a_proof_up_to_a_makespan() {
    let folder = folder();
    let run = folder.run("solve scenario-6.json --proof certificate --quiet");
    assert_eq!((run.exit, run.err.as_str()), (Some(0), ""));
    expect![[r#"
        Accepted: every file is as it was written.
          search         There is no plan.
          proof          There is no plan of makespan at most 40.
        Together: there is no plan.
        Proved and searched. The proof was checked. 1 claim rests on a search, which was repeated."#]]
    .assert_eq(&verified(&folder, "certificate"));
}

/// Two robots in a corridor with a bay: one at a time in it, and no step of it free.
const RULED: &str = r##"{ "giveway": 1, "map": ["#..", "..."], "objective": ["makespan"],
    "zones": [{ "name": "bay", "rect": [1, 0, 2, 0] }],
    "constraints": [
        { "kind": "capacity", "zone": "bay", "most": 1, "name": "one_at a time" },
        { "kind": "gap", "steps": 1 },
        { "kind": "avoid", "zone": "bay", "weight": 2 },
        { "kind": "depart", "from": 9, "off": true }],
    "agents": [{ "name": "A1", "start": [0, 1], "goal": [2, 1] },
               { "name": "A2", "start": [2, 1], "goal": [0, 1] }] }"##;

#[test]
fn a_certificate_says_the_rules_of_the_scene_s_own() {
    let folder = Folder::with(&[("ruled.json", RULED)]);
    let run = folder.run("solve ruled.json --proof certificate --format json");
    assert_eq!(run.exit, Some(0), "{}", run.err);
    expect![[r#"
        Accepted: every file is as it was written.
          proof          There is no plan with makespan at most 3.
          proof          There is no plan with makespan at most 4 and penalty at most 3.
        Together: the plan is optimal, its costs compared in the order of the objective.
        Proved. 2 proofs were checked."#]]
    .assert_eq(&verified(&folder, "certificate"));
    let readme = folder.read("certificate/README.md");
    let (_, rules) = readme.split_once("## Rules").unwrap();
    let (rules, _) = rules.split_once("\n## ").unwrap();
    expect![[r#"
         of the scene's own

        Every plan keeps these as well. Rules that name a cost forbid nothing: what they cost is the penalty
        of a plan. A rule has the number of its place in the list of `instance.json`, from 0; rules that are
        off are not listed.

        - Rule 0: At most 1 robot in 'bay'. It is called `one_at a time`.
        - Rule 1: Each cell stays free for 1 step behind any robot.
        - Rule 2: Each step in 'bay' costs 2.
    "#]].assert_eq(rules);
    // Without the rule it is a certificate of another scene.
    let instance = folder.read("certificate/instance.json");
    let free = instance.replace("\"most\": 1", "\"most\": 2");
    assert_ne!(instance, free);
    fs::write(folder.path("certificate/instance.json"), free).unwrap();
    let run = folder.run("verify certificate");
    assert_eq!(run.exit, Some(1));
    expect![[r#"
        Rejected: instance.json: it was changed: its fingerprint differs.
        Not certified.
    "#]]
    .assert_eq(&run.out);
}

#[test]
fn what_was_changed_is_rejected() {
    let folder = folder();
    folder
        .run("solve scenario-1.json --proof certificate")
        .answer_but_for_notes();
    let drat = folder.path("certificate/makespan.drat");
    let mut proof = fs::read(&drat).unwrap();
    proof.push(b'\n');
    fs::write(&drat, proof).unwrap();
    let run = folder.run("verify certificate");
    assert_eq!((run.exit, run.err.as_str()), (Some(1), ""));
    expect![[r#"
        Rejected: makespan.drat: it was changed: its fingerprint differs.
        Not certified.
    "#]]
    .assert_eq(&run.out);
}

#[test]
fn a_folder_is_new_or_empty() {
    let folder = folder();
    folder.refuses(
        "solve scenario-1.json --proof .",
        &expect![[r#"
            exit 1
            .: found a folder with files in it, expected a new or an empty one
        "#]],
    );
    fs::create_dir(folder.path("empty")).unwrap();
    folder
        .run("solve scenario-1.json --proof empty")
        .answer_but_for_notes();
    assert!(verified(&folder, "empty").starts_with("Accepted"));
}

#[test]
fn what_is_no_certificate() {
    let folder = folder();
    let run = folder.run("verify nowhere");
    assert_eq!((run.exit, run.out.as_str()), (Some(1), ""));
    assert!(run.err.starts_with("nowhere: found "), "{}", run.err);
    let run = folder.run("verify .");
    assert_eq!(run.exit, Some(1));
    expect![[r#"
        Rejected: manifest.json: it is missing.
        Not certified.
    "#]]
    .assert_eq(&run.out);
}

#[test]
fn a_front_has_no_certificate() {
    let run = folder().run("solve warehouse.json --pareto --proof certificate");
    assert_eq!(run.exit, Some(2));
    assert!(run.err.contains("--pareto"), "{}", run.err);
}

/// What a question is answered with is certified, too.
#[test]
fn answers_to_questions_are_certified() {
    let folder = folder();
    folder
        .run("explain warehouse.json --plan plan.json makespan --proof sooner")
        .answer_but_for_notes();
    expect![[r#"
        Accepted: every file is as it was written.
          proof          There is no plan with makespan at most 17.
        Proved. The proof was checked."#]]
    .assert_eq(&verified(&folder, "sooner"));
    folder
        .run("explain warehouse.json --plan plan.json arrival A2 --within 20 --proof arrival")
        .answer_but_for_notes();
    // That it is so at any horizon takes a search that is too large: then the
    // certificate does not certify all that is claimed, and says so.
    let run = folder.run("verify arrival");
    assert_eq!(run.exit, Some(1));
    let text = run.out;
    assert!(
        text.contains(
            "Together: there is no plan of makespan at most 80 in which A2 arrives before time 18."
        ),
        "{text}"
    );
    assert!(text.ends_with("1 claim could not be checked.\n"), "{text}");
}

/// Checks that a certificate is refused since a file of it is no regular one.
#[cfg(unix)]
#[track_caller]
fn refused_as_no_file(folder: &Folder) {
    let run = folder.run("verify certificate");
    assert_eq!((run.exit, run.out.as_str()), (Some(1), ""));
    assert!(
        run.err
            .contains("found something other than a regular file"),
        "{}",
        run.err
    );
}

/// A folder of somebody else holds anything: what no certificate has is not even
/// read, and nothing in it is waited for.
#[cfg(unix)]
#[test]
fn only_regular_files_that_belong_to_it_are_read() {
    use std::os::unix::fs::symlink;
    let folder = folder();
    folder
        .run("solve scenario-1.json --proof certificate")
        .answer_but_for_notes();
    // A stranger, however large, is refused unread.
    symlink("/dev/zero", folder.path("certificate/more")).unwrap();
    let run = folder.run("verify certificate");
    assert_eq!(run.exit, Some(1));
    assert!(run.out.contains("more: it does not belong"), "{}", run.out);
    fs::remove_file(folder.path("certificate/more")).unwrap();
    // In the place of a file of its own stands a device, or a pipe.
    for name in ["plan.json", "makespan.cnf", "manifest.json"] {
        let file = folder.path(format!("certificate/{name}"));
        let bytes = fs::read(&file).unwrap();
        fs::remove_file(&file).unwrap();
        symlink("/dev/zero", &file).unwrap();
        refused_as_no_file(&folder);
        fs::remove_file(&file).unwrap();
        let made = std::process::Command::new("mkfifo").arg(&file).status();
        if made.is_ok_and(|made| made.success()) {
            let run = folder.run("verify certificate");
            assert_eq!((run.exit, run.out.as_str()), (Some(1), ""));
            fs::remove_file(&file).unwrap();
        }
        fs::write(&file, bytes).unwrap();
    }
    // So does a folder; and a name never leads out of the certificate.
    let file = folder.path("certificate/plan.json");
    let bytes = fs::read(&file).unwrap();
    fs::remove_file(&file).unwrap();
    fs::create_dir(&file).unwrap();
    refused_as_no_file(&folder);
    fs::remove_dir(&file).unwrap();
    fs::write(&file, bytes).unwrap();
    let manifest = folder.read("certificate/manifest.json");
    for name in ["../makespan", "/dev/zero", "."] {
        let named = manifest.replace("\"name\": \"makespan\"", &format!("\"name\": \"{name}\""));
        assert_ne!(named, manifest);
        fs::write(folder.path("certificate/manifest.json"), named).unwrap();
        let run = folder.run("verify certificate");
        assert_eq!(run.exit, Some(1));
        assert!(
            run.out.contains("its proofs have other names"),
            "{}",
            run.out
        );
    }
    fs::write(folder.path("certificate/manifest.json"), manifest).unwrap();
    let verified = verified(&folder, "certificate");
    assert!(verified.starts_with("Accepted: "), "{verified}");
}
