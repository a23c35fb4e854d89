//! The world changes while a plan runs: listing what changes, asking how to go
//! on, adopting one of the answers.

use std::rc::Rc;

use giveway_model::change::What;
use giveway_model::{Agent, Cell};
use giveway_solve::change::ChangeAnswer;

use super::{ask, select, solve};
use crate::changing::{Changing, Choice, Compared, Stroke, Touch, WIDEST};
use crate::history::Moment;
use crate::{Adapting, Notice, Placing, Selection, Size, State, Tab, Tool, Work};

/// What a step of undo brings back of what changes.
fn moment(state: &State) -> Moment {
    Moment::Course {
        answer: state.answer.clone(),
        changing: state.changing.clone(),
    }
}

/// Puts what changes now in the place of what did, as one step of undo.
fn put(state: &mut State, changing: Option<Changing>) {
    end_work(state);
    let before = moment(state);
    state.changing = changing.map(Rc::new);
    state.history.record(before);
    settle(state);
}

/// A search for how to go on with another list is of no use.
fn end_work(state: &mut State) {
    if let Work::Adapting(_) = state.work {
        state.work = Work::Idle;
    }
}

/// The time and the selection as what is shown now allows them.
fn settle(state: &mut State) {
    if let Some(changing) = state.changing.as_deref()
        && changing.compared.is_none()
    {
        state.playback.time = changing.at;
    }
    state.playback.playing = false;
    state.playback.sought = true;
    state.playback.time = state.playback.time.min(state.last_time());
    if let Selection::Agent(agent) = state.selection
        && !state.is_there(agent)
    {
        state.selection = Selection::Nothing;
    }
}

/// Brings back what was, or what was undone.
pub(super) fn travel(state: &mut State, moment: &Moment) {
    let Moment::Course { answer, changing } = moment else {
        return;
    };
    ask::close(state);
    solve::cancel(state);
    state.placing = None;
    state.answer.clone_from(answer);
    state.changing.clone_from(changing);
    settle(state);
}

/// The world changes at the time shown.
pub(super) fn begin(state: &mut State) {
    super::stroke::release(state);
    if state.changing.is_some() {
        return;
    }
    let answer = state.answer.clone().filter(|_| !state.is_stale());
    let Some(answer) = answer.filter(|answer| answer.plan().is_some()) else {
        return ask::refuse(
            state,
            "Solve the scene first: what changes does so while a plan runs.",
        );
    };
    let at = state.playback.time;
    let Some(changing) = Changing::begin(&answer, at) else {
        let last = answer.changed_last().unwrap_or(at);
        let sentence =
            format!("What happened up to time {last} is settled: show a later time, or undo.");
        return ask::refuse(state, &sentence);
    };
    ask::close(state);
    solve::cancel(state);
    state.notice = None;
    state.placing = None;
    state.tool = Tool::Select;
    state.view.tab = Tab::Inspector;
    put(state, Some(changing));
}

/// Leaves what was listed; undo brings it back.
pub(super) fn discard(state: &mut State) {
    if state.changing.is_some() {
        state.placing = None;
        state.tool = Tool::Select;
        put(state, None);
    }
}

fn refuse(state: &mut State, sentence: String) {
    state.notice = Some(Notice {
        sentence,
        details: Vec::new(),
    });
}

/// Lists a change, if the world allows it.
pub(super) fn list(state: &mut State, what: What) {
    super::stroke::release(state);
    let Some(changing) = state.changing.as_deref() else {
        return;
    };
    match changing.adding(what) {
        Ok(after) => {
            state.notice = None;
            put(state, Some(after));
        }
        Err(sentence) => {
            state.playback.time = changing.at;
            refuse(state, sentence);
        }
    }
}

/// Takes a listed change back.
pub(super) fn take_back(state: &mut State, index: usize) {
    super::stroke::release(state);
    let Some(changing) = state.changing.as_deref().filter(|c| index < c.list.len()) else {
        return;
    };
    let (after, lost) = changing.without(index);
    put(state, Some(after));
    if lost > 0 {
        refuse(
            state,
            "What depended on that change was taken back with it.".to_owned(),
        );
    }
}

/// Chooses the methods; at least one stays.
pub(super) fn choose_methods(state: &mut State, choice: Choice) {
    if !choice.methods().is_empty() {
        state.settings.methods = Choice {
            width: choice.width.min(WIDEST),
            ..choice
        };
    }
}

/// Asks how to go on.
pub(super) fn adapt(state: &mut State) {
    super::stroke::release(state);
    let Some(changing) = state.changing.clone() else {
        return;
    };
    if changing.list.is_empty() {
        return ask::refuse(
            state,
            "Nothing changes yet: use the tools on the board first.",
        );
    }
    let Some(request) = changing.request(&state.settings) else {
        return;
    };
    state.notice = None;
    state.placing = None;
    state.playback.playing = false;
    state.runs += 1;
    state.work = Work::Adapting(Adapting {
        id: state.runs,
        request: Rc::new(request),
        size: Size::default(),
    });
}

pub(super) fn is_current(state: &State, id: u64) -> bool {
    matches!(&state.work, Work::Adapting(run) if run.id == id)
}

/// How far the search has come.
pub(super) fn learn(state: &mut State, size: Size) {
    if let Work::Adapting(run) = &mut state.work {
        run.size = size;
    }
}

/// The methods have answered.
pub(super) fn answered(state: &mut State, told: ChangeAnswer) {
    state.work = Work::Idle;
    let Some(changing) = state.changing.as_deref() else {
        return;
    };
    let Some(compared) = Compared::new(changing, told) else {
        return refuse(state, "The answer is not about what is listed.".to_owned());
    };
    let mut changing = changing.clone();
    changing.compared = Some(Rc::new(compared));
    state.playback.time = changing.at;
    state.changing = Some(Rc::new(changing));
    state.tool = Tool::Select;
    state.view.tab = Tab::Inspector;
}

/// Previews the plan of a method.
pub(super) fn preview(state: &mut State, index: usize) {
    let Some(changing) = state.changing.as_mut().map(Rc::make_mut) else {
        return;
    };
    let Some(compared) = changing.compared.as_mut().map(Rc::make_mut) else {
        return;
    };
    let has_plan = |index: usize| {
        compared
            .tried
            .get(index)
            .is_some_and(|t| t.answer.is_some())
    };
    if has_plan(index) {
        compared.chosen = Some(index);
        state.playback.time = state.playback.time.min(state.last_time());
    }
}

/// Adopts the plan of a method: it becomes the plan, with its history.
pub(super) fn adopt(state: &mut State, index: usize) {
    let found = state.changing.as_deref().and_then(|changing| {
        let tried = changing.compared.as_deref()?.tried.get(index)?;
        Some((changing.at, tried.answer.clone()?))
    });
    let Some((at, answer)) = found else { return };
    end_work(state);
    let before = moment(state);
    state.history.record(before);
    state.changing = None;
    state.answer = Some(answer);
    state.playback.time = at;
    state.view.tab = Tab::Timeline;
    settle(state);
}

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
