//! Bottlenecks: robots that all have to pass one passage, or a zone with a limit of one.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;

use giveway_model::{Cost, Objective};
use giveway_solve::Status;
use serde_json::json;

use crate::rows::Row;
use crate::run::Command;

const HEAD: &str = "\
| robots, passage | what | makespan | CPU s | sum of costs | CPU s |
| --- | --- | ---: | ---: | ---: | ---: |
";
/// Robots, and the cells of the passage between two rooms of 6 x 8 cells.
const SIZES: [(usize, usize); 7] = [(8, 1), (10, 3), (16, 1), (16, 3), (16, 6), (24, 3), (24, 6)];
const HEIGHT: usize = 8;
const ROOM: usize = 6;
/// The row of the passage.
const ROW: usize = 4;

/// The table of all of them.
///
/// # Errors
/// Where the command cannot be run or does not answer as documented.
pub(crate) fn table(command: &Command, parts: &[String]) -> Result<String, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let mut text = HEAD.to_owned();
    for (robots, length) in SIZES {
        for both_ways in [false, true] {
            for is_zone in [false, true] {
                let way = if both_ways { "both ways" } else { "one way" };
                let limit = if is_zone { ", one at a time" } else { "" };
                let name = format!("{robots}, {length}");
                if !parts.is_empty() && !parts.iter().any(|part| name.contains(part)) {
                    continue;
                }
                let file = folder.path().join("gate.json");
                fs::write(&file, scene(robots, length, both_ways, is_zone))?;
                let mut cells = Vec::new();
                for cost in [Cost::Makespan, Cost::SumOfCosts] {
                    let row = Row {
                        name: name.clone(),
                        file: file.clone(),
                        agents: None,
                        objective: Objective::new(vec![cost])?,
                        known: Vec::new(),
                    };
                    let outcome = command.run(&row)?;
                    eprintln!("{way}{limit}: {}", outcome.line());
                    let value = outcome.answer.costs.map(|costs| costs.get(cost));
                    let bound = outcome.answer.bounds.get(&cost);
                    let number =
                        |n: Option<u32>| n.map_or_else(|| "-".to_owned(), |n| n.to_string());
                    cells.push(match outcome.answer.status {
                        Status::Optimal => number(value),
                        _ => format!("{}, at least {}", number(value), number(bound.copied())),
                    });
                    cells.push(format!("{:.2}", outcome.cpu_seconds));
                }
                let _ = writeln!(text, "| {name} | {way}{limit} | {} |", cells.join(" | "));
            }
        }
    }
    Ok(text)
}

/// Two rooms with a passage between them, and robots that leave their room: a scene as text.
fn scene(robots: usize, length: usize, both_ways: bool, is_zone: bool) -> String {
    let mut random = fastrand::Rng::with_seed((robots * 100 + length) as u64);
    let is_free = |x: usize, y: usize| x < ROOM || x >= ROOM + length || y == ROW;
    let width = 2 * ROOM + length;
    let map: Vec<String> = (0..HEIGHT)
        .map(|y| {
            (0..width)
                .map(|x| if is_free(x, y) { '.' } else { '#' })
                .collect()
        })
        .collect();
    let mut cells = |from: usize| {
        let all = (0..HEIGHT).flat_map(|y| (from..from + ROOM).map(move |x| [x, y]));
        let mut all: Vec<[usize; 2]> = all.collect();
        random.shuffle(&mut all);
        all
    };
    let mut starts = [cells(0), cells(ROOM + length)];
    let mut goals = [cells(0), cells(ROOM + length)];
    let mut agents = Vec::new();
    for number in 0..robots {
        let side = if both_ways { number % 2 } else { 0 };
        let (start, goal) = (starts[side].pop(), goals[1 - side].pop());
        agents.push(json!({ "name": format!("R{number}"), "start": start, "goal": goal }));
    }
    let mut scene = json!({ "giveway": 1, "map": map, "agents": agents });
    if is_zone {
        scene["zones"] = json!([{ "name": "gate", "rect": [ROOM, ROW, ROOM + length - 1, ROW] }]);
        scene["constraints"] = json!([{ "kind": "capacity", "zone": "gate", "most": 1 }]);
    }
    scene.to_string()
}
