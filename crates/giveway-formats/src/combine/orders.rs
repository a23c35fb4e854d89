//! Orders that any robot may serve, given to the robots that serve them in a plan.

use std::collections::{BTreeMap, BTreeSet};

use super::open::is_free;
use crate::{Handling, Orders, WrittenPlan};
use giveway_model::{Cell, Plan, Scene, tr};

/// The goods that the robots of a plan handle, and when, by the robots' names.
#[derive(Default)]
pub(super) struct Handled<'a>(BTreeMap<&'a str, &'a [(usize, Handling)]>);

impl<'a> Handled<'a> {
    /// The goods that are handled in a plan.
    pub(super) fn of(plan: &'a WrittenPlan) -> Self {
        let named = plan
            .agents
            .iter()
            .filter_map(|agent| Some((agent.name.as_deref()?, agent.handling.as_slice())));
        Self(named.collect())
    }

    /// Whether no robot handles anything.
    pub(super) fn is_empty(&self) -> bool {
        self.0.values().all(|handled| handled.is_empty())
    }

    /// Whether the plan says who serves which order.
    pub(super) fn delivers(&self) -> bool {
        self.deliveries().next().is_some()
    }

    /// Order, product and amount of all deliveries.
    fn deliveries(&self) -> impl Iterator<Item = (i32, i32, Option<i32>)> {
        let handled = self.0.values().flat_map(|handled| handled.iter());
        handled.filter_map(|(_, handling)| match *handling {
            Handling::Deliver {
                order,
                product,
                amount,
            } => Some((order, product, amount)),
            Handling::PickUp => None,
        })
    }
}

/// Gives the robots what they do in their plan: they visit the shelves that they lift and the
/// stations at which they deliver, and end where they end. Where two end at one cell, one of
/// them ends where it was before. What is to be said of it.
pub(super) fn serve(
    scene: &mut Scene,
    orders: &Orders,
    plan: &Plan,
    handled: &Handled<'_>,
) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let mut tasks = Vec::with_capacity(scene.agents.len());
    for agent in &scene.agents {
        let path = plan.path(&agent.name);
        let mut waypoints: Vec<Cell> = Vec::new();
        for (time, _) in handled.0.get(&*agent.name).copied().unwrap_or_default() {
            if let Some(cell) = path.get(*time).copied().flatten()
                && is_free(scene, cell)
                && !waypoints.contains(&cell)
            {
                waypoints.push(cell);
            }
        }
        let cells = path.iter().rev().copied().flatten();
        let is_left = |cell: &Cell| !taken.contains(cell) && is_free(scene, *cell);
        let end = cells.chain([agent.start]).find(is_left);
        let goal = end.or_else(|| cells_of(scene).find(is_left));
        let goal = goal.unwrap_or(agent.start);
        taken.insert(goal);
        tasks.push((goal, waypoints));
    }
    for (agent, (goal, waypoints)) in scene.agents.iter_mut().zip(tasks) {
        (agent.goal, agent.waypoints) = (Some(goal), waypoints);
    }
    let mut notes = vec![tr!("Which robot serves which order is taken from the plan: robots visit the shelves that they lift and the stations at which they deliver.").to_owned()];
    notes.extend(undelivered(orders, handled));
    notes
}

/// All cells of the map.
fn cells_of(scene: &Scene) -> impl Iterator<Item = Cell> {
    let rows = (0..).zip(&scene.map);
    rows.flat_map(|(y, row)| (0..).zip(row.chars()).map(move |(x, _)| Cell::new(x, y)))
}

/// The orders that are not delivered.
fn undelivered(orders: &Orders, handled: &Handled<'_>) -> Vec<String> {
    let mut delivered: BTreeMap<(i32, i32), Option<i64>> = BTreeMap::new();
    for (order, product, amount) in handled.deliveries() {
        let sum = delivered.entry((order, product)).or_insert(Some(0));
        *sum = sum.zip(amount).map(|(sum, amount)| sum + i64::from(amount));
    }
    let lines = orders.lines.iter();
    let missing = lines.filter(|&&(order, product, wanted)| {
        match (delivered.get(&(order, product)), wanted) {
            (None, _) => true,
            (Some(Some(sum)), Some(wanted)) => *sum < i64::from(wanted),
            (Some(None), _) | (Some(Some(_)), None) => false,
        }
    });
    missing
        .map(|(order, product, _)| {
            tr!(
                "The plan does not deliver all of product {product} of order {order}.",
                product,
                order
            )
        })
        .collect()
}
