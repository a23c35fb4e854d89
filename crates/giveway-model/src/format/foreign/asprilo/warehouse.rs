//! From facts to a scene and its plan.

use std::collections::BTreeMap;

use super::facts::{Node, Warehouse};
use super::plan::{name, plan};
use super::tasks::{self, Task};
use crate::format::foreign::Held;
use crate::format::text::{position, shorten};
use crate::words::{and, count};
use crate::{Agent, Cell, Fault, Scene, tr};

/// How many kinds of facts that are not known a note names.
const MAX_NAMED: usize = 4;

/// The scene, the plan, or both that a file holds.
pub(super) fn held(text: &str, warehouse: &Warehouse) -> Result<Held, Fault> {
    let has_plan = !warehouse.doings.is_empty();
    if warehouse.nodes.is_empty() {
        // A plan in which no robot does anything has nothing but robots.
        if has_plan || !warehouse.robots.is_empty() {
            return plan(text, warehouse).map(Held::Plan);
        }
        let found = tr!("no node");
        let expected = tr!("facts init(object(node,1),value(at,(X,Y))), or a plan");
        return Err(Fault::at("", found, expected).in_text(1, 1));
    }
    check_robots(text, warehouse)?;
    let mut notes = Vec::new();
    let tasks = if tasks::delivers(warehouse) {
        tasks::of_plan(warehouse, &mut notes)
    } else {
        tasks::in_turn(warehouse, &mut notes)
    };
    notes.extend(left_out(warehouse));
    let scene = Scene {
        map: map(warehouse),
        agents: tasks.into_iter().map(agent).collect(),
        ..Scene::default()
    };
    if !has_plan {
        return Ok(Held::Scene(scene, notes));
    }
    let mut plan = plan(text, warehouse)?;
    plan.notes.splice(0..0, notes);
    Ok(Held::Both(scene, plan))
}

fn check_robots(text: &str, warehouse: &Warehouse) -> Result<(), Fault> {
    let mut starts = BTreeMap::new();
    for (id, &((x, y), offset)) in &warehouse.robots {
        let fault = |found: String, expected: &str| {
            let (line, column) = position(text, offset);
            Fault::at("", found, expected).in_text(line, column)
        };
        if !warehouse.nodes.contains(&(x, y)) {
            let found = tr!("robot {id} at ({x},{y}), where there is no node", id, x, y);
            return Err(fault(found, tr!("a node")));
        }
        if let Some(other) = starts.insert((x, y), id) {
            let found = tr!(
                "robot {id} at ({x},{y}), where robot {other} is, too",
                id,
                x,
                y,
                other
            );
            return Err(fault(found, tr!("a node of its own")));
        }
    }
    Ok(())
}

fn cell((x, y): Node) -> Cell {
    Cell::new(x.saturating_sub(1), y.saturating_sub(1))
}

fn agent(task: Task) -> Agent {
    Agent {
        name: name(task.robot),
        start: cell(task.start),
        goal: cell(task.goal),
        waypoints: task.waypoints.into_iter().map(cell).collect(),
        battery: None,
    }
}

fn map(warehouse: &Warehouse) -> Vec<String> {
    let width = warehouse.nodes.iter().map(|&(x, _)| x).max();
    let height = warehouse.nodes.iter().map(|&(_, y)| y).max();
    let row = |y| {
        let cell = |x| {
            if warehouse.nodes.contains(&(x, y)) {
                '.'
            } else {
                '#'
            }
        };
        (1..=width.unwrap_or(0)).map(cell).collect()
    };
    (1..=height.unwrap_or(0)).map(row).collect()
}

/// What is in the file and not in the scene.
fn left_out(warehouse: &Warehouse) -> Option<String> {
    let shelves = match warehouse.shelves.len() {
        1 => "1 shelf".to_owned(),
        n => format!("{n} shelves"),
    };
    let mut parts = vec![
        (
            warehouse.highways,
            count(warehouse.highways, "highway node"),
        ),
        (warehouse.shelves.len(), shelves),
        (
            warehouse.stations.len(),
            count(warehouse.stations.len(), "picking station"),
        ),
        (
            warehouse.products.len(),
            count(warehouse.products.len(), "product"),
        ),
    ];
    for (about, &facts) in warehouse.others.iter().take(MAX_NAMED) {
        parts.push((
            facts,
            format!("{} \"{}\"", count(facts, "fact"), shorten(about)),
        ));
    }
    let more = warehouse.others.len().saturating_sub(MAX_NAMED);
    parts.push((more, format!("facts of {more} other kinds")));
    let parts: Vec<String> = parts
        .into_iter()
        .filter_map(|(n, part)| (n > 0).then_some(part))
        .collect();
    if parts.is_empty() {
        return None;
    }
    Some(format!("Not kept as such: {}.", and(&parts)))
}
