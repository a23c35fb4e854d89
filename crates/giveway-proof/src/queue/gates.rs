//! Cells at which only so many agents can be, and that some cannot go round.

use std::collections::BTreeSet;

use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::{Cell, Instance};

use crate::Budget;

/// More cells than this are too many to try each of them.
const MOST_CELLS: usize = 6_000;

/// Some cells, and the agents that the limit on them binds.
pub(super) struct Gate {
    pub(super) cells: Vec<Cell>,
    /// How many of the agents may be there at a time.
    pub(super) most: u32,
    /// Whether that is so since they lie in a row where nobody passes another one.
    pub(super) is_row: bool,
    pub(super) agents: Vec<usize>,
}

/// All gates with at least so many agents; `None` where the budget ran out.
pub(super) fn all(instance: &Instance, fewest: usize, budget: &Budget<'_>) -> Option<Vec<Gate>> {
    let mut gates = zones(instance);
    let grid = instance.grid();
    let free: Vec<Cell> = grid
        .cells()
        .filter(|(_, ground)| ground.is_vertex())
        .map(|(cell, _)| cell)
        .collect();
    if free.len() <= MOST_CELLS {
        let mut seen = BTreeSet::new();
        for &cell in &free {
            if !(budget.go_on)() {
                return None;
            }
            if !seen.contains(&cell) && is_narrow(instance, cell) {
                let cells = row(instance, cell);
                seen.extend(cells.iter().copied());
                gates.push(Gate {
                    cells,
                    most: 1,
                    is_row: true,
                    agents: (0..instance.agents().len()).collect(),
                });
            }
        }
    }
    gates.retain(|gate| gate.agents.len() >= fewest);
    Some(gates)
}

/// The zones of limits that hold at all times.
fn zones(instance: &Instance) -> Vec<Gate> {
    let grid = instance.grid();
    let in_force = instance.constraints_in_force();
    let gates = in_force.filter_map(|rule| match &rule.constraint.kind {
        ConstraintKind::Capacity { zone, most, times } if *most > 0 => {
            let times = meant(*times);
            let always = times.first() == 0 && times.to.is_none();
            let zone = instance.zone(zone).filter(|_| always)?;
            Some(Gate {
                cells: zone
                    .cells()
                    .filter(|&cell| grid.is_vertex(cell))
                    .collect::<BTreeSet<_>>()
                    .into_iter()
                    .collect(),
                most: *most,
                is_row: false,
                agents: rule.agents,
            })
        }
        ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => None,
    });
    gates.collect()
}

/// Whether the neighbours of a cell cannot all reach each other near it: only then it may part the map.
fn is_narrow(instance: &Instance, cell: Cell) -> bool {
    let grid = instance.grid();
    let around = |dx: u32, dy: u32| {
        let (x, y) = ((cell.x + dx).checked_sub(1), (cell.y + dy).checked_sub(1));
        let corner = x.zip(y).map(|(x, y)| Cell::new(x, y));
        corner.is_some_and(|corner| grid.is_vertex(corner))
    };
    // The eight cells around it in a circle: free stretches that hold a neighbour.
    let ring = [
        (0, 0),
        (1, 0),
        (2, 0),
        (2, 1),
        (2, 2),
        (1, 2),
        (0, 2),
        (0, 1),
    ];
    let free = ring.map(|(dx, dy)| around(dx, dy));
    let is_side = |i: usize| !i.is_multiple_of(2);
    let joins = (0..8).filter(|&i| is_side(i) && free[i] && free[(i + 1) % 8] && free[(i + 2) % 8]);
    let sides = (0..8).filter(|&i| is_side(i) && free[i]).count();
    // (All four in a circle of free cells are joined four times.)
    sides > 1 && sides > joins.count() + 1
}

/// The cells around one that lie in a row between walls, up to the starts and goals of agents.
fn row(instance: &Instance, middle: Cell) -> Vec<Cell> {
    let grid = instance.grid();
    let is_taken = |cell: Cell| {
        let mut agents = instance.agents().iter();
        agents.any(|agent| agent.start == cell || agent.goal == Some(cell))
    };
    let has_two = |cell: Cell| grid.neighbours(cell).count() == 2 && !is_taken(cell);
    let mut cells = vec![middle];
    if !has_two(middle) {
        return cells;
    }
    for _ in 0..2 {
        while let Some(&end) = cells.last() {
            let mut next = grid.neighbours(end);
            let next = next.find(|&cell| has_two(cell) && !cells.contains(&cell));
            match next {
                Some(cell) => cells.push(cell),
                None => break,
            }
        }
        cells.reverse();
    }
    cells
}
