//! The tasks of robots: orders given to them in turn.

use std::collections::BTreeSet;

use super::facts::{Id, Node, Order, Warehouse};
use super::plan::name;
use crate::Orders;
use giveway_model::Cell;

/// The task of a robot: where it ends, and what it visits.
#[derive(Debug)]
pub(super) struct Task {
    pub(super) robot: Id,
    pub(super) start: Node,
    pub(super) goal: Node,
    pub(super) waypoints: Vec<Node>,
}

impl Task {
    const fn idle(robot: Id, start: Node) -> Self {
        Self {
            robot,
            start,
            goal: start,
            waypoints: Vec::new(),
        }
    }

    fn visit(&mut self, node: Node) {
        if !self.waypoints.contains(&node) {
            self.waypoints.push(node);
        }
    }
}

/// Gives the orders to the robots in turn. A robot visits a shelf of each product,
/// then the picking station: it ends at that of its last order, unless a robot with
/// a smaller number ends there or any robot stays there; then it returns to its
/// start.
pub(super) fn in_turn(warehouse: &Warehouse, notes: &mut Vec<String>) -> Vec<Task> {
    let robots = warehouse.robots.iter();
    let idle = robots.map(|(&robot, &(start, _))| Task::idle(robot, start));
    let mut tasks: Vec<Task> = idle.collect();
    if tasks.is_empty() {
        return tasks;
    }
    if warehouse.orders.is_empty() {
        let note = "The file has no orders: every robot's goal is its start. Give them goals.";
        notes.push(note.to_owned());
        return tasks;
    }
    let mut stations: Vec<Vec<Node>> = vec![Vec::new(); tasks.len()];
    let robots = tasks.len();
    for (i, (id, order)) in warehouse.orders.iter().enumerate() {
        let robot = i % robots;
        let Some(task) = tasks.get_mut(robot) else {
            continue;
        };
        for shelf in shelves(warehouse, *id, order, notes) {
            task.visit(shelf);
        }
        let station = order.station.and_then(|id| warehouse.stations.get(&id));
        let station = station.filter(|node| warehouse.nodes.contains(node));
        if let (Some(&station), Some(own)) = (station, stations.get_mut(robot)) {
            own.push(station);
        } else {
            notes.push(format!("Order {id} has no picking station with a place."));
        }
    }
    let goals = goals(&tasks, &stations);
    let away = goals
        .iter()
        .zip(&stations)
        .any(|(goal, own)| goal.is_none() && !own.is_empty());
    for ((task, goal), stations) in tasks.iter_mut().zip(goals).zip(stations) {
        for station in stations {
            if goal != Some(station) {
                task.visit(station);
            }
        }
        task.goal = goal.unwrap_or(task.start);
    }
    if let (Some(first), Some(task)) = (warehouse.orders.keys().next(), tasks.first()) {
        let robot = name(task.robot);
        notes.push(format!(
            "Any robot may serve an order in asprilo. Here they are given to the robots in turn, order {first} to {robot}."
        ));
    }
    if away {
        notes.push(
            "Robots that share a picking station visit it; only one ends there, the others end at their starts."
                .to_owned(),
        );
    }
    tasks
}

/// The orders.
pub(super) fn orders(warehouse: &Warehouse) -> Orders {
    let lines = warehouse.orders.iter().flat_map(|(&id, order)| {
        let lines = order.lines.iter();
        lines.map(move |&(product, amount)| (id, product, amount))
    });
    let lines: Vec<(Id, Id, Option<i32>)> = lines.collect();
    let products: BTreeSet<Id> = lines.iter().map(|&(_, product, _)| product).collect();
    let cells = |product: &Id| {
        let shelves = warehouse.products.get(product).into_iter().flatten();
        let nodes = shelves.filter_map(|shelf| warehouse.shelves.get(shelf));
        let cell = |&(x, y): &Node| Cell::new(x.saturating_sub(1), y.saturating_sub(1));
        nodes.map(cell).collect()
    };
    Orders {
        shelves: products.iter().map(cells).collect(),
        lines,
    }
}

/// The nodes of the shelves of an order's products: of each the shelf with the
/// smallest number that has a place.
fn shelves(warehouse: &Warehouse, id: Id, order: &Order, notes: &mut Vec<String>) -> Vec<Node> {
    let mut nodes = Vec::new();
    for (product, _) in &order.lines {
        let shelves = warehouse.products.get(product).into_iter().flatten();
        let placed = shelves.filter_map(|shelf| warehouse.shelves.get(shelf));
        let mut placed = placed.filter(|node| warehouse.nodes.contains(node));
        match placed.next() {
            Some(&node) => nodes.push(node),
            None => notes.push(format!(
                "Product {product} of order {id} is on no shelf with a place."
            )),
        }
    }
    nodes
}

/// The station at which each robot ends; `None` for its start. No two robots end at
/// one node.
fn goals(tasks: &[Task], stations: &[Vec<Node>]) -> Vec<Option<Node>> {
    let mut goals: Vec<Option<Node>> = stations.iter().map(|own| own.last().copied()).collect();
    loop {
        let homes = tasks.iter().zip(&goals).filter(|(_, goal)| goal.is_none());
        let mut taken: BTreeSet<Node> = homes.map(|(task, _)| task.start).collect();
        let mut is_changed = false;
        for goal in &mut goals {
            if let Some(node) = *goal
                && !taken.insert(node)
            {
                *goal = None;
                is_changed = true;
            }
        }
        if !is_changed {
            return goals;
        }
    }
}
