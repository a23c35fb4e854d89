//! How a plan uses the floor: its busiest cells, and the most agents in a zone at once.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cell, Grid, Plan};

/// How often each cell is used: a cell at which an agent rests no longer counts.
pub(super) fn busy(plan: &Plan) -> BTreeMap<Cell, usize> {
    let mut busy = BTreeMap::new();
    for cell in plan.paths.values().flatten().flatten() {
        *busy.entry(*cell).or_insert(0) += 1;
    }
    busy
}

/// The cells, the busiest first.
pub(super) fn by_use(busy: &BTreeMap<Cell, usize>) -> Vec<Cell> {
    let mut cells: Vec<(usize, Cell)> = busy.iter().map(|(&cell, &count)| (count, cell)).collect();
    cells.sort_by_key(|&(count, cell)| (usize::MAX - count, cell));
    cells.into_iter().map(|(_, cell)| cell).collect()
}

/// All cells that can be reached from one, the nearest first.
pub(super) fn around(grid: &Grid, centre: Cell) -> Vec<Cell> {
    let mut cells = vec![centre];
    let mut seen = BTreeSet::from([centre]);
    let mut next = 0;
    while let Some(&cell) = cells.get(next) {
        next += 1;
        cells.extend(grid.neighbours(cell).filter(|&cell| seen.insert(cell)));
    }
    cells
}

/// The most agents that are in a zone at once.
pub(super) fn most_at_once(plan: &Plan, grid: &Grid, zone: &[Cell]) -> u32 {
    let last = plan.paths.values().map(Vec::len).max().unwrap_or(0);
    let is_inside = |path: &[Option<Cell>], time: usize| match path.get(time) {
        Some(Some(cell)) => zone.contains(cell),
        // In transit it is at both ends.
        Some(None) => [time.checked_sub(1), Some(time + 1)]
            .into_iter()
            .flatten()
            .filter_map(|time| path.get(time).copied().flatten())
            .any(|cell| zone.contains(&cell)),
        None => path
            .last()
            .copied()
            .flatten()
            .is_some_and(|cell| zone.contains(&cell) && grid.is_vertex(cell)),
    };
    let count = |time: usize| {
        let paths = plan.paths.values();
        paths.filter(|path| is_inside(path, time)).count() as u32
    };
    (0..last).map(count).max().unwrap_or(0)
}
