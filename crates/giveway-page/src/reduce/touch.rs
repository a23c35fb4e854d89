//! The tools while the world changes: strokes on the board, and what is placed.

use std::rc::Rc;

use giveway_model::change::What;
use giveway_model::{Agent, Cell};

use super::change::{end_work, list, put, refuse};
use super::{ask, select};
use crate::changing::{Changing, Stroke, Touch};
use crate::{Placing, Selection, State, Tool};

/// The tools while the world changes.
pub(super) fn press(state: &mut State, cell: Cell) {
    let Some(changing) = state.changing.clone() else {
        return;
    };
    state.playback.playing = false;
    state.playback.time = match changing.compared {
        Some(_) if state.tool == Tool::Select => state.playback.time,
        _ => changing.at,
    };
    let standing = state.agent_at(cell);
    let name = |agent: usize| changing.draft().agents().get(agent).map(|a| a.name.clone());
    match state.tool {
        Tool::Select => {
            let touch = held(state, &changing, cell);
            let selection = standing.map_or(Selection::Cell(cell), Selection::Agent);
            select(state, selection);
            if let Some(touch) = touch {
                hold(state, &changing, touch, cell);
            }
        }
        Tool::Agent => match standing {
            Some(agent) if state.placing.is_none() => select(state, Selection::Agent(agent)),
            _ => place(state, cell),
        },
        Tool::Goal | Tool::Waypoint => {
            let chosen = chosen(state, &changing).filter(|&agent| Some(agent) != standing);
            match (chosen.and_then(name), standing) {
                (Some(agent), _) => {
                    let touch = match state.tool {
                        Tool::Goal => Touch::Goal(agent),
                        _ => Touch::Once(waypoint(&changing, agent, cell)),
                    };
                    hold(state, &changing, touch, cell);
                    drag(state, cell);
                }
                (None, Some(agent)) => select(state, Selection::Agent(agent)),
                (None, None) => {
                    ask::refuse(
                        state,
                        "Press an agent first, then the cell that it has to visit.",
                    );
                }
            }
        }
        Tool::Erase => {
            let touch = erased(&changing, cell, standing);
            hold(state, &changing, touch, cell);
            drag(state, cell);
        }
        tool @ (Tool::Obstacle | Tool::Charger | Tool::SlowZone) => {
            hold(state, &changing, Touch::Paint(tool), cell);
            drag(state, cell);
        }
    }
}

/// The agent that goals and waypoints are for: the selected one, or the only one.
fn chosen(state: &State, changing: &Changing) -> Option<usize> {
    let there = changing.world.is_there.iter();
    let mut there = there
        .enumerate()
        .filter(|(_, is)| **is)
        .map(|(agent, _)| agent);
    let only = there.next().filter(|_| there.next().is_none());
    state.selected_agent().or(only)
}

/// The waypoint of an agent at a cell: dropped where it is one.
fn waypoint(changing: &Changing, agent: String, cell: Cell) -> What {
    let is_it = |other: &&Agent| other.name == agent;
    let who = changing.draft().agents().iter().find(is_it);
    if who.is_some_and(|who| who.waypoints.contains(&cell)) {
        What::DropWaypoint { agent, cell }
    } else {
        What::AddWaypoint { agent, cell }
    }
}

/// The uppermost thing on a cell goes: an agent, a waypoint, else the ground.
fn erased(changing: &Changing, cell: Cell, standing: Option<usize>) -> Touch {
    let agents = changing.draft().agents();
    if let Some(agent) = standing.and_then(|agent| agents.get(agent)) {
        let agent = agent.name.clone();
        return Touch::Once(What::RemoveAgent { agent });
    }
    let there = agents.iter().zip(&changing.world.is_there);
    let mut there = there.filter(|(_, is_there)| **is_there);
    match there.find(|(agent, _)| agent.waypoints.contains(&cell)) {
        Some((agent, _)) => Touch::Once(What::DropWaypoint {
            agent: agent.name.clone(),
            cell,
        }),
        None => Touch::Paint(Tool::Erase),
    }
}

/// What the tool that selects takes hold of.
pub(crate) fn held(state: &State, changing: &Changing, cell: Cell) -> Option<Touch> {
    if state.agent_at(cell).is_some() {
        return None;
    }
    let there = changing
        .draft()
        .agents()
        .iter()
        .zip(&changing.world.is_there);
    let mut goals = there.filter(|(agent, is_there)| **is_there && agent.goal == cell);
    if let Some((agent, _)) = goals.next() {
        return Some(Touch::Goal(agent.name.clone()));
    }
    let ground = changing.draft().grid().ground(cell)?;
    if !ground.is_vertex() {
        return Some(Touch::Obstacle);
    }
    ground.is_charger().then_some(Touch::Charger)
}

fn hold(state: &mut State, changing: &Changing, touch: Touch, cell: Cell) {
    state.notice = None;
    state.cursor = cell;
    let mut held = changing.clone();
    held.stroke = Some(Rc::new(Stroke::new(touch, cell, changing)));
    state.changing = Some(Rc::new(held));
}

/// An agent begins here; where one is being placed, its goal is here.
fn place(state: &mut State, cell: Cell) {
    let is_second = state.placing.is_some();
    let start = state.placing.map_or(cell, |placing| placing.start);
    state.placing = Some(Placing {
        start,
        goal: cell,
        is_held: true,
        is_second,
    });
}

/// The pointer went on to a cell.
pub(super) fn drag(state: &mut State, cell: Cell) {
    let Some(changing) = state.changing.as_deref() else {
        return;
    };
    let Some(stroke) = &changing.stroke else {
        return;
    };
    let mut stroke = Stroke::clone(stroke);
    stroke.go(cell);
    let mut after = stroke.after();
    if after.list == stroke.before.list {
        // Nothing changes so far, so that what was answered still holds.
        after = stroke.before.clone();
    } else {
        end_work(state);
        state.playback.time = after.at;
    }
    after.stroke = Some(Rc::new(stroke));
    state.cursor = cell;
    state.changing = Some(Rc::new(after));
}

/// Ends a stroke.
pub(super) fn release(state: &mut State) {
    let Some(changing) = state.changing.as_deref() else {
        return;
    };
    let Some(stroke) = changing.stroke.clone() else {
        return;
    };
    let mut after = changing.clone();
    after.stroke = None;
    if after.list == stroke.before.list {
        state.changing = Some(Rc::new(stroke.before.clone()));
    } else {
        state.changing = Some(Rc::new(stroke.before.clone()));
        put(state, Some(after));
    }
    if let Some(refused) = stroke.refused.clone() {
        refuse(state, refused);
    }
}

/// Leaves a stroke as if it had never begun.
pub(super) fn abandon(state: &mut State) {
    let stroke = state.changing.as_deref().and_then(|c| c.stroke.clone());
    if let Some(stroke) = stroke {
        state.changing = Some(Rc::new(stroke.before.clone()));
    }
}

/// The agent that was placed joins.
pub(super) fn join(state: &mut State, start: Cell, goal: Cell) {
    let Some(changing) = state.changing.as_deref() else {
        return;
    };
    let agent = Agent {
        name: changing.fresh_name(),
        start,
        goal,
        waypoints: Vec::new(),
        battery: None,
    };
    let index = changing.draft().agents().len();
    list(state, What::AddAgent { agent });
    if state.is_there(index) {
        select(state, Selection::Agent(index));
    }
}
