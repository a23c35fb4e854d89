//! Changes while a plan runs: their files, what is refused, the judge.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

mod broken;
mod files;
mod refused;
mod rules;
mod stopped;
mod valid;

use giveway_model::change::Changes;
use giveway_model::check::{Report, check_changes};
use giveway_model::format::native;
use giveway_model::{Instance, Plan};

/// An instance of a map, of agents such as `A 00 20`, with ` via 10 20` and
/// ` battery 8/10` where they have them; `vanish` in a line of its own.
fn instance(map: &[&str], agents: &str) -> Instance {
    let mut at_goal = "stay";
    let mut list = Vec::new();
    for line in agents.split(';').map(str::trim) {
        if line == "vanish" {
            at_goal = "vanish";
            continue;
        }
        list.push(agent(line));
    }
    let text = format!(
        r#"{{ "giveway": 1, "map": {map:?}, "rules": {{ "at_goal": "{at_goal}" }}, "agents": [{}] }}"#,
        list.join(", ")
    );
    native::read_instance(&text).unwrap()
}

/// An agent as JSON.
fn agent(line: &str) -> String {
    let mut words = line.split(' ');
    let name = words.next().unwrap();
    let (start, goal) = (cell(words.next().unwrap()), cell(words.next().unwrap()));
    let mut waypoints = Vec::new();
    let mut battery = String::new();
    while let Some(word) = words.next() {
        if word == "battery" {
            let (initial, capacity) = words.next().unwrap().split_once('/').unwrap();
            battery = format!(r#", "battery": {{ "capacity": {capacity}, "initial": {initial} }}"#);
        } else if word != "via" {
            waypoints.push(cell(word));
        }
    }
    let waypoints = waypoints.join(", ");
    format!(
        r#"{{ "name": "{name}", "start": {start}, "goal": {goal}, "waypoints": [{waypoints}]{battery} }}"#
    )
}

fn cell(word: &str) -> String {
    let (x, y) = word.split_at(1);
    format!("[{x}, {y}]")
}

/// A plan of paths such as `A 00 10+ .. 20`, `B@2` for one that begins at time
/// 2, and `B@2-5` for one that is gone from time 5; `A~1-4` slept from 1 to 4.
fn plan(paths: &str) -> Plan {
    let mut plan = Plan::default();
    for line in paths.split(';').map(str::trim) {
        let mut words = line.split(' ');
        let head = words.next().unwrap();
        let (head, slept) = head.split_once('~').unwrap_or((head, ""));
        let (name, times) = head.split_once('@').unwrap_or((head, "0"));
        let (from, until) = times.split_once('-').unwrap_or((times, ""));
        let from: u32 = from.parse().unwrap();
        let mut charges = Vec::new();
        let mut path = Vec::new();
        for (i, word) in words.enumerate() {
            if word.ends_with('+') {
                charges.push(from + i as u32);
            }
            path.push((word != "..").then(|| {
                let cell = cell(word.trim_end_matches('+'));
                serde_json::from_str(&cell).unwrap()
            }));
        }
        plan.paths.insert(name.to_owned(), path);
        if !charges.is_empty() {
            plan.charges.insert(name.to_owned(), charges);
        }
        if let Some((since, until)) = slept.split_once('-') {
            let span = [since.parse().unwrap(), until.parse().unwrap()];
            plan.slept.insert(name.to_owned(), vec![span]);
        }
        if from > 0 {
            plan.from.insert(name.to_owned(), from);
        }
        if !until.is_empty() {
            plan.until.insert(name.to_owned(), until.parse().unwrap());
        }
    }
    plan
}

/// Changes such as `2 add-obstacle 10; 3 remove-agent A`.
fn changes(lines: &str) -> Changes {
    let list = lines
        .split(';')
        .map(str::trim)
        .filter(|line| !line.is_empty());
    let list: Vec<String> = list.map(change).collect();
    let text = format!(r#"{{ "giveway": 1, "changes": [{}] }}"#, list.join(", "));
    native::read_changes(&text).unwrap()
}

fn change(line: &str) -> String {
    let (at, rest) = line.split_once(' ').unwrap();
    let (kind, rest) = rest.split_once(' ').unwrap();
    let words: Vec<&str> = rest.split(' ').collect();
    let keys = match kind {
        "add-agent" => format!(r#""agent": {}"#, agent(rest)),
        "remove-agent" | "stop-agent" => format!(r#""agent": "{rest}""#),
        "set-slow" | "set-normal" => {
            let cells: Vec<String> = words.iter().map(|word| cell(word)).collect();
            format!(r#""cells": [{}]"#, cells.join(", "))
        }
        "move-obstacle" => format!(r#""from": {}, "to": {}"#, cell(words[0]), cell(words[1])),
        "set-battery" => format!(r#""agent": "{}", "level": {}"#, words[0], words[1]),
        "delay-agent" => format!(r#""agent": "{}", "steps": {}"#, words[0], words[1]),
        "set-goal" | "add-waypoint" | "drop-waypoint" => {
            format!(r#""agent": "{}", "cell": {}"#, words[0], cell(words[1]))
        }
        _ => format!(r#""cell": {}"#, cell(rest)),
    };
    format!(r#"{{ "at": {at}, "change": "{kind}", {keys} }}"#)
}

fn judge(map: &[&str], agents: &str, lines: &str, paths: &str) -> Report {
    check_changes(&instance(map, agents), &changes(lines), &plan(paths)).unwrap()
}
