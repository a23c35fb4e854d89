//! From facts to a scene and its plan.

use std::collections::BTreeMap;

use super::facts::{Node, Warehouse};
use super::plan::{name, plan};
use super::tasks::{self, Task};
use crate::{Held, OpenGoals, Remarks};
use giveway_model::format::text::{at_byte, shorten};
use giveway_model::words::{and, count};
use giveway_model::{Agent, Assumption, Cell, Fault, LeftOutRule, Scene, tr};

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
    let mut remarks = Remarks {
        open: OpenGoals::Orders(tasks::orders(warehouse)),
        ..Remarks::default()
    };
    let tasks = tasks::in_turn(warehouse, &mut remarks.chosen);
    let mut assumptions = warehouse.unknown().assumptions();
    if !tasks.is_empty() {
        assumptions.insert(0, Assumption::GoalsChosen);
    }
    // With a picking station robots carry shelves to it (domains A to C); without one it is
    // enough to be at a shelf (domain M).
    let mut orders = warehouse.orders.values();
    if orders.any(|order| order.station.is_some()) {
        let rule = LeftOutRule::Handling;
        assumptions.push(Assumption::RuleLeftOut { rule });
    }
    remarks.notes.extend(left_out(warehouse));
    let scene = Scene {
        map: map(warehouse),
        agents: tasks.into_iter().map(agent).collect(),
        assumptions,
        ..Scene::default()
    };
    if !has_plan {
        return Ok(Held::Scene(scene, remarks));
    }
    Ok(Held::Both(scene, remarks, plan(text, warehouse)?))
}

fn check_robots(text: &str, warehouse: &Warehouse) -> Result<(), Fault> {
    let mut starts = BTreeMap::new();
    for (id, &((x, y), offset)) in &warehouse.robots {
        let fault =
            |found: String, expected: &str| at_byte(text, offset, Fault::at("", found, expected));
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
        waypoints: task.waypoints.into_iter().map(cell).collect(),
        ..Agent::new(name(task.robot), cell(task.start), Some(cell(task.goal)))
    }
}

fn map(warehouse: &Warehouse) -> Vec<String> {
    let width = warehouse.nodes.iter().map(|&(x, _)| x).max();
    let height = warehouse.nodes.iter().map(|&(_, y)| y).max();
    let row = |y| {
        let is_node = |x| warehouse.nodes.contains(&(x, y));
        let cell = |x| if is_node(x) { '.' } else { '#' };
        (1..=width.unwrap_or(0)).map(cell).collect()
    };
    (1..=height.unwrap_or(0)).map(row).collect()
}

/// The parts of the file that are not in the scene.
fn left_out(warehouse: &Warehouse) -> Option<String> {
    let shelves = match warehouse.shelves.len() {
        1 => "1 shelf".to_owned(),
        n => format!("{n} shelves"),
    };
    let counted = |n: usize, what| (n, count(n, what));
    let mut parts = vec![
        counted(warehouse.highways, "highway node"),
        (warehouse.shelves.len(), shelves),
        counted(warehouse.stations.len(), "picking station"),
        counted(warehouse.products.len(), "product"),
    ];
    for (about, &facts) in warehouse.others.iter().take(MAX_NAMED) {
        parts.push((
            facts,
            format!("{} \"{}\"", count(facts, "fact"), shorten(about)),
        ));
    }
    let more = warehouse.others.len().saturating_sub(MAX_NAMED);
    parts.push((more, format!("facts of {more} other kinds")));
    let parts = parts.into_iter();
    let parts: Vec<String> = parts
        .filter_map(|(n, part)| (n > 0).then_some(part))
        .collect();
    (!parts.is_empty()).then(|| format!("Not kept as such: {}.", and(&parts)))
}
