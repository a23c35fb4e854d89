//! Plans of some 100 MB are combined with their map within 2 s of a processor and
//! 500 MB.
//!
//! Ignored, since it measures: `cargo test --release -p giveway-formats --test
//! foreign_large -- --ignored --nocapture --test-threads=1`.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test stops at the first surprise, and tells what it measured"
)]

use std::fmt::Write as _;

use cpu_time::ThreadTime;
use giveway_formats::{MAX_TEXT_BYTES, Options, Source, combine};

const SIDE: usize = 512;
const AGENTS: usize = 400;

fn map() -> String {
    let row = format!("{}\n", ".".repeat(SIDE));
    format!(
        "type octile\nheight {SIDE}\nwidth {SIDE}\nmap\n{}",
        row.repeat(SIDE)
    )
}

fn scenario() -> String {
    let mut text = String::from("version 1\n");
    for y in 0..AGENTS {
        let _ = writeln!(text, "0\tm.map\t{SIDE}\t{SIDE}\t0\t{y}\t1\t{y}\t1");
    }
    text
}

/// Each agent goes to and fro in its own row, and ends at `x = 1`.
fn x(time: usize) -> usize {
    let round = 2 * (SIDE - 1);
    let along = time % round;
    along.min(round - along)
}

/// As many whole rounds and one step as fit.
fn steps(bytes_of_a_step: usize) -> usize {
    let round = 2 * (SIDE - 1);
    let steps = MAX_TEXT_BYTES / bytes_of_a_step / AGENTS;
    steps.min(24_000_000 / AGENTS - 1) / round * round + 1
}

/// The most memory that this process had, in MB, where the system tells.
fn peak() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"))?;
    let number: usize = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(number / 1000)
}

fn assert_quick(name: &str, text: &str, extra: &[(&str, &str)]) {
    let mut sources = vec![Source { name, text }];
    sources.extend(extra.iter().map(|&(name, text)| Source { name, text }));
    let begin = ThreadTime::now();
    let combined = combine(&sources, &Options::default()).unwrap();
    let seconds = begin.elapsed().as_secs_f64();
    assert!(
        combined.plans[0].fit.is_perfect(),
        "{:?}",
        combined.plans[0].fit
    );
    let peak = peak();
    println!(
        "{name}: {} MB, {seconds:.2} s, {peak:?} MB at most",
        text.len() / 1_000_000
    );
    if !cfg!(debug_assertions) {
        assert!(seconds < 2.0, "{name}: {seconds} s");
        assert!(peak.is_none_or(|peak| peak < 500), "{name}: {peak:?} MB");
    }
}

#[test]
#[ignore = "measures"]
fn a_line_for_each_robot() {
    let mut text = String::with_capacity(MAX_TEXT_BYTES);
    for y in 0..AGENTS {
        let _ = write!(text, "Agent {y}: ");
        for time in 0..=steps(11) {
            let _ = write!(text, "({y},{})->", x(time));
        }
        text.push('\n');
    }
    text.shrink_to_fit();
    assert_quick(
        "paths.txt",
        &text,
        &[("m.map", &map()), ("m.scen", &scenario())],
    );
}

#[test]
#[ignore = "measures"]
fn a_line_for_each_time_step() {
    let mut text = String::with_capacity(MAX_TEXT_BYTES);
    text.push_str("solution=\n");
    for time in 0..=steps(10) {
        let _ = write!(text, "{time}:");
        for y in 0..AGENTS {
            let _ = write!(text, "({},{y}),", x(time));
        }
        text.push('\n');
    }
    text.shrink_to_fit();
    assert_quick(
        "result.txt",
        &text,
        &[("m.map", &map()), ("m.scen", &scenario())],
    );
}

/// The letters of one agent.
fn letters(from: char, to: char) -> String {
    let letter = |time| if x(time + 1) > x(time) { from } else { to };
    (0..steps(4)).map(letter).collect()
}

#[test]
#[ignore = "measures"]
fn letters_in_a_table_and_in_yaml() {
    let path = letters('r', 'l');
    let paths = vec![path; AGENTS];
    let table = format!("agents,path\n{AGENTS},\"{}\"\n", paths.join("\n"));
    let (map, scenario) = (map(), scenario());
    let extra = [("m.map", &*map), ("m.scen", &*scenario)];
    assert_quick("plan.csv", &table, &extra);
    drop(table);
    let yaml = format!(
        "agents: {AGENTS}\nsolution_plan:\n- {}\n",
        paths.join("\n- ")
    );
    assert_quick("plan.yaml", &yaml, &extra);
}

/// Rounds of each agent in its own row, so many that a text of `bytes` a step fits.
fn rounds(bytes: usize) -> usize {
    let round = 2 * (SIDE - 1);
    let steps = (MAX_TEXT_BYTES - 12_000_000) / bytes / AGENTS;
    steps.min(24_000_000 / AGENTS - 1) / round * round
}

#[test]
#[ignore = "measures"]
fn facts() {
    let mut text = String::with_capacity(MAX_TEXT_BYTES);
    for y in 1..=SIDE {
        for x in 1..=SIDE {
            let _ = writeln!(text, "init(object(node,1),value(at,({x},{y}))).");
        }
    }
    for y in 1..=AGENTS {
        let _ = writeln!(text, "init(object(robot,{y}),value(at,(1,{y}))).");
    }
    for time in 1..=rounds(54) {
        for y in 1..=AGENTS {
            let dx = if x(time) > x(time - 1) { 1 } else { -1 };
            let _ = writeln!(
                text,
                "occurs(object(robot,{y}),action(move,({dx},0)),{time})."
            );
        }
    }
    text.shrink_to_fit();
    assert_quick("plan.lp", &text, &[]);
}

#[test]
#[ignore = "measures"]
fn actions_in_json() {
    let letter = |time| if x(time + 1) > x(time) { "R" } else { "L" };
    let path: Vec<&str> = (0..rounds(2)).map(letter).collect();
    let path = format!("\"{}\"", path.join(","));
    let starts: Vec<String> = (0..AGENTS).map(|y| format!("[{y},0,\"N/A\"]")).collect();
    let text = format!(
        "{{\"actionModel\":\"MAPF\",\"start\":[{}],\"actualPaths\":[{}]}}",
        starts.join(","),
        vec![path; AGENTS].join(",")
    );
    assert_quick("result.json", &text, &[("m.map", &map())]);
}

#[test]
#[ignore = "measures"]
fn cells_in_json() {
    let path = |y: usize| {
        let cells: Vec<String> = (0..=rounds(9))
            .map(|time| format!("[{},{y}]", x(time)))
            .collect();
        format!("[{}]", cells.join(","))
    };
    let paths: Vec<String> = (0..AGENTS).map(path).collect();
    let ends: Vec<String> = (0..AGENTS).map(|y| format!("[0,{y}]")).collect();
    let (row, ends) = (format!("[{}]", vec!["0"; SIDE].join(",")), ends.join(","));
    let problem = format!(
        "{{\"grid\":[{}],\"starts\":[{ends}],\"goals\":[{ends}]}}",
        vec![row; SIDE].join(",")
    );
    let text = format!("{{\"solutions\":[{{\"solution\":[{}]}}]}}", paths.join(","));
    drop(paths);
    assert_quick("solution.json", &text, &[("problem.json", &problem)]);
}

/// A schedule with `rounds(bytes)` steps; `space` is written before each value.
fn schedule(bytes: usize, space: &str) -> String {
    let mut text = String::with_capacity(MAX_TEXT_BYTES);
    text.push_str("schedule:\n");
    for y in 0..AGENTS {
        let _ = writeln!(text, "  agent{y}:");
        for time in 0..=rounds(bytes) {
            let x = x(time);
            let _ = writeln!(
                text,
                "    - x:{space}{x}\n      y:{space}{y}\n      t:{space}{time}"
            );
        }
    }
    text.shrink_to_fit();
    text
}

#[test]
#[ignore = "measures"]
fn states_in_lines() {
    let text = schedule(42, " ");
    assert_quick("schedule.yaml", &text, &[("m.map", &map())]);
}

/// Not as the library prints it: all of YAML is read value by value, which takes
/// several times as long as JSON. A file of a fifth of the size.
#[test]
#[ignore = "measures"]
fn states_in_any_yaml() {
    let text = schedule(45 * 4, "  ");
    assert_quick("any.yaml", &text, &[("m.map", &map())]);
}
