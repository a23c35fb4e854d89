//! What was edited of a scene, and whether a step allows it.

use giveway_model::{Agent, Cell, Grid, Ground, Scene};

use super::{Situation, Why};
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

/// The cells that were edited, and those of the robots that were.
///
/// # Errors
/// Where the step does not allow it, with what it does not.
pub(super) fn allowed(situation: Situation<'_>) -> Result<Vec<Cell>, Why> {
    let Situation { step, start, scene } = situation;
    let fixed = (start.rules, &start.objective) == (scene.rules, &scene.objective);
    let grids = (Grid::from_rows(&start.map), Grid::from_rows(&scene.map));
    let (Ok(before), Ok(now)) = grids else {
        return Err(Why::Outside(Outside::Rules));
    };
    if !fixed || (before.width(), before.height()) != (now.width(), now.height()) {
        return Err(Why::Outside(Outside::Rules));
    }
    let mut edited = Vec::new();
    let mut edits = 0;
    for y in 0..now.height() {
        for x in 0..now.width() {
            let cell = Cell::new(x, y);
            let (Some(was), Some(is)) = (before.ground(cell), now.ground(cell)) else {
                continue;
            };
            if was != is {
                tool(step, tools(was, is), Outside::Cell(cell))?;
                edits += 1;
                edited.push(cell);
            }
        }
    }
    robots(situation, &mut edits, &mut edited)?;
    if let Some(cell) = edited.iter().find(|cell| !may_change(step, **cell)) {
        return Err(Why::Outside(Outside::Cell(*cell)));
    }
    match step.edits {
        Some(allowed) if edits > allowed => Err(Why::TooManyEdits {
            made: edits,
            allowed,
        }),
        _ => Ok(edited),
    }
}

fn may_change(step: &Step, cell: Cell) -> bool {
    step.cells
        .as_ref()
        .is_none_or(|cells| cells.contains(&cell))
}

fn tool(step: &Step, any: &[Tool], outside: Outside) -> Result<(), Why> {
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

fn robots(situation: Situation<'_>, edits: &mut u32, edited: &mut Vec<Cell>) -> Result<(), Why> {
    let Situation { step, start, scene } = situation;
    for agent in &scene.agents {
        let outside = || Outside::Robot(agent.name.clone());
        match by_name(start, &agent.name) {
            None => {
                tool(step, &[Tool::Robot], outside())?;
                *edits += 1;
                edited.push(agent.start);
                edited.extend(agent.goal);
            }
            Some(before) => moved(step, before, agent, edits, edited)?,
        }
    }
    for agent in &start.agents {
        if by_name(scene, &agent.name).is_none() {
            let outside = Outside::Robot(agent.name.clone());
            tool(step, &[Tool::Erase], outside)?;
            *edits += 1;
        }
    }
    Ok(())
}

fn moved(
    step: &Step,
    before: &Agent,
    agent: &Agent,
    edits: &mut u32,
    edited: &mut Vec<Cell>,
) -> Result<(), Why> {
    let outside = || Outside::Robot(agent.name.clone());
    if before.battery != agent.battery {
        return Err(Why::Outside(outside()));
    }
    if before.start != agent.start {
        tool(step, &[Tool::Move], outside())?;
        *edits += 1;
        edited.push(agent.start);
    }
    if before.goal != agent.goal {
        tool(step, &[Tool::Goal, Tool::Move], outside())?;
        *edits += 1;
        edited.extend(agent.goal.or(before.goal));
    }
    let other = |one: &Agent, two: &Agent| -> Vec<Cell> {
        let cells = one.waypoints.iter().copied();
        cells.filter(|cell| !two.waypoints.contains(cell)).collect()
    };
    let (new, gone) = (other(agent, before), other(before, agent));
    if !new.is_empty() || !gone.is_empty() {
        tool(step, &[Tool::Waypoint, Tool::Move], outside())?;
        *edits += new.len().max(gone.len()) as u32;
        edited.extend(new);
    }
    Ok(())
}

fn by_name<'a>(scene: &'a Scene, name: &str) -> Option<&'a Agent> {
    scene.agents.iter().find(|agent| agent.name == name)
}
