//! `giveway sweep` with planners of others, and `giveway table --show planners`.

use std::fs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use expect_test::expect;

use crate::run::{EMPTY_MAP, EMPTY_SCEN, Folder, command};

/// A planner that works: it asks the command itself for a plan of its own, by prioritised
/// planning. The others fail, each in its own way.
const SPEC: &str = r#"
    objectives = ["sum-of-costs,makespan"]
    time-limit = 100
    clock = "cpu"
    [[instances]]
    files = ["empty-8-8.scen"]
    agents = [2, 4]
    [[planner]]
    name = "works"
    about = "prioritised"
    command = "sh -c 'GIVEWAY solve \"$0\" --agents \"$1\" --planner prioritised --objective sum-of-costs --format json -q >\"$2\"' {scen} {agents} {out}"
    [[planner]]
    name = "crashes"
    command = "sh -c 'echo no luck >&2; exit 3' {map} {out}"
    [[planner]]
    name = "silent"
    command = "true {map} {out}"
    [[planner]]
    name = "lies"
    command = "sh -c 'GIVEWAY solve \"$0\" --agents \"$1\" --planner prioritised --format json -q >plan.json; GIVEWAY convert --to result.txt -o made \"$0\" plan.json; sed s/^soc=/soc=1/ made/plan-result.txt >\"$2\"' {scen} {agents} {out}"
"#;

fn folder() -> Folder {
    let spec = SPEC.replace("GIVEWAY", env!("CARGO_BIN_EXE_giveway"));
    Folder::with(&[
        ("spec.toml", spec.as_str()),
        ("empty-8-8.map", EMPTY_MAP),
        ("empty-8-8.scen", EMPTY_SCEN),
    ])
}

#[test]
fn planners_are_judged_once_and_set_beside_the_proof() {
    let folder = folder();
    let run = folder.run("sweep spec.toml");
    assert_eq!(run.exit, Some(0), "{}", run.err);
    assert!(
        run.out
            .starts_with("10 tasks: 2 optimal, 2 feasible, 6 failed.\n"),
        "{}{}",
        run.out,
        run.err
    );
    assert!(
        run.err.contains("planner=crashes") && run.err.contains(": no luck"),
        "{}",
        run.err
    );
    let again = folder.run("sweep spec.toml");
    assert_eq!((again.out, again.err.as_str()), (run.out, ""));
    // Another command is another task; the rest stays.
    let spec = folder.read("spec.toml").replace("no luck", "still no luck");
    fs::write(folder.path("spec.toml"), spec).unwrap();
    assert_eq!(folder.run("sweep spec.toml").err.lines().count(), 2);

    let table = folder.run("table spec-results --show planners --to csv");
    let lines: Vec<&str> = table.answer().lines().collect();
    assert!(
        lines.iter().any(|line| line.contains(",prioritised,2,2,")),
        "{}",
        table.out
    );
    let text = folder.run("table spec-results --show planners");
    for expected in [
        "2 of 2 are proved best.",
        "- crashed: crashes, empty-8-8.scen, 2 robots: exit 3 after ",
        "- wrong cost: lies, ",
        "- nothing: silent, empty-8-8.scen, 2 robots: wrote no plan\n",
    ] {
        assert!(text.answer().contains(expected), "{expected}\n{}", text.out);
    }
    let html = folder.run("table spec-results --show planners --to html");
    assert!(html.answer().starts_with("<!doctype html>"));
    let svg = folder.run("table spec-results --show planners --to svg");
    assert!(svg.answer().starts_with("<svg"));
    let rows = folder.run("table spec-results --show rows --to csv");
    let head = rows.answer().lines().next().unwrap();
    assert!(
        head.contains(",failure,") && head.contains(",peak MB,reason,"),
        "{head}"
    );
    folder.refuses(
        "table spec-results --to html",
        &expect![[r#"
        exit 1
        Found html, expected markdown or csv; only planners are written as a page.
    "#]],
    );
}

#[test]
fn what_is_wrong_with_a_planner_is_told() {
    let folder = folder();
    let refused = |planner: &str, expect: &expect_test::Expect| {
        let rest = "[[instances]]\nfiles = [\"*.scen\"]\n";
        fs::write(folder.path("spec.toml"), format!("{planner}\n{rest}")).unwrap();
        folder.refuses("sweep spec.toml --list", expect);
    };
    let planner = "[[planner]]\nname = \"mine\"\ncommand = \"mine {map} {out}\"";
    refused(
        planner,
        &expect![[r#"
        exit 1
        spec.toml: planner[0]: found a planner of others and no time-limit, expected a time-limit, after which it is ended
    "#]],
    );
    let limit = "time-limit = 5\n";
    refused(
        &format!("{limit}{}", planner.replace("{map}", "{mapp}")),
        &expect![[r#"
        exit 1
        spec.toml: planner[0].command: found {mapp}, expected {map}, {scen}, {agents}, {seconds} or {out}; {{ and }} are braces
    "#]],
    );
    refused(
        &format!("{limit}{}", planner.replace("\"mine\"", "\"my own\"")),
        &expect![[r#"
        exit 1
        spec.toml: planner[0].name: found "my own", expected 1 to 40 letters without blanks and =
    "#]],
    );
    let rest = "[[instances]]\nfiles = [\"*.scen\"]\nagents = 2\n";
    let missing = planner.replace("mine {map}", "./missing {map}");
    fs::write(
        folder.path("spec.toml"),
        format!("{limit}{missing}\n{rest}"),
    )
    .unwrap();
    let run = folder.run("sweep spec.toml");
    assert!(run.out.contains("1 optimal, 1 error."), "{}", run.out);
    assert!(run.err.contains("missing cannot be run: "), "{}", run.err);
}

/// Whether a process is at work. One that was killed is there until it is waited for.
fn is_alive(process: &str) -> bool {
    let words = ["-o", "stat=", "-p", process.trim()];
    let output = Command::new("ps").args(words).output().unwrap();
    let state = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    !state.is_empty() && !state.starts_with('Z')
}

fn soon(is_so: impl Fn() -> bool) -> bool {
    (0..2400).any(|_| {
        sleep(Duration::from_millis(50));
        is_so()
    })
}

#[test]
fn ctrl_c_and_a_kill_end_the_planner_and_write_no_row() {
    let folder = folder();
    let spec = "time-limit = 900\nplanners = [\"lacam\"]\n[[planner]]\nname = \"hangs\"\n\
        command = \"sh -c 'sleep 800 & echo $! >made; mv made child; sleep 800' {map} {out}\"\n\
        [[instances]]\nfiles = [\"*.scen\"]\nagents = 2\n";
    fs::write(folder.path("spec.toml"), spec).unwrap();
    for signal in ["-INT", "-KILL"] {
        let mut sweep = command()
            .args(["sweep", "spec.toml", "-q"])
            .current_dir(folder.path("."))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        assert!(soon(|| folder.path("child").exists()));
        let child = folder.read("child");
        assert!(is_alive(&child));
        let id = sweep.id().to_string();
        assert!(
            Command::new("kill")
                .args([signal, &id])
                .status()
                .unwrap()
                .success()
        );
        sweep.wait().unwrap();
        assert!(soon(|| !is_alive(&child)), "{signal}");
        fs::remove_file(folder.path("child")).unwrap();
        let rows = folder.read("spec-results/results-1-of-1.jsonl");
        assert_eq!(rows.lines().count(), 1, "that of lacam: {rows}");
    }
}
