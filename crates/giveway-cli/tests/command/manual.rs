//! Help, completions and the manual, and a reader that goes away.

use std::io::Read as _;
use std::process::Stdio;

use crate::run::{Folder, WAREHOUSE, WAREHOUSE_PLAN, command};

#[test]
fn help_and_version_are_answers() {
    let folder = Folder::scene("");
    assert!(folder.run("help").answer().contains("Exit status"));
    assert!(folder.run("help solve").answer().contains("--time-limit"));
    assert_eq!(
        folder.run("--version").answer(),
        format!("giveway {}\n", giveway_model::release())
    );
}

#[test]
fn every_shell_has_its_completions() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let run = Folder::scene("").run(&format!("completions {shell}"));
        assert!(run.answer().contains("time-limit"), "{shell}");
    }
}

#[test]
fn every_command_has_its_page() {
    let folder = Folder::scene("");
    for page in ["", "solve", "check", "convert", "completions", "man"] {
        let run = folder.run(&format!("man {page}"));
        assert!(run.answer().contains(".SH SYNOPSIS"), "{page}");
        assert!(run.out.contains(".TH giveway"), "{page}");
    }
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let folder = Folder::with(&[("warehouse.json", WAREHOUSE), ("plan.json", WAREHOUSE_PLAN)]);
    for line in [
        "check warehouse.json plan.json",
        "check warehouse.json plan.json --format json",
        "help",
        "completions bash",
        "man",
    ] {
        let mut child = command()
            .args(line.split(' '))
            .current_dir(folder.path(""))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut err = String::new();
        child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut err)
            .unwrap();
        assert_eq!(
            (child.wait().unwrap().code(), err.as_str()),
            (Some(0), ""),
            "{line}"
        );
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = Folder::with(&[("warehouse.json", WAREHOUSE), ("plan.json", WAREHOUSE_PLAN)]);
    let output = command()
        .args(["check", "warehouse.json", "plan.json"])
        .current_dir(folder.path(""))
        .stdout(std::fs::File::create("/dev/full").unwrap())
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(err.starts_with("standard output: cannot write: "), "{err}");
}
