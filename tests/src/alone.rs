//! One agent alone, a second and slow way: all its walks of a length, tried one by one.

use std::collections::BTreeMap;

use giveway_model::{Cell, Grid, Instance, Plan};

/// Walks that are tried.
const MOST: usize = 30_000;

/// The paths of an agent that begin with some entries and have so many steps, each with the charges
/// of which no more are allowed; `None` where there are too many.
pub fn paths(
    instance: &Instance,
    name: &str,
    (begin, charges): (&[Option<Cell>], &[u32]),
    steps: u32,
) -> Option<Vec<Plan>> {
    let agents = instance.agents();
    let agent = agents.iter().find(|agent| agent.name == name)?;
    let mut found = Vec::new();
    let mut open = vec![begin.to_vec()];
    while let Some(path) = open.pop() {
        if found.len() + open.len() > MOST {
            return None;
        }
        let now = path.len() as u32 - 1;
        let here = path.last().copied().flatten()?;
        if now == steps {
            found.push(path);
            continue;
        }
        for (cell, entries) in onward(instance.grid(), here) {
            let left = steps.checked_sub(now + entries.len() as u32);
            let far = agent.goal.map_or(0, |goal| distance(cell, goal));
            if left.is_some_and(|left| far <= left) {
                let mut path = path.clone();
                path.extend(entries);
                open.push(path);
            }
        }
    }
    let with_charges = |path: Vec<Option<Cell>>| {
        let mut all: Vec<u32> = charges.to_vec();
        if agent.battery.is_some() {
            let rest = (begin.len() as u32 - 1..steps).zip(&path[begin.len() - 1..]);
            let there =
                rest.filter(|(_, cell)| cell.is_some_and(|it| instance.grid().is_charger(it)));
            all.extend(there.map(|(time, _)| time));
        }
        let mut plan = Plan::default();
        plan.paths.insert(name.to_owned(), path);
        if !all.is_empty() {
            plan.charges.insert(name.to_owned(), all);
        }
        plan
    };
    Some(found.into_iter().map(with_charges).collect())
}

/// The entries of a path with which an agent at a cell goes on.
fn onward(grid: &Grid, here: Cell) -> Vec<(Cell, Vec<Option<Cell>>)> {
    let mut all = vec![(here, vec![Some(here)])];
    for next in grid.neighbours(here).filter(|&next| grid.is_vertex(next)) {
        let mut entries = vec![Some(next)];
        if grid.is_slow_edge(here, next) {
            entries.insert(0, None);
        }
        all.push((next, entries));
    }
    all
}

fn distance(a: Cell, b: Cell) -> u32 {
    a.x.abs_diff(b.x) + a.y.abs_diff(b.y)
}

/// A plan with the ways of another one where that has them.
pub fn replaced(plan: &Plan, other: &Plan) -> Plan {
    let mut plan = plan.clone();
    for (name, path) in &other.paths {
        plan.paths.insert(name.clone(), path.clone());
        plan.charges.remove(name);
    }
    let charges: BTreeMap<_, _> = other.charges.clone();
    plan.charges.extend(charges);
    plan
}
