//! Ctrl-C: the best plan so far is told, and a second one ends the command at once.

use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use serde_json::Value;

use crate::run::{Folder, command};

/// Thirty robots of which no search proves a best plan within minutes.
const HARD: &str = include_str!("../../../../tests/data/mmapf/A17_mm_20x20_o15_a30.json");
/// How long it searches, in seconds: a first plan is found within the first of these, but for a
/// machine that is busy with other things.
const WHILE_IT_SEARCHES: [u64; 3] = [4, 20, 60];
/// The command waits for a reader by then.
const IT_WRITES: Duration = Duration::from_secs(8);
/// How often it is looked whether the command has ended, and how many times: a minute, since
/// the machine may be busy.
const LOOK: Duration = Duration::from_millis(50);
const LOOKS: u32 = 1_200;

/// Robots on every cell of the left and the right rim that change sides.
fn crowd(side: u32) -> String {
    let row = ".".repeat(side as usize);
    let rows = vec![format!("\"{row}\""); side as usize].join(", ");
    let mut agents = Vec::new();
    for y in 0..side {
        let other = side - 1 - y;
        let last = side - 1;
        agents.push(format!(
            "{{ \"name\": \"L{y}\", \"start\": [0, {y}], \"goal\": [{last}, {other}] }}"
        ));
        agents.push(format!(
            "{{ \"name\": \"R{y}\", \"start\": [{last}, {y}], \"goal\": [0, {other}] }}"
        ));
    }
    let agents = agents.join(", ");
    format!("{{ \"giveway\": 1, \"name\": \"crowd\", \"map\": [{rows}], \"agents\": [{agents}] }}")
}

fn start(folder: &Folder, line: &str) -> Child {
    command()
        .args(line.split_whitespace())
        .current_dir(folder.path(""))
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// What a terminal does when Ctrl-C is pressed.
fn interrupt(child: &Child) {
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status().unwrap();
    assert!(sent.success());
}

fn ends_soon(child: &mut Child) -> Option<i32> {
    let mut ended = None;
    for _ in 0..LOOKS {
        ended = child.try_wait().unwrap();
        if ended.is_some() {
            break;
        }
        sleep(LOOK);
    }
    if ended.is_none() {
        child.kill().unwrap();
    }
    ended.unwrap().code()
}

#[test]
fn the_best_plan_so_far_is_told() {
    let folder = Folder::scene(HARD);
    let mut answers = WHILE_IT_SEARCHES.into_iter().map(|seconds| {
        let child = start(&folder, "solve scene.json --format json");
        sleep(Duration::from_secs(seconds));
        interrupt(&child);
        let output = child.wait_with_output().unwrap();
        let told = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(130), "{told}");
        assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
        let answer: Value = serde_json::from_str(&told).unwrap();
        assert_eq!(answer["ended"], "cancelled");
        answer
    });
    let answer = answers.find(|answer| answer["status"] == "feasible");
    let answer = answer.expect("a plan");
    let paths = answer["plan"]["paths"].as_object().unwrap();
    assert_eq!(paths.len(), 30);
    // It is a plan like any other.
    let plan = folder.path("plan.json");
    std::fs::write(plan, answer["plan"].to_string()).unwrap();
    let checked = folder.run("check scene.json plan.json");
    assert_eq!(checked.exit, Some(0), "{}", checked.out);
}

#[test]
fn a_second_one_ends_at_once_even_where_nobody_reads_the_answer() {
    let folder = Folder::scene(crowd(55));
    // The answer is longer than a pipe that nobody reads takes.
    let mut child = start(&folder, "solve scene.json --format json");
    sleep(IT_WRITES);
    interrupt(&child);
    sleep(IT_WRITES);
    assert_eq!(
        child.try_wait().unwrap(),
        None,
        "the answer still waits to be read"
    );
    interrupt(&child);
    assert_eq!(ends_soon(&mut child), Some(130));
}

#[test]
fn before_anything_is_searched_it_ends_the_command_as_ever() {
    let folder = Folder::scene(crowd(12));
    let mut child = command()
        .args(["solve", "-"])
        .current_dir(folder.path(""))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    sleep(Duration::from_millis(500));
    interrupt(&child);
    assert_eq!(ends_soon(&mut child), None, "by the signal");
}
