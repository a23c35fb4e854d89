//! What was edited of a scene, and whether a step allows it.

use giveway_model::{Cell, Grid, Ground};

use super::fixed::is_same_but_for_board;
use super::{Situation, Why, robots};
use crate::lesson::{Step, Tool};

/// An edit that a step does not allow.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outside {
    /// Of a cell that may not be changed, or not in this way.
    Cell(Cell),
    /// Of a robot.
    Robot(String),
    /// Of the size of the map, its rules or its costs.
    Rules,
}

/// What was done with a scene.
#[derive(Clone, Debug, Default)]
pub(super) struct Count {
    /// How many edits that takes.
    pub(super) edits: u32,
    /// The cells that have something now which they had not.
    pub(super) edited: Vec<Cell>,
    /// The cells that a robot or its goal was taken from.
    pub(super) left: Vec<Cell>,
}

/// The cells that were edited, and those of the robots that were.
///
/// # Errors
/// Where the step does not allow it, with what it does not.
pub(super) fn allowed(situation: Situation<'_>) -> Result<Vec<Cell>, Why> {
    let Situation { step, start, scene } = situation;
    let grids = (Grid::from_rows(&start.map), Grid::from_rows(&scene.map));
    let (Ok(before), Ok(now)) = grids else {
        return Err(Why::Outside(Outside::Rules));
    };
    let is_same_size = (before.width(), before.height()) == (now.width(), now.height());
    if !is_same_size || !is_same_but_for_board(start, scene, &now) {
        return Err(Why::Outside(Outside::Rules));
    }
    let mut count = Count::default();
    for y in 0..now.height() {
        for x in 0..now.width() {
            let cell = Cell::new(x, y);
            let (Some(was), Some(is)) = (before.ground(cell), now.ground(cell)) else {
                continue;
            };
            if was != is {
                tool(step, tools(was, is), Outside::Cell(cell))?;
                count.edits += 1;
                count.edited.push(cell);
            }
        }
    }
    robots::compare(situation, &mut count)?;
    let mut touched = count.edited.iter().chain(&count.left);
    if let Some(cell) = touched.find(|cell| !may_change(step, **cell)) {
        return Err(Why::Outside(Outside::Cell(*cell)));
    }
    match step.edits {
        Some(allowed) if count.edits > allowed => Err(Why::TooManyEdits {
            made: count.edits,
            allowed,
        }),
        _ => Ok(count.edited),
    }
}

fn may_change(step: &Step, cell: Cell) -> bool {
    step.cells
        .as_ref()
        .is_none_or(|cells| cells.contains(&cell))
}

/// Whether a step has one of some tools.
///
/// # Errors
/// Where it has none of them, with what was done without.
pub(super) fn tool(step: &Step, any: &[Tool], outside: Outside) -> Result<(), Why> {
    if any.iter().any(|tool| step.tools.contains(tool)) {
        Ok(())
    } else {
        Err(Why::Outside(outside))
    }
}

/// The tools by which a cell may become what it is.
const fn tools(was: Ground, is: Ground) -> &'static [Tool] {
    let becomes_charger = is.is_charger() && !was.is_charger();
    let becomes_slow = is.is_slow() && !was.is_slow();
    match (is, was) {
        (Ground::Obstacle, _) => &[Tool::Obstacle, Tool::Move],
        _ if becomes_charger => &[Tool::Charger, Tool::Move],
        _ if becomes_slow => &[Tool::SlowZone],
        (_, Ground::Obstacle) => &[Tool::Obstacle, Tool::Erase, Tool::Move],
        (_, Ground::Charger | Ground::SlowCharger) => &[Tool::Charger, Tool::Erase, Tool::Move],
        _ => &[Tool::SlowZone, Tool::Erase],
    }
}
