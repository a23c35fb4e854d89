//! The robots of a scene that was edited, against those that it began with.

use giveway_model::{Agent, Cell};

use super::edits::{Count, Outside, tool};
use super::fixed::{is_as_placed, is_same_but_for_places};
use super::{Situation, Why};
use crate::lesson::{Step, Tool};

/// Counts what was done with robots.
///
/// # Errors
/// Where the step does not allow it, with what it does not.
pub(super) fn compare(situation: Situation<'_>, count: &mut Count) -> Result<(), Why> {
    let Situation { step, start, scene } = situation;
    // Those that stay keep their order; who comes stands behind them.
    let mut left = start.agents.as_slice();
    for agent in &scene.agents {
        let place = left.iter().position(|other| other.name == agent.name);
        let Some((gone, [before, rest @ ..])) = place.map(|place| left.split_at(place)) else {
            came(situation, agent, count)?;
            continue;
        };
        let mut moves = count.clone();
        if let Err(why) = moved(step, before, agent, &mut moves) {
            // Taken away, and placed anew under the same name.
            removed(step, before, count).map_err(|_| why.clone())?;
            came(situation, agent, count).map_err(|_| why)?;
        } else {
            *count = moves;
        }
        for agent in gone {
            removed(step, agent, count)?;
        }
        left = rest;
    }
    for agent in left {
        removed(step, agent, count)?;
    }
    Ok(())
}

fn outside(agent: &Agent) -> Outside {
    Outside::Robot(agent.name.clone())
}

fn came(situation: Situation<'_>, agent: &Agent, count: &mut Count) -> Result<(), Why> {
    let Situation { step, start, scene } = situation;
    tool(step, &[Tool::Robot], outside(agent))?;
    let may = |tool: Tool| step.tools.contains(&tool);
    let has_places = (agent.goal.is_some() || may(Tool::Erase))
        && (agent.waypoints.is_empty() || may(Tool::Waypoint));
    if !has_places || !is_as_placed(start, scene, agent, may(Tool::Erase)) {
        return Err(Why::Outside(outside(agent)));
    }
    count.edits += 1 + agent.waypoints.len() as u32;
    count.edited.push(agent.start);
    count.edited.extend(agent.goal);
    count.edited.extend(&agent.waypoints);
    Ok(())
}

fn removed(step: &Step, agent: &Agent, count: &mut Count) -> Result<(), Why> {
    tool(step, &[Tool::Erase], outside(agent))?;
    count.edits += 1;
    count.left.push(agent.start);
    Ok(())
}

fn moved(step: &Step, before: &Agent, agent: &Agent, count: &mut Count) -> Result<(), Why> {
    if !is_same_but_for_places(before, agent) {
        return Err(Why::Outside(outside(agent)));
    }
    if before.start != agent.start {
        tool(step, &[Tool::Move], outside(agent))?;
        count.edits += 1;
        count.edited.push(agent.start);
    }
    match (before.goal, agent.goal) {
        (one, other) if one == other => {}
        (Some(erased), None) => {
            tool(step, &[Tool::Erase], outside(agent))?;
            count.edits += 1;
            count.left.push(erased);
        }
        (_, now) => {
            tool(step, &[Tool::Goal, Tool::Move], outside(agent))?;
            count.edits += 1;
            count.edited.extend(now);
        }
    }
    let other = |one: &Agent, two: &Agent| -> Vec<Cell> {
        let cells = one.waypoints.iter().copied();
        cells.filter(|cell| !two.waypoints.contains(cell)).collect()
    };
    let (new, gone) = (other(agent, before), other(before, agent));
    if new.is_empty() && !gone.is_empty() {
        let any = [Tool::Waypoint, Tool::Erase, Tool::Move];
        tool(step, &any, outside(agent))?;
    } else if !new.is_empty() {
        tool(step, &[Tool::Waypoint, Tool::Move], outside(agent))?;
    }
    count.edits += new.len().max(gone.len()) as u32;
    count.edited.extend(new);
    Ok(())
}
