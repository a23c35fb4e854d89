//! Strokes: what begins where the pointer goes down and ends where it is lifted
//! is one step of undo, whether it paints, moves a thing or places an agent.

use std::rc::Rc;

use giveway_model::{Agent, Cell};

use super::{ask, edit, select, solve};
use crate::ground::Brush;
use crate::history::Moment;
use crate::state::Stroke;
use crate::steering::Lead;
use crate::things::{Hold, Thing, fresh_name};
use crate::{Draft, Notice, Placing, Selection, State, Tool};

/// Picks a tool; what another was doing is over.
pub(super) fn pick(state: &mut State, tool: Tool) {
    release(state);
    if tool != Tool::Select && super::steer::is_in_the_way(state) {
        return;
    }
    state.placing = None;
    state.tool = tool;
    if let Some(changing) = state.changing.as_deref() {
        let at = changing.at;
        return super::play::seek(state, at);
    }
    let is_other_world = || state.fresh_answer().is_some_and(|a| a.course.is_some());
    if tool.is_of_agents() || tool == Tool::Erase || (tool != Tool::Select && is_other_world()) {
        // Agents are placed where they begin: that is shown, not where they are.
        super::play::seek(state, 0);
    }
}

/// The pointer went down, or a key applied the tool.
pub(super) fn press(state: &mut State, cell: Cell) {
    release(state);
    let cell = state.draft.clamp(cell);
    if state.steering.is_some() {
        return super::steer::steer(state, Lead::To(cell));
    }
    state.cursor = cell;
    if state.changing.is_some() {
        return super::touch::press(state, cell);
    }
    match state.tool {
        Tool::Select => {
            let held = state.thing_at(cell);
            let selection = match state.agent_at(cell) {
                Some(agent) => Selection::Agent(agent),
                None => Selection::Cell(cell),
            };
            select(state, selection);
            if let Some(thing) = held {
                begin(state, Hold::Thing(thing), cell);
            }
        }
        Tool::Agent => press_agent(state, cell),
        Tool::Goal => press_goal(state, cell),
        Tool::Waypoint => press_waypoint(state, cell),
        tool => {
            if let Some(brush) = Brush::begin(state.draft.scene(), tool, cell) {
                begin(state, Hold::Brush(brush), cell);
                drag(state, cell);
            }
        }
    }
}

/// An agent that stands there is taken hold of; else one is placed.
fn press_agent(state: &mut State, cell: Cell) {
    if let Some(placing) = &mut state.placing {
        placing.goal = cell;
        placing.is_held = true;
        placing.is_second = true;
        return;
    }
    if let Some(thing @ Thing::Start(agent)) = state.thing_at(cell) {
        select(state, Selection::Agent(agent));
        return begin(state, Hold::Thing(thing), cell);
    }
    state.placing = Some(Placing {
        start: cell,
        goal: cell,
        is_held: true,
        is_second: false,
    });
}

/// The selected agent gets its goal here; without one, an agent is chosen by
/// its goal or start, and its goal can be drawn away from there.
fn press_goal(state: &mut State, cell: Cell) {
    let agents = state.draft.agents();
    let chosen = state.selected_agent().or((agents.len() == 1).then_some(0));
    let other = agents.iter().position(|agent| agent.goal == cell);
    let start = agents.iter().position(|agent| agent.start == cell);
    match (other, chosen) {
        (Some(agent), _) => choose(state, agent, Thing::Goal(agent), cell),
        (None, Some(agent)) => {
            choose(state, agent, Thing::Goal(agent), cell);
            drag(state, cell);
        }
        (None, None) => match start {
            Some(agent) => choose(state, agent, Thing::Goal(agent), cell),
            None => ask_for_agent(state, "goal"),
        },
    }
}

/// The selected agent gets a waypoint here, or loses it; without one, an agent
/// is chosen by what it has there.
fn press_waypoint(state: &mut State, cell: Cell) {
    let agents = state.draft.agents();
    let has = |agent: &Agent| agent.waypoints.contains(&cell);
    let chosen = state.selected_agent().or((agents.len() == 1).then_some(0));
    if let Some(agent) = chosen {
        if agents.get(agent).is_some_and(has) {
            select(state, Selection::Agent(agent));
            return begin(state, Hold::Toggle(agent), cell);
        }
        choose(state, agent, Thing::NewWaypoint(agent), cell);
        return drag(state, cell);
    }
    let is = |agent: &Agent| agent.goal == cell || agent.start == cell;
    if let Some(agent) = agents.iter().position(has) {
        choose(state, agent, Thing::Waypoint(agent), cell);
    } else if let Some(agent) = agents.iter().position(is) {
        choose(state, agent, Thing::NewWaypoint(agent), cell);
    } else {
        ask_for_agent(state, "waypoint");
    }
}

fn choose(state: &mut State, agent: usize, thing: Thing, cell: Cell) {
    select(state, Selection::Agent(agent));
    begin(state, Hold::Thing(thing), cell);
}

fn ask_for_agent(state: &mut State, what: &str) {
    state.notice = Some(Notice {
        sentence: format!("Press an agent first, then the cell of its {what}."),
        details: Vec::new(),
    });
}

fn begin(state: &mut State, hold: Hold, cell: Cell) {
    state.notice = None;
    state.stroke = Some(Stroke {
        hold,
        from: cell,
        at: cell,
        has_left: false,
        before: Rc::clone(&state.draft),
    });
}

/// The pointer went on to a cell.
pub(super) fn drag(state: &mut State, cell: Cell) {
    let cell = state.draft.clamp(cell);
    if let Some(placing) = &mut state.placing {
        placing.goal = cell;
        state.cursor = cell;
        return;
    }
    if state.changing.is_some() {
        return super::touch::drag(state, cell);
    }
    let Some(stroke) = &mut state.stroke else {
        return;
    };
    let last = std::mem::replace(&mut stroke.at, cell);
    stroke.has_left |= cell != stroke.from;
    state.cursor = cell;
    let thing = match stroke.hold {
        Hold::Brush(brush) => {
            if let Some(scene) = brush.stroke(state.draft.scene(), last, cell) {
                show(state, Draft::new(scene).ok());
            }
            return;
        }
        Hold::Thing(thing) => thing,
        Hold::Toggle(agent) => Thing::Waypoint(agent),
    };
    // From where it began, so that nothing stays behind on the way.
    let mut scene = stroke.before.scene().clone();
    thing.go(&mut scene, stroke.from, cell);
    if let Selection::Cell(_) = state.selection {
        state.selection = Selection::Cell(cell);
    }
    show(state, Draft::new(scene).ok());
}

/// The board on the way of a stroke.
fn show(state: &mut State, draft: Option<Draft>) {
    let Some(draft) = draft.filter(|draft| *draft != *state.draft) else {
        return;
    };
    ask::close(state);
    solve::cancel(state);
    state.playback.playing = false;
    let before = std::mem::replace(&mut state.draft, Rc::new(draft));
    edit::reselect(state, &before);
}

/// Ends a stroke. An agent whose goal is not chosen yet waits for it.
pub(super) fn release(state: &mut State) {
    if let Some(placing) = &mut state.placing
        && placing.is_held
    {
        placing.is_held = false;
        if placing.is_second || placing.goal != placing.start {
            place(state);
        }
    }
    super::touch::release(state);
    let Some(stroke) = state.stroke.take() else {
        return;
    };
    if let Hold::Toggle(agent) = stroke.hold
        && !stroke.has_left
    {
        edit::change(state, |scene| {
            if let Some(agent) = scene.agents.get_mut(agent) {
                agent.waypoints.retain(|&waypoint| waypoint != stroke.from);
            }
        });
        return;
    }
    if *stroke.before != *state.draft {
        state.history.record(Moment::Scene(stroke.before));
        edit::settled(state);
    }
}

/// Puts the agent that was placed onto the board, and selects it.
fn place(state: &mut State) {
    let Some(Placing { start, goal, .. }) = state.placing.take() else {
        return;
    };
    if state.changing.is_some() {
        return super::touch::join(state, start, goal);
    }
    let count = state.draft.agents().len();
    edit::change(state, |scene| {
        scene.agents.push(Agent {
            name: fresh_name(scene),
            start,
            goal,
            waypoints: Vec::new(),
            battery: None,
        });
    });
    if state.draft.agents().len() > count {
        select(state, Selection::Agent(count));
    }
}

/// Leaves a stroke or a placing as if it had never begun.
pub(super) fn abandon(state: &mut State) {
    state.placing = None;
    super::touch::abandon(state);
    if let Some(stroke) = state.stroke.take() {
        let present = std::mem::replace(&mut state.draft, stroke.before);
        edit::reselect(state, &present);
    }
}
