//! The bounds that a method puts on an old agent, or why it cannot keep them.

use std::collections::VecDeque;
use std::rc::Rc;

use giveway_model::{Agent, Cell, snapshot::RunningAgent};

use super::{CauseKind, Method};
use crate::{
    single::{Bounds, NoPlanAlone, has_to_be_at},
    terrain::{Terrain, Vertex},
};

/// Why an agent cannot be held to what a method asks of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MethodRefusal {
    pub(super) kind: CauseKind,
    pub(super) cell: Option<Cell>,
    /// The number of the rule of the scene's own that it is.
    pub(super) rule: Option<usize>,
}

impl MethodRefusal {
    const fn at(kind: CauseKind, cell: Cell) -> Self {
        Self {
            kind,
            cell: Some(cell),
            rule: None,
        }
    }
}

/// The refusal of every method: the agent would have to go to an obstacle.
pub(super) fn blocked(agent: &Agent, terrain: &Terrain) -> Option<(MethodRefusal, NoPlanAlone)> {
    let mut cells = agent.waypoints.iter().chain(&agent.goal);
    cells.find_map(|&cell| {
        let never = has_to_be_at(cell, terrain).err()?;
        Some((MethodRefusal::at(CauseKind::Obstacle, cell), never))
    })
}

/// The bounds of an agent under a method.
pub(super) fn bounds(
    method: Method,
    agent: &Agent,
    running: &RunningAgent,
    terrain: &Terrain,
) -> Result<Bounds, MethodRefusal> {
    if !running.is_old {
        return Ok(Bounds::Free);
    }
    let rest = running.cells();
    match method {
        Method::Replan => Ok(Bounds::Free),
        Method::Revise => along(agent, &rest, terrain),
        Method::Tunnel(width) => within(agent, &rest, terrain, width),
    }
}

/// The first obstacle on the rest of an old path.
pub(super) fn obstacle(rest: &[Cell], terrain: &Terrain) -> Option<MethodRefusal> {
    let mut rest = rest.iter();
    let blocked = rest.find(|&&cell| terrain.vertex(cell).is_none());
    blocked.map(|&cell| MethodRefusal::at(CauseKind::Obstacle, cell))
}

fn along(agent: &Agent, rest: &[Cell], terrain: &Terrain) -> Result<Bounds, MethodRefusal> {
    if let Some(fault) = obstacle(rest, terrain) {
        return Err(fault);
    }
    if let Some(goal) = agent.goal
        && rest.last() != Some(&goal)
    {
        return Err(MethodRefusal::at(CauseKind::Goal, goal));
    }
    let mut waypoints = agent.waypoints.iter();
    if let Some(&missed) = waypoints.find(|cell| !rest.contains(cell)) {
        return Err(MethodRefusal::at(CauseKind::Waypoint, missed));
    }
    let path: Vec<Vertex> = rest.iter().filter_map(|&c| terrain.vertex(c)).collect();
    Ok(Bounds::Along(Rc::new(path)))
}

fn within(
    agent: &Agent,
    rest: &[Cell],
    terrain: &Terrain,
    width: u32,
) -> Result<Bounds, MethodRefusal> {
    let mut tunnel = vec![false; terrain.size()];
    let mut queue = VecDeque::new();
    for v in rest.iter().filter_map(|&cell| terrain.vertex(cell)) {
        if let Some(inside) = tunnel.get_mut(v as usize)
            && !std::mem::replace(inside, true)
        {
            queue.push_back((v, 0));
        }
    }
    while let Some((v, steps)) = queue.pop_front() {
        if steps == width {
            continue;
        }
        for arc in terrain.arcs(v) {
            if let Some(inside) = tunnel.get_mut(arc.to as usize)
                && !std::mem::replace(inside, true)
            {
                queue.push_back((arc.to, steps + 1));
            }
        }
    }
    let holds = |cell: Cell| {
        let v = terrain.vertex(cell);
        v.is_some_and(|v| tunnel.get(v as usize) == Some(&true))
    };
    if let Some(goal) = agent.goal.filter(|&goal| !holds(goal)) {
        return Err(MethodRefusal::at(CauseKind::Goal, goal));
    }
    if let Some(&missed) = agent.waypoints.iter().find(|&&cell| !holds(cell)) {
        return Err(MethodRefusal::at(CauseKind::Waypoint, missed));
    }
    Ok(Bounds::Within(Rc::new(tunnel)))
}
