//! Edits of the scene: each is one step of undo, makes an answer stale, and
//! ends a solve that was under way.

use std::rc::Rc;

use giveway_model::Scene;

use super::stroke::{abandon, release};
use super::{ask, solve};
use crate::history::Moment;
use crate::link::Linked;
use crate::{Draft, Notice, Selection, State};

/// A scene of more agents opens without the plan table.
const MANY: usize = 6;

/// Replaces the scene, if it can be drawn and solved.
pub(super) fn open(state: &mut State, scene: Scene) {
    let refused = |faults: &[giveway_model::Fault]| Notice {
        sentence: "The scene cannot be opened.".to_owned(),
        details: faults.iter().map(ToString::to_string).collect(),
    };
    let draft = match Draft::new(scene) {
        Ok(draft) => draft,
        Err(faults) => {
            state.notice = Some(refused(&faults));
            return;
        }
    };
    if let Err(faults) = draft.instance() {
        state.notice = Some(refused(faults));
        return;
    }
    put(state, draft);
}

/// Replaces the scene by that of a link, with its plan, and asks its question:
/// without a plan, once the scene is solved.
pub(super) fn open_link(state: &mut State, linked: Linked) {
    put(state, (*linked.draft).clone());
    if let Some(answer) = linked.answer {
        // The board has the very draft, so that the plan is not of another.
        state.draft = linked.draft;
        state.answer = Some(answer);
        state.playback.time = linked.time;
        if let Some(question) = linked.question {
            ask::ask(state, question);
        }
    } else if let Some(question) = linked.question {
        solve::start(state);
        state.wanted = state.work.id().map(|run| (run, question));
    }
}

/// Puts another scene onto the board, as one step of undo.
fn put(state: &mut State, draft: Draft) {
    release(state);
    if state.steering.is_some() {
        // Another step of undo: with the scene its plan of one's own comes back.
        let before = super::change::moment(state);
        state.history.record(before);
    }
    state.placing = None;
    state.notice = None;
    state.answer = None;
    state.asking = None;
    state.changing = None;
    state.steering = None;
    state.selection = Selection::Nothing;
    // A horizon is for one scene; the other limits are for all.
    state.settings.within = None;
    // Of many agents a table is long: the board keeps its room.
    state.view.table &= draft.agents().len() <= MANY;
    state.playback.time = 0;
    state.playback.playing = false;
    // What moved goes no further: it is of another scene.
    state.playback.sought = true;
    replace(state, draft);
}

/// Changes the scene by a function; nothing happens where it changes nothing.
pub(super) fn change(state: &mut State, edit: impl FnOnce(&mut Scene)) {
    release(state);
    let mut scene = state.draft.scene().clone();
    edit(&mut scene);
    if scene == *state.draft.scene() {
        return;
    }
    if let Some(changing) = state.changing.as_deref() {
        let sentence = format!(
            "The world is changing at time {}: adopt a way to go on, or discard the changes, \
             before the scene is edited.",
            changing.at
        );
        return ask::refuse(state, &sentence);
    }
    if super::steer::is_in_the_way(state) {
        return;
    }
    match Draft::new(scene) {
        Ok(draft) => {
            replace(state, draft);
            settled(state);
        }
        Err(faults) => {
            state.notice = Some(Notice {
                sentence: "This edit cannot be made.".to_owned(),
                details: faults.iter().map(ToString::to_string).collect(),
            });
        }
    }
}

pub(super) fn undo(state: &mut State) {
    if state.placing.is_some() {
        return abandon(state);
    }
    release(state);
    let mut history = std::mem::take(&mut state.history);
    let before = history.undo(|before| present(state, before));
    state.history = history;
    if let Some(before) = before {
        go(state, before);
    }
}

pub(super) fn redo(state: &mut State) {
    release(state);
    let mut history = std::mem::take(&mut state.history);
    let after = history.redo(|after| present(state, after));
    state.history = history;
    if let Some(after) = after {
        go(state, after);
    }
}

/// What is now, of the kind of a moment.
fn present(state: &State, like: &Moment) -> Moment {
    match like {
        Moment::Scene(_) => Moment::Scene(Rc::clone(&state.draft)),
        Moment::Course { .. } => super::change::moment(state),
    }
}

fn go(state: &mut State, to: Moment) {
    match to {
        Moment::Scene(draft) => travel(state, draft),
        to @ Moment::Course { .. } => super::change::travel(state, &to),
    }
}

fn travel(state: &mut State, draft: Rc<Draft>) {
    ask::close(state);
    solve::cancel(state);
    state.playback.playing = false;
    let before = std::mem::replace(&mut state.draft, draft);
    state.cursor = state.draft.clamp(state.cursor);
    reselect(state, &before);
    settled(state);
}

fn replace(state: &mut State, draft: Draft) {
    ask::close(state);
    solve::cancel(state);
    state.playback.playing = false;
    let before = std::mem::replace(&mut state.draft, Rc::new(draft));
    state.cursor = state.draft.clamp(state.cursor);
    reselect(state, &before);
    state.history.record(Moment::Scene(before));
}

/// The agent that is selected may have got another place, another name or none.
pub(super) fn reselect(state: &mut State, before: &Draft) {
    if let Selection::Cell(cell) = state.selection {
        state.selection = Selection::Cell(state.draft.clamp(cell));
    }
    let Selection::Agent(agent) = state.selection else {
        return;
    };
    let (old, new) = (before.agents(), state.draft.agents());
    if old.len() == new.len() {
        return;
    }
    let name = old.get(agent).map(|agent| agent.name.as_str());
    let found = new
        .iter()
        .position(|agent| Some(agent.name.as_str()) == name);
    state.selection = found.map_or(Selection::Nothing, Selection::Agent);
}

/// After an edit as a whole.
pub(super) fn settled(state: &mut State) {
    if state.settings.solve_on_change && state.is_stale() {
        solve::start(state);
    }
}
