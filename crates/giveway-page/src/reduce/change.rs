//! The world changes while a plan runs: listing what changes, asking how to go
//! on, adopting one of the answers.

use std::rc::Rc;

use giveway_model::{Question, tr_data};
use giveway_solve::change::ChangeAnswer;
use giveway_solve::explain::Repair;

use super::document::{drop_gesture, enter, put};
use super::{ask, stroke};
use crate::changing::{Changing, Choice, Comparing, Filled, WIDEST};
use crate::edit::{Edit, repair};
use crate::{
    Activity, Adapting, ChangeAction, Document, Mode, Notice, Selection, Size, State, Tab, Task,
    Tool,
};

/// The steps of a breakdown until another number is given.
const BREAKDOWN: u32 = 10;

#[inline(never)]
pub(super) fn change(state: &mut State, action: ChangeAction) {
    match action {
        ChangeAction::Begin => begin(state),
        ChangeAction::BreakDown(agent) => {
            let name = state.world().agents().get(agent);
            if let Some(name) = name.map(|own| own.name.clone()) {
                break_down(state, &name, BREAKDOWN);
            }
        }
        ChangeAction::Fill(index, filled) => fill(state, index, filled),
        ChangeAction::Discard => discard(state),
        ChangeAction::TakeBack(index) => take_back(state, index),
        ChangeAction::ChooseMethods(choice) => choose_methods(state, choice),
        ChangeAction::Adapt => adapt(state),
        ChangeAction::Preview(index) => preview(state, index),
        ChangeAction::Adopt(index) => adopt(state, index),
    }
}

/// The world changes at the time shown.
fn begin(state: &mut State) {
    stroke::release(state);
    if state.document.mode.changing().is_some() || super::steer::is_in_the_way(state) {
        return;
    }
    let answer = state.document.fresh_answer();
    let Some(answer) = answer.filter(|answer| answer.plan().is_some()) else {
        return ask::refuse(
            state,
            tr_data!("Solve first: changes happen while a plan runs."),
        );
    };
    let at = state.view.playback.time;
    let Some(changing) = Changing::begin(answer, at) else {
        let last = answer.changed_last().unwrap_or(at);
        let sentence = tr_data!(
            "What happened up to time {last} is settled. Show a later time, or undo.",
            last
        );
        return ask::refuse(state, &sentence);
    };
    drop_gesture(state);
    state.view.notice = None;
    state.view.tool = Tool::Select;
    state.view.tab = Tab::Inspector;
    enter(state, Activity::Changing(Rc::new(changing)));
}

/// An agent breaks down at the time shown, for so many steps.
pub(super) fn break_down(state: &mut State, name: &str, steps: u32) {
    if state.document.mode.changing().is_none() {
        begin(state);
    }
    let Some(changing) = state.document.mode.changing().cloned() else {
        return;
    };
    // The world that changes may have other agents.
    let mut agents = changing.draft().agents().iter();
    let Some(agent) = agents.position(|own| own.name == name) else {
        return;
    };
    super::board::select(state, crate::Selection::Agent(agent));
    if let Err(notice) = list(state, &changing, &Edit::Delay(agent, steps)) {
        state.view.notice = Some(notice);
    }
}

/// A listed breakdown is another robot's, at another time, or as long as said.
fn fill(state: &mut State, index: usize, filled: Filled) {
    stroke::release(state);
    let Some(changing) = state.document.mode.changing().cloned() else {
        return;
    };
    match changing.with_breakdown(index, filled) {
        Err(why) => ask::refuse(state, &why),
        Ok(after) if after == *changing => {}
        Ok(after) => {
            state.view.notice = None;
            let at = after.at;
            let stays = state.view.selection == Selection::Nothing;
            let broken = after.breaks_last();
            enter(state, Activity::Changing(Rc::new(after)));
            state.view.playback.stop_at(at);
            // The card goes along with its robot.
            if !stays {
                let selection = broken.filter(|&agent| state.is_there(agent));
                let selection = selection.map_or(Selection::Nothing, Selection::Agent);
                super::board::select(state, selection);
            }
        }
    }
}

/// Leaves what was listed; undo brings it back.
fn discard(state: &mut State) {
    if state.document.mode.changing().is_some() {
        drop_gesture(state);
        state.view.tool = Tool::Select;
        enter(state, Activity::Editing);
    }
}

/// Lists what an edit does to the world.
///
/// # Errors
/// Why the world cannot change so.
pub(super) fn list(state: &mut State, changing: &Rc<Changing>, edit: &Edit) -> Result<(), Notice> {
    let (after, refused) = changing.with_edits(std::slice::from_ref(edit));
    if after.list != changing.list {
        state.view.notice = None;
        enter(state, Activity::Changing(Rc::new(after)));
    } else if refused.is_some() {
        state.view.playback.stop_at(changing.at);
    }
    refused.map_or(Ok(()), |sentence| Err(Notice::refusal(sentence)))
}

/// Lists the edits of a repair, and asks again how to go on.
pub(super) fn repaired(state: &mut State, changing: &Rc<Changing>, found: &Repair) {
    let edits = repair(&found.edits, changing.draft().agents());
    let within = edits.iter().find_map(|edit| match edit {
        Edit::Within(within) => Some(*within),
        _ => None,
    });
    let (after, refused) = changing.with_edits(&edits);
    if let Some(refused) = refused {
        return ask::refuse(state, &refused);
    }
    let document = Document {
        within: within.unwrap_or(state.document.within),
        mode: Activity::Changing(Rc::new(after)).into(),
        ..state.document.clone()
    };
    put(state, document);
    adapt(state);
}

/// Takes a listed change back.
fn take_back(state: &mut State, index: usize) {
    stroke::release(state);
    let changing = state.document.mode.changing();
    let Some(changing) = changing.filter(|changing| index < changing.list.len()) else {
        return;
    };
    let (after, lost) = changing.without(index);
    enter(state, Activity::Changing(Rc::new(after)));
    if lost > 0 {
        ask::refuse(
            state,
            tr_data!("What depended on that change was taken back with it."),
        );
    }
}

/// Chooses the methods; at least one stays.
fn choose_methods(state: &mut State, choice: Choice) {
    if !choice.methods().is_empty() {
        state.settings.methods = Choice {
            width: choice.width.min(WIDEST),
            ..choice
        };
    }
}

/// Asks how to go on.
pub(super) fn adapt(state: &mut State) {
    stroke::release(state);
    let Some(changing) = state.document.mode.changing().cloned() else {
        return;
    };
    if changing.list.is_empty() {
        return ask::refuse(
            state,
            tr_data!("Nothing changes yet. Use the tools on the board first."),
        );
    }
    let request = changing.request(&state.settings, state.document.within);
    let Some(request) = request else { return };
    drop_gesture(state);
    state.view.notice = None;
    state.view.playback.playing = false;
    state.work.start(Task::Change(Adapting {
        changing,
        request: Rc::new(request),
        size: Size::default(),
    }));
}

/// The methods have answered.
pub(super) fn answered(state: &mut State, run: &Adapting, told: ChangeAnswer) {
    let Some(comparing) = Comparing::new(&run.changing, told) else {
        return ask::refuse(state, tr_data!("The answer is not about what is listed."));
    };
    let at = run.changing.at;
    state.view.tool = Tool::Select;
    state.view.tab = Tab::Inspector;
    let is_stuck = comparing.preview().is_none();
    enter(state, Activity::Comparing(Rc::new(comparing)));
    state.view.playback.stop_at(at);
    if is_stuck {
        ask::ask(state, &Question::Unsolvable);
    }
}

/// Previews the plan of a method.
fn preview(state: &mut State, index: usize) {
    if let Activity::Comparing(comparing) = &mut state.document.mode.activity {
        let tried = comparing.tried.get(index);
        if tried.is_some_and(|tried| tried.answer.is_some()) {
            Rc::make_mut(comparing).chosen = Some(index);
        }
        super::document::settle(state);
    }
}

/// Adopts the plan of a method: it becomes the plan, with its history.
fn adopt(state: &mut State, index: usize) {
    let found = state.document.mode.comparing().and_then(|comparing| {
        let tried = comparing.tried.get(index)?;
        Some((comparing.changing.at, tried.answer.clone()?))
    });
    let Some((at, answer)) = found else { return };
    let document = Document {
        answer: Some(answer),
        mode: Mode::default(),
        ..state.document.clone()
    };
    put(state, document);
    state.view.playback.stop_at(at);
    state.view.tab = Tab::Timeline;
}
