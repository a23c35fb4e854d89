//! `giveway sweep` and `giveway table`.

use std::collections::BTreeSet;
use std::fs;

use expect_test::expect;
use serde_json::Value;

use crate::run::{EMPTY_MAP, EMPTY_SCEN, Folder, SCENARIO_6, command};

const SPEC: &str = r#"
    objectives = ["sum-of-costs,makespan"]
    planners = ["search", "prioritised"]
    conflict-limit = 10000
    [[instances]]
    files = ["*.scen"]
    agents = { from = 2, to = 6, step = 2 }
    [[instances]]
    files = ["impossible.json"]
"#;

fn folder() -> Folder {
    Folder::with(&[
        ("spec.toml", SPEC),
        ("empty-8-8.map", EMPTY_MAP),
        ("empty-8-8.scen", EMPTY_SCEN),
        ("impossible.json", SCENARIO_6),
    ])
}

/// Every row as a table of CSV, but for the last column, which is time.
fn rows(folder: &Folder, results: &str) -> Vec<String> {
    let run = folder.run(&format!("table {results} --show rows --to csv"));
    let line = |line: &str| line.rsplit_once(',').unwrap().0.to_owned();
    run.answer().lines().map(line).collect()
}

#[test]
fn every_task_has_a_row_and_is_done_once() {
    let folder = folder();
    let listed = folder.run("sweep spec.toml --list");
    let tasks: Vec<Value> = listed
        .answer()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(tasks.len(), 2 * (3 + 1));
    let run = folder.run("sweep spec.toml");
    assert_eq!(run.exit, Some(0), "{}", run.err);
    expect![[r#"
        8 tasks: 3 optimal, 3 feasible, 1 impossible, 1 unknown.
        Results are in spec-results.
    "#]]
    .assert_eq(&run.out);
    assert_eq!(run.err.lines().count(), 8);
    let again = folder.run("sweep spec.toml");
    assert_eq!(
        (again.out.as_str(), again.err.as_str()),
        (run.out.as_str(), "")
    );
    let name = |task: &Value| task["task"].as_str().unwrap().to_owned();
    let text = folder.read("spec-results/results-1-of-1.jsonl");
    let rows: Vec<Value> = text
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let done: BTreeSet<String> = rows.iter().map(name).collect();
    assert_eq!(done, tasks.iter().map(name).collect());
}

#[test]
fn shards_and_what_a_killed_one_left_come_to_the_same_table() {
    let folder = folder();
    assert_eq!(folder.run("sweep spec.toml --results whole -q").err, "");
    for shard in ["1/3", "3/3", "2/3"] {
        folder
            .run(&format!(
                "sweep spec.toml --shard {shard} --results parts -q"
            ))
            .answer();
    }
    let expected = rows(&folder, "whole");
    assert_eq!(expected.len(), 9);
    assert_eq!(rows(&folder, "parts"), expected);
    // Killed while it wrote a row.
    let own = folder.path("parts/results-2-of-3.jsonl");
    let text = fs::read_to_string(&own).unwrap();
    fs::write(&own, &text[..text.len() - 30]).unwrap();
    assert_eq!(rows(&folder, "parts").len(), 8);
    let run = folder.run("sweep spec.toml --shard 2/3 --results parts");
    assert_eq!(
        run.err.lines().count(),
        1,
        "only what was lost is done: {}",
        run.err
    );
    assert_eq!(rows(&folder, "parts"), expected);
}

/// Fourteen robots on sixteen cells turn round: nobody is done with that soon.
fn full(folder: &Folder) {
    let cell = |index: usize| (index % 4, index / 4);
    let line = |index: usize| {
        let ((x, y), (u, v)) = (cell(index), cell(15 - index));
        format!("0\tfull.map\t4\t4\t{x}\t{y}\t{u}\t{v}\t6\n")
    };
    let scenario: String = (0..14).map(line).collect();
    fs::write(folder.path("full.scen"), format!("version 1\n{scenario}")).unwrap();
    let map = format!(
        "type octile\nheight 4\nwidth 4\nmap\n{}",
        "....\n".repeat(4)
    );
    fs::write(folder.path("full.map"), map).unwrap();
}

#[test]
fn a_process_that_is_killed_loses_no_more_than_one_task() {
    let folder = folder();
    full(&folder);
    let easy = "[[instances]]\nfiles = [\"empty-8-8.scen\"]\nagents = { from = 1, to = 6 }\n";
    let hard = "[[instances]]\nfiles = [\"full.scen\"]\nagents = 14\n";
    fs::write(folder.path("spec.toml"), format!("{easy}{hard}")).unwrap();
    let mut child = command()
        .args(["sweep", "spec.toml", "-q"])
        .current_dir(folder.path("."))
        .stdout(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let own = folder.path("spec-results/results-1-of-1.jsonl");
    let lines = || fs::read_to_string(&own).unwrap_or_default().lines().count();
    while lines() < 6 {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::yield_now();
    }
    child.kill().unwrap();
    child.wait().unwrap();
    fs::write(folder.path("spec.toml"), easy).unwrap();
    let run = folder.run("sweep spec.toml");
    assert_eq!(
        (run.exit, run.err.as_str()),
        (Some(0), ""),
        "all of these were done before"
    );
    assert_eq!(lines(), 6);
}

#[test]
fn tables_and_plots_are_written() {
    let folder = folder();
    folder.run("sweep spec.toml -q").answer();
    let summary = folder.run("table spec-results");
    assert!(
        summary.answer().starts_with("| map | objective |"),
        "{}",
        summary.out
    );
    let points = folder.run("table spec-results --show success --to csv");
    assert!(points.answer().contains("search,2,1.000"), "{}", points.out);
    for show in ["success", "cactus"] {
        let svg = folder.run(&format!("table spec-results --show {show} --to svg"));
        assert!(svg.answer().starts_with("<svg"), "{}", svg.out);
    }
    folder.refuses(
        "table spec-results --to svg",
        &expect![[r#"
            exit 1
            Found svg for a table, expected markdown or csv; success, cactus and planners are drawn.
        "#]],
    );
}

#[test]
fn certificates_of_a_sweep_are_made_again_by_the_command() {
    let folder = folder();
    let spec = "objectives = [\"sum-of-costs\"]\nclock = \"cpu\"\ntime-limit = 60\n[certificates]\n\
        [[instances]]\nfiles = [\"*.scen\"]\nagents = { from = 2, step = 3 }";
    let specs = folder.path("specs");
    fs::create_dir(&specs).unwrap();
    fs::write(specs.join("spec.toml"), spec).unwrap();
    let run = folder.run("sweep specs/spec.toml --files . -q --results rows");
    assert_eq!(run.exit, Some(0), "{}", run.err);
    let table = folder.run("table rows --show optima --to csv");
    let lines: Vec<Vec<&str>> = table
        .answer()
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    let numbers: Vec<&str> = lines[1..].iter().map(|cells| cells[2]).collect();
    assert_eq!(numbers, ["2", "5", "8"], "as many as the scenario has");
    let mut proofs = 0;
    for cells in lines[1..]
        .iter()
        .filter(|cells| cells[9] == "proved")
        .take(3)
    {
        let (agents, sum) = (cells[2], cells[12]);
        let solve = "solve empty-8-8.scen --objective sum-of-costs -q";
        let made = folder.run(&format!("{solve} --agents {agents} --proof made-{agents}"));
        assert_eq!(made.exit, Some(0), "{}", made.err);
        let manifest = fs::read(folder.path(format!("made-{agents}/manifest.json"))).unwrap();
        assert_eq!(giveway_proof::bundle::fingerprint(&manifest), sum);
        assert_eq!(folder.run(&format!("verify made-{agents}")).exit, Some(0));
        proofs += 1;
    }
    assert_eq!(proofs, 3);
}

#[test]
fn what_was_skipped_is_tried_when_more_is_asked_for() {
    let folder = folder();
    let spec = |skip_after: usize| {
        // Nothing can be done without a conflict by these agents, but for the first few.
        format!(
            "skip-after = {skip_after}\nconflict-limit = 0\nobjectives = [\"sum-of-costs\"]\n\
            [[instances]]\nfiles = [\"full.scen\"]\nagents = [10, 11, 12]"
        )
    };
    full(&folder);
    fs::write(folder.path("spec.toml"), spec(1)).unwrap();
    let run = folder.run("sweep spec.toml -q");
    assert!(run.answer().contains("2 skipped"), "{}", run.out);
    fs::write(folder.path("spec.toml"), spec(2)).unwrap();
    let run = folder.run("sweep spec.toml");
    assert!(run.out.contains("1 skipped"), "{}", run.out);
    assert_eq!(run.err.lines().count(), 1, "{}", run.err);
    assert!(
        folder
            .run("table spec-results")
            .answer()
            .contains("skipped")
    );
}

#[test]
fn what_is_wrong_is_told_and_the_other_tasks_go_on() {
    let folder = folder();
    fs::write(
        folder.path("typo.toml"),
        "time-limt = 3\n[[instances]]\nfiles = []",
    )
    .unwrap();
    folder.refuses("sweep typo.toml", &expect![[r#"
        exit 1
        typo.toml: line 1, column 1: found unknown field `time-limt`, expected one of `instances`, `objectives`, `planners`, `planner`, `time-limit`, `clock`, `conflict-limit`, `memory-limit`, `skip-after`, `certificates`
    "#]]);
    fs::write(
        folder.path("none.toml"),
        "[[instances]]\nfiles = [\"x*.scen\"]",
    )
    .unwrap();
    folder.refuses("sweep none.toml", &expect![[r#"
        exit 1
        none.toml: instances[0].files: found "x*.scen", which is no file, expected a file, or a pattern of files
    "#]]);
    folder.refuses("sweep spec.toml --shard 4/3", &expect![[r#"
        exit 2
        error: invalid value '4/3' for '--shard <I/N>': found "4/3", expected I/N with I from 1 to N, such as 3/64

        For more information, try '--help'.
    "#]]);
    fs::write(folder.path("impossible.json"), "{").unwrap();
    let run = folder.run("sweep spec.toml -q");
    assert!(run.answer().contains("2 error"), "{}", run.out);
    let rows = rows(&folder, "spec-results");
    assert_eq!(rows.len(), 9);
    folder.refuses(
        "table nowhere",
        &expect![[r#"
        exit 1
        nowhere: found no file of this name, expected a file or a folder of results
    "#]],
    );
    folder.refuses(
        "table .",
        &expect![[r#"
        exit 1
        There are no results in it; giveway sweep writes them into files that end in .jsonl.
    "#]],
    );
    fs::write(folder.path("spec-results/other.jsonl"), "{}\n").unwrap();
    let wrong = folder.run("table spec-results");
    assert_eq!(wrong.exit, Some(1));
    assert!(wrong.err.contains("other.jsonl: line 1"), "{}", wrong.err);
}

#[test]
fn what_could_not_be_read_is_told_and_tried_again() {
    let folder = folder();
    let spec = "skip-after = 1\nconflict-limit = 10000\n\
        [[instances]]\nfiles = [\"*.scen\"]\nagents = [3, 4, 99]";
    fs::write(folder.path("spec.toml"), spec).unwrap();
    fs::rename(folder.path("empty-8-8.map"), folder.path("away")).unwrap();
    let run = folder.run("sweep spec.toml");
    assert!(run.out.contains("3 tasks: 3 error."), "{}", run.out);
    assert!(run.err.contains(": error: empty-8-8.map: "), "{}", run.err);
    let rows = || folder.read("spec-results/results-1-of-1.jsonl");
    let before = rows();
    let run = folder.run("sweep spec.toml");
    assert_eq!(run.err.lines().count(), 3, "told again: {}", run.err);
    assert_eq!(rows(), before, "what is the same is not written again");
    fs::rename(folder.path("away"), folder.path("empty-8-8.map")).unwrap();
    let run = folder.run("sweep spec.toml -q");
    assert!(
        run.answer().contains("3 tasks: 2 optimal, 1 error."),
        "{}",
        run.out
    );
    let table = folder.run("table spec-results --show success --to csv");
    assert_eq!(
        table.answer(),
        "curve,agents,success rate\nsearch,3,1.000\nsearch,4,1.000\n"
    );
    fs::write(
        folder.path("none.toml"),
        spec.replace("[3, 4, 99]", "{ from = 2000 }"),
    )
    .unwrap();
    let run = folder.run("sweep none.toml");
    assert!(
        run.answer().starts_with("There are no tasks to do.\n"),
        "{}",
        run.out
    );
}

#[test]
fn results_that_are_a_file_and_a_shard_that_runs_already_are_told() {
    let folder = folder();
    folder.refuses(
        "sweep spec.toml --results impossible.json",
        &expect![[r#"
        exit 1
        impossible.json: found a file, expected a folder of results
    "#]],
    );
    let results = giveway_sweep::Results::open(&folder.path("r"), giveway_sweep::Shard::ALL);
    let results = results.unwrap();
    folder.refuses("sweep spec.toml --results r", &expect![[r#"
        exit 1
        r/results-1-of-1.jsonl: found a file that another process writes to, expected this shard to run once
    "#]]);
    drop(results);
    folder.run("sweep spec.toml --results r -q").answer();
}
