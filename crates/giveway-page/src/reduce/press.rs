//! The pointer goes down with a tool: what it takes hold of.

use std::rc::Rc;

use giveway_model::words::Sentence;
use giveway_model::{Agent, Cell, tr_data};

use super::board::select;
use super::{ask, fleet, steer, stroke};
use crate::changing::Changing;
use crate::draw::Shape;
use crate::edit::{Edit, Paint};
use crate::gesture::{Canvas, Gesture, Hold, Ink, Placing, Shaped, Stroke, Thing};
use crate::rules::fresh_zone;
use crate::steering::Lead;
use crate::{Selection, State, Tool};

/// The pointer went down, or a key applied the tool.
pub(super) fn press(state: &mut State, cell: Cell) {
    press_with(state, cell, false, false);
}

/// The same in another way: to take away, or to draw a rectangle.
pub(super) fn press_with(state: &mut State, cell: Cell, takes: bool, is_rect: bool) {
    stroke::release(state);
    let cell = state.document.draft.clamp(cell);
    if state.document.mode.steering().is_some() {
        return steer::steer(state, Lead::To(cell));
    }
    let changing = state.document.mode.changing().cloned();
    if let Some(changing) = &changing {
        // The world changes at its time; the methods' plans can be watched at all.
        let watches = state.document.mode.comparing().is_some();
        if !(watches && state.view.tool == Tool::Select) {
            state.view.playback.stop_at(changing.at);
        }
        state.view.playback.playing = false;
    }
    match state.view.tool {
        Tool::Select => {
            let held = state.thing_at(cell);
            let standing = state.agent_at(cell);
            select(
                state,
                standing.map_or(Selection::Cell(cell), Selection::Agent),
            );
            if let Some(thing) = held {
                begin(state, Hold::Thing(thing), cell);
            }
        }
        Tool::Agent if state.shape() == Shape::Row => fleet::press(state, cell),
        Tool::Agent => press_agent(state, cell),
        Tool::Goal | Tool::Waypoint => match &changing {
            Some(changing) => press_task(state, changing, cell),
            None if state.view.tool == Tool::Goal => press_goal(state, cell),
            None => press_waypoint(state, cell),
        },
        Tool::Obstacle | Tool::Charger | Tool::SlowZone | Tool::Erase
            if takes || shape(state, is_rect) != Shape::Pen =>
        {
            begin(state, Hold::Shape(shaped(state, takes, is_rect)), cell);
            stroke::drag(state, cell);
        }
        Tool::Erase => {
            let hold = changing.map_or(Hold::Eraser, |changing| erased(state, &changing, cell));
            begin(state, hold, cell);
            stroke::drag(state, cell);
        }
        Tool::Zone | Tool::OneWay => mark(state, cell, takes, is_rect),
        tool @ (Tool::Obstacle | Tool::Charger | Tool::SlowZone) => {
            let paint = tool.paint().unwrap_or(Paint::Obstacle);
            let ground = state.world().grid().ground(cell);
            // In a world that changes, the brush only paints: erasing takes away.
            let on = changing.is_some() || ground.is_some_and(|ground| !paint.is_on(ground));
            begin(state, Hold::Brush(paint, on), cell);
            stroke::drag(state, cell);
        }
    }
}

/// The shape that a stroke draws. Shift draws a rectangle with the pen, else a line.
fn shape(state: &State, is_shifted: bool) -> Shape {
    match (state.shape(), is_shifted && state.can_pick_shapes()) {
        (Shape::Pen, true) => Shape::Rectangle,
        (_, true) => Shape::Line,
        (shape, false) => shape,
    }
}

/// What the tool draws as a shape.
fn shaped(state: &State, takes: bool, is_shifted: bool) -> Shaped {
    let tool = state.view.tool;
    let shape = shape(state, is_shifted);
    let ink = tool.paint().map_or(Ink::Erase, |paint| {
        Ink::Paint(paint, !takes && shape != Shape::Aisle)
    });
    Shaped::new(shape, ink, state.view.drawing)
}

/// Marks cells for rules: a stroke goes on with the zone that was marked last; with the other
/// tool, it leads a lane.
fn mark(state: &mut State, cell: Cell, takes: bool, is_rect: bool) {
    stroke::release(state);
    let cell = state.document.draft.clamp(cell);
    if !state.can_write_rules() {
        let why = if state.document.mode.changing().is_some() {
            tr_data!(
                "New zones and lanes are marked before a plan runs. A rule about a zone that is there can be added from now on, in the inspector."
            )
        } else {
            tr_data!("Rules can be written where the scene itself is on the board.")
        };
        return ask::refuse(state, why);
    }
    state.view.playback.playing = false;
    state.view.cursor = cell;
    if state.view.tool == Tool::OneWay {
        begin(state, Hold::Lane(Vec::new()), cell);
        return stroke::drag(state, cell);
    }
    let scene = state.document.draft.scene();
    let chosen = state.view.rules.zone.as_ref();
    let zone = scene.zones.iter().find(|zone| chosen == Some(&zone.name));
    let on = !takes;
    let name = zone.map_or_else(|| fresh_zone(scene), |zone| zone.name.clone());
    let hold = if is_rect || state.shape() == Shape::Rectangle {
        Hold::Rect(name, on)
    } else {
        Hold::Zone(name, on)
    };
    begin(state, hold, cell);
    stroke::drag(state, cell);
}

/// An agent that stands there is taken hold of; else one is placed.
fn press_agent(state: &mut State, cell: Cell) {
    if let Gesture::Placing(placing) = &mut state.view.gesture {
        placing.goal = cell;
        placing.is_held = true;
        placing.is_second = true;
        return;
    }
    if let Some(agent) = state.agent_at(cell) {
        let held = state.thing_at(cell);
        select(state, Selection::Agent(agent));
        if let Some(thing @ Thing::Start(_)) = held {
            begin(state, Hold::Thing(thing), cell);
        }
        return;
    }
    state.view.gesture = Gesture::Placing(Placing {
        start: cell,
        goal: cell,
        is_held: true,
        is_second: false,
    });
}

/// The selected agent gets its goal here; without one, an agent is chosen by
/// its goal or start, and its goal can be drawn away from there.
fn press_goal(state: &mut State, cell: Cell) {
    let agents = state.document.draft.agents();
    let chosen = state.selected_agent().or((agents.len() == 1).then_some(0));
    let other = agents.iter().position(|agent| agent.goal == Some(cell));
    let start = agents.iter().position(|agent| agent.start == cell);
    match (other, chosen) {
        (Some(agent), _) => choose(state, agent, Thing::Goal(agent), cell),
        (None, Some(agent)) => {
            choose(state, agent, Thing::Goal(agent), cell);
            stroke::drag(state, cell);
        }
        (None, None) => match start {
            Some(agent) => choose(state, agent, Thing::Goal(agent), cell),
            None => ask_for_agent(state, tr_data!("the cell of its" => "goal")),
        },
    }
}

/// The selected agent gets a waypoint here, or loses it; without one, an agent
/// is chosen by what it has there.
fn press_waypoint(state: &mut State, cell: Cell) {
    let agents = state.document.draft.agents();
    let has = |agent: &Agent| agent.waypoints.contains(&cell);
    let chosen = state.selected_agent().or((agents.len() == 1).then_some(0));
    if let Some(agent) = chosen {
        if agents.get(agent).is_some_and(has) {
            select(state, Selection::Agent(agent));
            return begin(state, Hold::Toggle(agent), cell);
        }
        choose(state, agent, Thing::NewWaypoint(agent), cell);
        return stroke::drag(state, cell);
    }
    let is = |agent: &Agent| agent.goal == Some(cell) || agent.start == cell;
    if let Some(agent) = agents.iter().position(has) {
        choose(state, agent, Thing::Waypoint(agent), cell);
    } else if let Some(agent) = agents.iter().position(is) {
        choose(state, agent, Thing::NewWaypoint(agent), cell);
    } else {
        ask_for_agent(state, tr_data!("the cell of its" => "waypoint"));
    }
}

/// In a world that changes: another goal or a waypoint for the agent that is
/// selected, or the only one; an agent that stands there is chosen first.
fn press_task(state: &mut State, changing: &Changing, cell: Cell) {
    let standing = state.agent_at(cell);
    let mut there = (0..changing.draft().agents().len()).filter(|&agent| state.is_there(agent));
    let only = there.next().filter(|_| there.next().is_none());
    let chosen = state.selected_agent().or(only);
    let Some(agent) = chosen.filter(|&agent| Some(agent) != standing) else {
        return match standing {
            Some(agent) => select(state, Selection::Agent(agent)),
            None => ask_for_agent(state, tr_data!("the cell of its" => "goal or waypoint")),
        };
    };
    let has = |agent: &Agent| agent.waypoints.contains(&cell);
    let hold = match state.view.tool {
        Tool::Goal => Hold::Thing(Thing::Goal(agent)),
        _ if changing.draft().agents().get(agent).is_some_and(has) => {
            Hold::Once(Edit::DropWaypoint(agent, cell))
        }
        _ => Hold::Once(Edit::AddWaypoint(agent, cell)),
    };
    begin(state, hold, cell);
    stroke::drag(state, cell);
}

/// In a world that changes, the uppermost thing on a cell goes: an agent, a
/// waypoint, else the ground.
fn erased(state: &State, changing: &Changing, cell: Cell) -> Hold {
    if let Some(agent) = state.agent_at(cell) {
        return Hold::Once(Edit::RemoveAgent(agent));
    }
    let mut agents = changing.draft().agents().iter().enumerate();
    let has =
        |(index, agent): (usize, &Agent)| state.is_there(index) && agent.waypoints.contains(&cell);
    match agents.position(has) {
        Some(agent) => Hold::Once(Edit::DropWaypoint(agent, cell)),
        None => Hold::Eraser,
    }
}

fn choose(state: &mut State, agent: usize, thing: Thing, cell: Cell) {
    select(state, Selection::Agent(agent));
    begin(state, Hold::Thing(thing), cell);
}

fn ask_for_agent(state: &mut State, what: Sentence) {
    let sentence = tr_data!("Press a robot first, then the cell of its {what}.", what);
    ask::refuse(state, sentence);
}

fn begin(state: &mut State, hold: Hold, cell: Cell) {
    state.view.notice = None;
    let canvas = match state.document.mode.changing() {
        Some(changing) => {
            state.view.cursor = cell;
            Canvas::world(changing)
        }
        None => Canvas::scene(&state.document.draft),
    };
    state.view.gesture = Gesture::Stroke(Rc::new(Stroke::new(hold, cell, canvas)));
}
