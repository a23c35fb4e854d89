//! Where steps are lost: at the cell that an agent leaves when its least arrival rises.

use std::collections::BTreeMap;

use giveway_model::{Cell, sorting::map};
use giveway_planners::lost::earliest_arrivals;

use super::{AgentDelay, CellLoss, running::RunningPlan};
use crate::{
    budget::{Budget, Stop},
    problem::Problem,
    single::Place,
    walk::Walk,
};

/// The cells at which an agent loses its delay, in the order of its walk.
///
/// # Errors
/// When the budget is spent, or what is found does not add up to the delay.
pub(super) fn lost(
    running: &RunningPlan,
    problem: &Problem,
    (agent, walk): (usize, &Walk),
    delay: u32,
    budget: &Budget,
) -> Result<Vec<CellLoss>, Stop> {
    if delay == 0 {
        return Ok(Vec::new());
    }
    let name = &running.instance.agents()[agent].name;
    let charges = running.plan.charges(name);
    let f_values = earliest_arrivals(problem, agent, walk, charges, budget)?;
    let f_values = f_values.ok_or(Stop::Contradiction)?;
    let mut lost: Vec<CellLoss> = Vec::new();
    // Leaving its goal, it also loses the steps that it rested there.
    let mut rested = match f_values.first() {
        Some(0) => problem.tasks[agent].cost_if_it_leaves_goal,
        _ => 0,
    };
    for (pair, place) in f_values.windows(2).zip(walk) {
        let steps = pair[1].saturating_sub(pair[0]);
        if steps == 0 {
            continue;
        }
        // An agent in transit goes on in any case.
        let Place::At(v) = *place else { continue };
        let (cell, steps) = (problem.terrain.cell(v), steps + std::mem::take(&mut rested));
        match lost.iter_mut().find(|it| it.cell == cell) {
            Some(known) => known.steps += steps,
            None => lost.push(CellLoss { cell, steps }),
        }
    }
    if lost.iter().map(|it| it.steps).sum::<u32>() != delay {
        return Err(Stop::Contradiction);
    }
    Ok(lost)
}

/// The steps that all agents lose at each cell, row by row.
pub(super) fn heat(rows: &[AgentDelay]) -> Vec<CellLoss> {
    let mut heat: BTreeMap<(u32, u32), CellLoss> = map(std::iter::empty());
    for loss in rows.iter().flat_map(|row| &row.lost) {
        let nothing = CellLoss { steps: 0, ..*loss };
        heat.entry(row_by_row(loss.cell)).or_insert(nothing).steps += loss.steps;
    }
    heat.into_values().collect()
}

/// The place of a cell in the order in which maps are read.
const fn row_by_row(cell: Cell) -> (u32, u32) {
    (cell.y, cell.x)
}
