//! What is wrong with the map and the agents of a scene, each fault with its place.

use std::collections::{BTreeMap, BTreeSet};

use super::MAX_CAPACITY;
use crate::format::text::shorten;
use crate::{Agent, AtGoal, Cell, Fault, Grid, GridError, Ground, Scene, tr, tr_later};

/// The fault of a map that is none.
pub(super) fn map_fault(scene: &Scene, error: &GridError) -> Fault {
    match *error {
        GridError::Empty if scene.map.is_empty() => Fault::at(
            "map",
            tr_later!("no rows"),
            tr_later!("at least one row of cells"),
        ),
        GridError::Empty => Fault::at(
            "map[0]",
            tr_later!("an empty row"),
            tr_later!("at least one cell"),
        ),
        GridError::Ragged {
            row,
            found,
            expected,
        } => Fault::at(
            format!("map[{row}]"),
            tr!("a row of {n} cells", n = found),
            tr!("{width}, as in the first row", width = expected),
        ),
        GridError::Unknown { row, column, found } => Fault::at(
            format!("map[{row}][{column}]"),
            format!("\"{}\"", found.escape_debug()),
            tr_later!("one of . # ~ + *"),
        ),
    }
}

/// What is wrong with an agent by itself.
pub(super) fn check_agent(agents: &[Agent], i: usize, grid: &Grid, faults: &mut Vec<Fault>) {
    let Some(agent) = agents.get(i) else { return };
    let place = format!("agents[{i}]");
    if agent.name.is_empty() {
        faults.push(Fault::at(
            format!("{place}.name"),
            tr_later!("an empty name"),
            tr_later!("a name"),
        ));
    }
    let mut cell = |cell: Cell, key: String| match grid.ground(cell) {
        None => faults.push(Fault::at(
            key,
            // As it is written, however large.
            format!("({}, {})", cell.x, cell.y),
            tr!(
                "a cell of the {width} x {height} map",
                width = grid.width(),
                height = grid.height()
            ),
        )),
        Some(Ground::Obstacle) => {
            faults.push(Fault::at(
                key,
                tr!("the obstacle {cell}", cell),
                tr_later!("a free cell"),
            ));
        }
        Some(_) => {}
    };
    cell(agent.start, format!("{place}.start"));
    if let Some(goal) = agent.goal {
        cell(goal, format!("{place}.goal"));
    }
    for (k, &w) in agent.waypoints.iter().enumerate() {
        cell(w, format!("{place}.waypoints[{k}]"));
    }
    let mut seen = BTreeSet::new();
    for (k, w) in agent.waypoints.iter().enumerate() {
        if !seen.insert(w) {
            faults.push(Fault::at(
                format!("{place}.waypoints[{k}]"),
                tr!("{cell} again", cell = w),
                tr_later!("each waypoint once"),
            ));
        }
    }
    if let Some(battery) = agent.battery {
        if battery.capacity > MAX_CAPACITY {
            faults.push(Fault::at(
                format!("{place}.battery.capacity"),
                battery.capacity.to_string(),
                tr!("at most {most}", most = MAX_CAPACITY),
            ));
        }
        if battery.initial > battery.capacity {
            faults.push(Fault::at(
                format!("{place}.battery.initial"),
                battery.initial.to_string(),
                tr!(
                    "at most the capacity, {capacity}",
                    capacity = battery.capacity
                ),
            ));
        }
    }
}

/// Names, starts and goals that two agents share.
pub(super) fn check_shared(scene: &Scene, faults: &mut Vec<Fault>) {
    let mut names = BTreeMap::new();
    let mut starts = BTreeMap::new();
    let mut goals = BTreeMap::new();
    for (i, agent) in scene.agents.iter().enumerate() {
        if let Some(first) = names.insert(agent.name.as_str(), i)
            && !agent.name.is_empty()
        {
            faults.push(Fault::at(
                format!("agents[{i}].name"),
                tr!(
                    "\"{name}\", the name of agents[{first}]",
                    name = shorten(&agent.name),
                    first
                ),
                tr_later!("a name of its own"),
            ));
        }
        if let Some(first) = starts.insert(agent.start, agent.name.as_str()) {
            faults.push(Fault::at(
                format!("agents[{i}].start"),
                tr!("{start}, the start of {first}", start = agent.start, first),
                tr_later!("a start of its own"),
            ));
        }
        if scene.rules.at_goal == AtGoal::Stay
            && let Some(goal) = agent.goal
            && let Some(first) = goals.insert(goal, agent.name.as_str())
        {
            faults.push(Fault::at(
                format!("agents[{i}].goal"),
                tr!("{goal}, the goal of {first}", goal, first),
                tr_later!("a goal of its own, since robots stay at their goals"),
            ));
        }
    }
}
