//! What robots are to do: orders given to them, or taken from what they deliver.

use std::collections::{BTreeMap, BTreeSet};

use super::facts::{Doing, Id, Node, Order, Warehouse};
use super::plan::{name, places};

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

fn idle(warehouse: &Warehouse) -> Vec<Task> {
    let robots = warehouse.robots.iter();
    robots
        .map(|(&robot, &(start, _))| Task::idle(robot, start))
        .collect()
}

/// Gives the orders to the robots in turn. A robot visits a shelf of each product,
/// then the picking station: it ends at that of its last order, unless a robot with
/// a smaller number ends there or any robot stays there; then it returns to its
/// start.
pub(super) fn in_turn(warehouse: &Warehouse, notes: &mut Vec<String>) -> Vec<Task> {
    let mut tasks = idle(warehouse);
    if warehouse.orders.is_empty() || tasks.is_empty() {
        if !tasks.is_empty() {
            notes.push(
                "The file has no orders: every robot's goal is its start. Give them goals."
                    .to_owned(),
            );
        }
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

/// What robots do in their plan: they visit the shelves that they lift and the
/// stations at which they deliver, and end where they end. Where two end at one
/// node, one of them ends where it was before.
pub(super) fn of_plan(warehouse: &Warehouse, notes: &mut Vec<String>) -> Vec<Task> {
    let mut tasks = idle(warehouse);
    let mut taken = BTreeSet::new();
    for task in &mut tasks {
        let doings = warehouse.doings.get(&task.robot);
        let places = doings.map_or_else(Vec::new, |doings| places(task.start, doings));
        for &(node, doing) in &places {
            let visits = matches!(doing, Doing::PickUp | Doing::Deliver(..));
            if visits && warehouse.nodes.contains(&node) {
                task.visit(node);
            }
        }
        let nodes = places.iter().rev().map(|&(node, _)| node);
        let mut ends = nodes.chain([task.start]);
        let last = places.last().map_or(task.start, |&(node, _)| node);
        let is_free = |node: &Node| !taken.contains(node) && warehouse.nodes.contains(node);
        let other = || warehouse.nodes.iter().copied().find(is_free);
        task.goal = ends.find(is_free).or_else(other).unwrap_or(last);
        taken.insert(task.goal);
    }
    notes.push(
        "Which robot serves which order is taken from the plan: robots visit the shelves that they lift and the stations at which they deliver."
            .to_owned(),
    );
    notes.extend(undelivered(warehouse));
    tasks
}

/// Whether the plan says who serves which order.
pub(super) fn delivers(warehouse: &Warehouse) -> bool {
    let doings = warehouse.doings.values().flat_map(BTreeMap::values);
    let mut doings = doings.map(|&(doing, _)| doing);
    doings.any(|doing| matches!(doing, Doing::Deliver(..)))
}

/// What is ordered and not delivered.
fn undelivered(warehouse: &Warehouse) -> Vec<String> {
    let mut delivered: BTreeMap<(Id, Id), Option<i64>> = BTreeMap::new();
    for (doing, _) in warehouse.doings.values().flat_map(BTreeMap::values) {
        if let Doing::Deliver(order, product, amount) = *doing {
            let sum = delivered.entry((order, product)).or_insert(Some(0));
            *sum = sum.zip(amount).map(|(sum, amount)| sum + i64::from(amount));
        }
    }
    let mut notes = Vec::new();
    for (id, order) in &warehouse.orders {
        for &(product, wanted) in &order.lines {
            let missing = match (delivered.get(&(*id, product)), wanted) {
                (None, _) => true,
                (Some(Some(sum)), Some(wanted)) => *sum < i64::from(wanted),
                _ => false,
            };
            if missing {
                notes.push(format!(
                    "The plan does not deliver all of product {product} of order {id}."
                ));
            }
        }
    }
    notes
}
