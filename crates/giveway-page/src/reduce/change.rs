//! The world changes while a plan runs: listing what changes, asking how to go
//! on, adopting one of the answers.

use std::rc::Rc;

use giveway_model::change::What;
use giveway_solve::change::ChangeAnswer;

use super::{ask, solve};
use crate::changing::{Changing, Choice, Compared, WIDEST};
use crate::history::Moment;
use crate::{Adapting, Notice, Selection, Size, State, Tab, Tool, Work};

/// What a step of undo brings back of what changes, or of a plan of one's own.
pub(super) fn moment(state: &State) -> Moment {
    Moment::Course {
        answer: state.answer.clone(),
        changing: state.changing.clone(),
        steering: state.steering.clone(),
    }
}

/// Puts what changes now in the place of what did, as one step of undo.
pub(super) fn put(state: &mut State, changing: Option<Changing>) {
    end_work(state);
    let before = moment(state);
    state.changing = changing.map(Rc::new);
    state.history.record(before);
    settle(state);
}

/// A search for how to go on with another list is of no use.
pub(super) fn end_work(state: &mut State) {
    if let Work::Adapting(_) = state.work {
        state.work = Work::Idle;
    }
}

/// The time and the selection as what is shown now allows them.
pub(super) fn settle(state: &mut State) {
    if let Some(changing) = state.changing.as_deref()
        && changing.compared.is_none()
    {
        state.playback.time = changing.at;
    }
    if let Some(steering) = state.steering.as_deref() {
        state.playback.time = steering.time();
        state.cursor = steering.cell();
        state.selection = Selection::Agent(steering.agent);
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
    let Moment::Course {
        answer,
        changing,
        steering,
    } = moment
    else {
        return;
    };
    ask::close(state);
    solve::cancel(state);
    state.placing = None;
    state.answer.clone_from(answer);
    state.changing.clone_from(changing);
    state.steering.clone_from(steering);
    settle(state);
}

/// The world changes at the time shown.
pub(super) fn begin(state: &mut State) {
    super::stroke::release(state);
    if state.changing.is_some() || super::steer::is_in_the_way(state) {
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

pub(super) fn refuse(state: &mut State, sentence: String) {
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
