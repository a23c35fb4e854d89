//! The map after the changes, and what is near on it.

use std::collections::BTreeSet;

use giveway_model::change::{Change, What};
use giveway_model::{Cell, Plan};

use super::super::world::World;

/// The rows of the map after the changes.
pub fn edited(rows: &[String], changes: &[Change]) -> Vec<String> {
    let mut rows: Vec<Vec<char>> = rows.iter().map(|row| row.chars().collect()).collect();
    let mut set = |cell: &Cell, to: &dyn Fn(char) -> char| {
        let c = &mut rows[cell.y as usize][cell.x as usize];
        *c = to(*c);
    };
    let is_slow = |c: char| matches!(c, '~' | '*');
    let is_charger = |c: char| matches!(c, '+' | '*');
    let slow = |c: char| if is_charger(c) { '*' } else { '~' };
    let normal = |c: char| if is_charger(c) { '+' } else { '.' };
    let charger = |c: char| if is_slow(c) { '*' } else { '+' };
    let none = |c: char| if is_slow(c) { '~' } else { '.' };
    for change in changes {
        match &change.what {
            What::AddObstacle { cell } => set(cell, &|_| '#'),
            What::RemoveObstacle { cell } => set(cell, &|_| '.'),
            What::MoveObstacle { from, to } => {
                set(from, &|_| '.');
                set(to, &|_| '#');
            }
            What::SetSlow { cells } => cells.iter().for_each(|cell| set(cell, &slow)),
            What::SetNormal { cells } => cells.iter().for_each(|cell| set(cell, &normal)),
            What::AddCharger { cell } => set(cell, &charger),
            What::RemoveCharger { cell } => set(cell, &none),
            _ => {}
        }
    }
    rows.iter().map(|row| row.iter().collect()).collect()
}

/// The map with an obstacle where each agent stands that breaks down for good, as its plan has it:
/// at the end of a slow move under way.
pub fn standing(rows: &[String], plan: &Plan, changes: &[Change]) -> Vec<String> {
    let mut rows: Vec<Vec<char>> = rows.iter().map(|row| row.chars().collect()).collect();
    for change in changes {
        let What::StopAgent { agent } = &change.what else {
            continue;
        };
        let path = plan.path(agent);
        let from = plan.from.get(agent).copied().unwrap_or(0);
        let now = change.at.saturating_sub(from) as usize;
        let place = path.iter().skip(now).flatten().next();
        if let Some(cell) = place.or(path.iter().flatten().last()) {
            rows[cell.y as usize][cell.x as usize] = '#';
        }
    }
    rows.iter().map(|row| row.iter().collect()).collect()
}

/// The cells within so many steps of others.
pub(super) fn around(world: &World, cells: &[Cell], width: u32) -> BTreeSet<Cell> {
    let free = |cell: &Cell| {
        let mut sides = world.neighbours(*cell).into_iter();
        sides.any(|side| world.neighbours(side).contains(cell))
    };
    let mut found: BTreeSet<Cell> = cells.iter().copied().collect();
    let mut edge: Vec<Cell> = cells.iter().copied().filter(|cell| free(cell)).collect();
    for _ in 0..width {
        let mut next = Vec::new();
        for cell in edge {
            next.extend(world.neighbours(cell));
        }
        found.extend(next.iter().copied());
        edge = next;
    }
    found
}
