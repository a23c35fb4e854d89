//! The list of changes: what a further one does to it.

use giveway_model::change::What;
use giveway_model::{Agent, Cell};

/// Adds a change. Where one of the list is about the same thing, that one
/// becomes what both are together: each thing stands in the list once.
pub(super) fn add(list: &mut Vec<What>, what: What) {
    match what {
        What::MoveObstacle { from, to } => move_obstacle(list, from, to),
        What::RemoveObstacle { cell } => remove_obstacle(list, cell),
        What::RemoveCharger { cell } => {
            if !take(list, |other| *other == What::AddCharger { cell }) {
                list.push(What::RemoveCharger { cell });
            }
        }
        What::AddCharger { cell } => {
            if !take(list, |other| *other == What::RemoveCharger { cell }) {
                list.push(What::AddCharger { cell });
            }
        }
        What::RemoveAgent { agent } => {
            let is_new = added(list, &agent).is_some();
            list.retain(|other| whose(other) != Some(agent.as_str()));
            if !is_new {
                list.push(What::RemoveAgent { agent });
            }
        }
        // What else was to become of it does not any more; that it joins then stays, and is refused.
        What::StopAgent { agent } => {
            let joins = |what: &What| matches!(what, What::AddAgent { .. });
            list.retain(|other| joins(other) || whose(other) != Some(agent.as_str()));
            list.push(What::StopAgent { agent });
        }
        What::SetGoal { agent, cell } => {
            if let Some(added) = added(list, &agent) {
                added.goal = Some(cell);
                return;
            }
            let is_goal =
                |other: &What| matches!(other, What::SetGoal { agent: a, .. } if *a == agent);
            take(list, is_goal);
            list.push(What::SetGoal { agent, cell });
        }
        What::AddWaypoint { agent, cell } => {
            if let Some(added) = added(list, &agent) {
                added.waypoints.push(cell);
                return;
            }
            list.push(What::AddWaypoint { agent, cell });
        }
        What::DropWaypoint { agent, cell } => {
            if let Some(added) = added(list, &agent) {
                added.waypoints.retain(|&waypoint| waypoint != cell);
                return;
            }
            let is_it = What::AddWaypoint {
                agent: agent.clone(),
                cell,
            };
            if !take(list, |other| *other == is_it) {
                list.push(What::DropWaypoint { agent, cell });
            }
        }
        What::SetBattery { agent, level } => {
            let is_level =
                |other: &What| matches!(other, What::SetBattery { agent: a, .. } if *a == agent);
            take(list, is_level);
            list.push(What::SetBattery { agent, level });
        }
        What::DelayAgent { agent, steps } => {
            let is_delay =
                |other: &What| matches!(other, What::DelayAgent { agent: a, .. } if *a == agent);
            take(list, is_delay);
            list.push(What::DelayAgent { agent, steps });
        }
        What::SetSlow { cells } => set_slow(list, cells, true),
        What::SetNormal { cells } => set_slow(list, cells, false),
        what => list.push(what),
    }
}

/// Cells that join or leave the slow zone: one change holds all that join, one
/// all that leave, and a cell that does both does neither.
fn set_slow(list: &mut Vec<What>, cells: Vec<Cell>, joins: bool) {
    for cell in cells {
        let undone = list.iter_mut().find_map(|what| match what {
            What::SetNormal { cells } if joins => take_cell(cells, cell),
            What::SetSlow { cells } if !joins => take_cell(cells, cell),
            _ => None,
        });
        if undone.is_some() {
            continue;
        }
        let like = list.iter_mut().find_map(|what| match what {
            What::SetSlow { cells } if joins => Some(cells),
            What::SetNormal { cells } if !joins => Some(cells),
            _ => None,
        });
        match like {
            Some(cells) if cells.contains(&cell) => {}
            Some(cells) => cells.push(cell),
            None if joins => list.push(What::SetSlow { cells: vec![cell] }),
            None => list.push(What::SetNormal { cells: vec![cell] }),
        }
    }
    list.retain(|what| !matches!(what, What::SetSlow { cells } | What::SetNormal { cells } if cells.is_empty()));
}

fn take_cell(cells: &mut Vec<Cell>, cell: Cell) -> Option<()> {
    let at = cells.iter().position(|other| *other == cell)?;
    cells.remove(at);
    Some(())
}

/// Takes the last change of a kind out; whether there was one.
fn take(list: &mut Vec<What>, is_it: impl Fn(&What) -> bool) -> bool {
    let found = list.iter().rposition(is_it);
    found.map(|index| list.remove(index)).is_some()
}

/// The agent of a name, where it comes by the list.
fn added<'a>(list: &'a mut [What], name: &str) -> Option<&'a mut Agent> {
    list.iter_mut().find_map(|what| match what {
        What::AddAgent { agent } if agent.name == name => Some(agent),
        _ => None,
    })
}

/// An obstacle that came or was moved by the list just stands elsewhere.
fn move_obstacle(list: &mut Vec<What>, from: Cell, to: Cell) {
    for what in list.iter_mut() {
        match what {
            What::AddObstacle { cell } if *cell == from => {
                *cell = to;
                return;
            }
            What::MoveObstacle { to: cell, .. } if *cell == from => {
                *cell = to;
                list.retain(|what| !matches!(what, What::MoveObstacle { from, to } if from == to));
                return;
            }
            _ => {}
        }
    }
    list.push(What::MoveObstacle { from, to });
}

fn remove_obstacle(list: &mut Vec<What>, cell: Cell) {
    if take(list, |other| *other == What::AddObstacle { cell }) {
        return;
    }
    let moved = list.iter_mut().find_map(|what| match what {
        What::MoveObstacle { from, to } if *to == cell => Some((*from, what)),
        _ => None,
    });
    match moved {
        Some((from, what)) => *what = What::RemoveObstacle { cell: from },
        None => list.push(What::RemoveObstacle { cell }),
    }
}

/// Whose change it is.
pub(super) fn whose(what: &What) -> Option<&str> {
    match what {
        What::AddAgent { agent } => Some(&agent.name),
        What::RemoveAgent { agent }
        | What::SetGoal { agent, .. }
        | What::AddWaypoint { agent, .. }
        | What::DropWaypoint { agent, .. }
        | What::SetBattery { agent, .. }
        | What::DelayAgent { agent, .. }
        | What::StopAgent { agent } => Some(agent),
        What::AddObstacle { .. }
        | What::RemoveObstacle { .. }
        | What::MoveObstacle { .. }
        | What::SetSlow { .. }
        | What::SetNormal { .. }
        | What::AddCharger { .. }
        | What::RemoveCharger { .. }
        | What::AddConstraint { .. }
        | What::RemoveConstraint { .. } => None,
    }
}
