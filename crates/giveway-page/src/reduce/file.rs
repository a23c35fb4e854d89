//! Documents come and go: scenes, links, what was displaced.

use std::rc::Rc;

use giveway_model::{Fault, Scene, tr_data};

use super::document::{drop_gesture, put, settle, travel};
use super::{ask, solve, stroke};
use crate::link::{Linked, Source};
use crate::state::{By, Displaced};
use crate::{Document, Draft, FileAction, Folds, Moment, Notice, Selection, State, Tab, Tool};

/// A scene of more agents opens without the plan table.
const MANY: usize = 6;

pub(super) fn file(state: &mut State, action: FileAction) {
    match action {
        FileAction::Open(scene) => open(state, *scene),
        FileAction::OpenLink(linked) => open_link(state, *linked),
        FileAction::Back => back(state),
        FileAction::Keep => {
            state.displaced = None;
            state.view.waiting.refused = false;
            state.view.waiting.unchecked = false;
        }
        FileAction::Resume(moment) => resume(state, *moment),
        FileAction::Tell(notice) => state.view.notice = Some(notice),
        FileAction::RefuseLink(notice) => {
            state.view.notice = Some(notice);
            state.view.waiting.refused = state.is_embedded();
        }
    }
}

/// Replaces the scene, if it can be drawn and solved.
pub(super) fn open(state: &mut State, scene: Scene) {
    match drafted(scene) {
        Ok(draft) => replace(state, Document::new(draft)),
        Err(notice) => state.view.notice = Some(notice),
    }
}

/// A scene that can be drawn and solved.
///
/// # Errors
/// Why it cannot.
pub(super) fn drafted(scene: Scene) -> Result<Draft, Notice> {
    let refused = |faults: &[Fault]| {
        Notice::refusal(tr_data!("The scene cannot be opened."))
            .with(faults.iter().map(ToString::to_string))
    };
    let draft = Draft::new(scene).map_err(|faults| refused(&faults))?;
    draft.instance().map_err(refused)?;
    Ok(draft)
}

/// Replaces the document by that of a link, and asks its question: without a
/// plan, once the scene is solved. What was there is kept at hand.
fn open_link(state: &mut State, linked: Linked) {
    stroke::release(state);
    let is_work = linked.source == Source::Link && state.history.is_touched();
    let displaced = (is_work && !state.is_embedded()).then(|| Displaced {
        moment: Rc::new(state.moment()),
        by: By::Link,
    });
    let was_impossible = linked.was_impossible;
    replace(state, linked.document);
    state.displaced = displaced;
    state.view.waiting.refused = false;
    state.view.waiting.unchecked = !linked.is_checked;
    state
        .view
        .playback
        .stop_at(linked.time.min(state.last_time()));
    let has_plan = state.document.plan().is_some();
    // What was adopted goes with its changes: the scene alone says nothing of it.
    let answer = state.document.answer.as_deref();
    let is_course = answer.is_some_and(|answer| answer.course.is_some());
    if state.document.mode.changing().is_some() {
        state.view.tab = Tab::Inspector;
    }
    match linked.question {
        Some(question) if has_plan || state.document.answer.is_some() => ask::ask(state, &question),
        question => {
            let is_alone = !is_course && state.document.mode.changing().is_none();
            let is_unproved = has_plan && solve::is_small(&state.document) && is_alone;
            if question.is_some() || is_unproved || state.audit().is_some() || was_impossible {
                solve::start(state, solve::Start::of_link(question));
            }
        }
    }
}

/// The document that was displaced and the one that displaced it change places.
fn back(state: &mut State) {
    stroke::release(state);
    if let Some(Displaced { moment, by }) = state.displaced.take() {
        let present = Rc::new(state.moment());
        state.history.record(state.moment());
        travel(state, Some(Rc::unwrap_or_clone(moment)));
        state.displaced = Some(Displaced {
            moment: present,
            by: match by {
                By::Link => By::Own,
                By::Own => By::Link,
            },
        });
    }
}

/// Puts a document that was kept onto the board, where it was looked at.
pub(super) fn resume(state: &mut State, moment: Moment) {
    let Moment {
        document,
        time,
        selection,
    } = moment;
    replace(state, document);
    state.view.selection = selection;
    state.view.playback.stop_at(time);
    settle(state);
    super::audit::go_on(state);
}

/// Puts another document onto the board, as one step of undo.
pub(super) fn replace(state: &mut State, document: Document) {
    stroke::release(state);
    drop_gesture(state);
    state.displaced = None;
    // Of many agents a table is long: the board keeps its room.
    state.view.table &= document.draft.agents().len() <= MANY;
    // First, so that undo knows where the one before was looked at.
    put(state, document);
    let view = &mut state.view;
    view.notice = None;
    view.selection = Selection::Nothing;
    view.folds = Folds::default();
    view.tool = Tool::Select;
    view.fleet = None;
    view.floor_plan = None;
    view.area = None;
    view.growing = None;
    view.follow = false;
    view.find = None;
    view.conflict = None;
    // A Pareto front was wanted of the scene before.
    state.settings.front = false;
    let view = &mut state.view;
    // What moved goes no further: it is of another scene.
    view.playback.stop_at(0);
}
