//! Steps from document to document: each is recorded whole, and undo brings it
//! back as it was.

use std::rc::Rc;

use giveway_model::tr_data;

use super::{solve, stroke};
use crate::area::{Area, AreaAction};
use crate::changing;
use crate::edit::{Edit, RuleEdit, Sketch};
use crate::gesture::Gesture;
use crate::history::Moment;
use crate::rules::kept;
use crate::{Activity, Document, Draft, Mode, Notice, Selection, State};

/// Puts a document in the place of the one that there is, as one step of undo.
pub(super) fn put(state: &mut State, document: Document) {
    state.view.waiting.go_on();
    state.history.record(state.moment());
    state.view.playback.playing = false;
    amend(state, document);
}

/// Puts a document in the place of the one that there is, as part of the last
/// step.
pub(super) fn amend(state: &mut State, document: Document) {
    let before = std::mem::replace(&mut state.document, document);
    reselect(state, &before);
    settle(state);
}

/// Begins another activity, as one step of undo; a question ends, and so does what was told of the
/// activity before.
pub(super) fn enter(state: &mut State, activity: Activity) {
    state.view.notice = None;
    let document = Document {
        mode: activity.into(),
        ..state.document.clone()
    };
    put(state, document);
}

/// Time, cursor and selection as what is shown now allows them.
pub(crate) fn settle(state: &mut State) {
    let view = &mut state.view;
    match &state.document.mode.activity {
        Activity::Changing(changing) => {
            view.playback.stop_at(changing.at);
        }
        Activity::Steering(own) if state.document.mode.asking().is_none() => {
            view.playback.stop_at(own.time());
            view.cursor = own.cell();
            view.selection = Selection::Agent(own.agent);
        }
        Activity::Editing
        | Activity::Comparing(_)
        | Activity::Auditing(_)
        | Activity::Steering(_) => {}
    }
    keep_to_plan(state);
    state.view.cursor = state.document.draft.clamp(state.view.cursor);
    match state.view.selection {
        Selection::Agent(agent) if !state.is_there(agent) => {
            state.view.selection = Selection::Nothing;
        }
        Selection::Cell(cell) => {
            state.view.selection = Selection::Cell(state.document.draft.clamp(cell));
        }
        Selection::Agent(_) | Selection::Nothing => {}
    }
}

/// The time as far as there is a plan.
pub(super) fn keep_to_plan(state: &mut State) {
    let last = state.last_time();
    if state.view.playback.time > last {
        state.view.playback.stop_at(last);
    }
}

/// The agent that is selected may have got another place, another name or none.
fn reselect(state: &mut State, before: &Document) {
    let Selection::Agent(agent) = state.view.selection else {
        return;
    };
    let (old, new) = (before.draft.agents(), state.document.draft.agents());
    if old.len() == new.len() || agent >= old.len() {
        return;
    }
    let name = old.get(agent).map(|agent| agent.name.as_str());
    let mut names = new.iter().map(|agent| agent.name.as_str());
    let found = names.position(|other| Some(other) == name);
    state.view.selection = found.map_or(Selection::Nothing, Selection::Agent);
}

pub(super) fn undo(state: &mut State) {
    if state.has_gesture() {
        return stroke::abandon(state);
    }
    if state.area().is_some_and(Area::has_ghost) {
        return super::area::area(state, AreaAction::Drop);
    }
    let present = state.moment();
    let before = state.history.undo(present);
    travel_told(state, before, true);
}

pub(super) fn redo(state: &mut State) {
    stroke::abandon(state);
    let present = state.moment();
    let after = state.history.redo(present);
    travel_told(state, after, false);
}

/// Goes to a moment, and says what that does to a world that changes: a rule that is being written
/// may stand in front of the list.
fn travel_told(state: &mut State, moment: Option<Moment>, is_back: bool) {
    let before = state.document.mode.clone();
    travel(state, moment);
    if let Some(told) = changing::travelled(&before, &state.document.mode, is_back) {
        state.view.rules.writing = None;
        state.view.notice = Some(Notice::information(told));
    }
}

/// Goes to a moment.
pub(super) fn travel(state: &mut State, moment: Option<Moment>) {
    let Some(moment) = moment else { return };
    state.view.notice = None;
    state.view.waiting.go_on();
    state.document = moment.document;
    state.view.selection = moment.selection;
    state.view.playback.stop_at(moment.time);
    settle(state);
    super::audit::go_on(state);
}

/// An edit that is made beside the board: of the world where that changes, else
/// of the scene.
pub(super) fn edit(state: &mut State, edit: Edit) {
    stroke::release(state);
    let told = match &edit {
        Edit::Recolour(..) | Edit::Name(_) => edit_scene(state, &[edit]),
        _ => match state.document.mode.changing().cloned() {
            Some(changing) => super::change::list(state, &changing, &edit),
            None => edit_scene(state, &[edit]),
        },
    };
    match told {
        Ok(()) => solve_on_change(state),
        Err(notice) => state.view.notice = Some(notice),
    }
}

/// Makes edits of the scene beside the board, as one step of undo.
pub(super) fn make(state: &mut State, edits: &[Edit]) {
    stroke::release(state);
    match edit_scene(state, edits) {
        Ok(()) => solve_on_change(state),
        Err(notice) => state.view.notice = Some(notice),
    }
}

/// Makes edits of the scene, as one step of undo; nothing happens where they
/// change nothing.
///
/// # Errors
/// Why they cannot be made; nothing has changed then.
pub(super) fn edit_scene(state: &mut State, edits: &[Edit]) -> Result<(), Notice> {
    if super::steer::is_in_the_way(state) {
        return Ok(());
    }
    if let Some(mut after) = edited(&state.document, edits)? {
        if after.draft != state.document.draft && solve::keep_so_far(state) {
            after = edited(&state.document, edits)?.unwrap_or(after);
        }
        let is_meant = |edit: &Edit| {
            matches!(edit, Edit::Rules(RuleEdit::Remove(_) | RuleEdit::Put(..))) || edit.is_afresh()
        };
        let lost = (!edits.iter().any(is_meant))
            .then(|| crate::rules::lost(&state.document.draft, &after.draft));
        state.view.notice = lost.flatten();
        state.displaced = None;
        put(state, after);
    }
    Ok(())
}

/// A document after edits of its scene; `None` where they change nothing.
///
/// # Errors
/// Why they cannot be made.
fn edited(document: &Document, edits: &[Edit]) -> Result<Option<Document>, Notice> {
    let mut after = document.clone();
    let mut sketch = Sketch::of(&document.draft);
    for edit in edits {
        sketch.make(edit).map_err(Notice::refusal)?;
        match edit {
            Edit::Within(within) => after.within = *within,
            Edit::Recolour(agent, colour) => after.colours.set(after.looks.of(*agent), *colour),
            edit if edit.is_afresh() => {
                after.answer = None;
                after.found_front = None;
                after.found_prices = None;
                after.mode = after.mode.with(None);
                after.leave_audit();
            }
            _ => {}
        }
    }
    let mut scene = sketch.into_scene();
    if edits.iter().any(Edit::is_afresh) {
        scene.assumptions.clear();
    }
    if scene != *document.draft.scene() {
        let draft = Draft::new(scene).map_err(|faults| {
            Notice::refusal(tr_data!("This edit cannot be made."))
                .with(faults.iter().map(ToString::to_string))
        })?;
        after.set_draft(draft);
    }
    Ok((after != *document).then_some(after))
}

impl Document {
    /// Puts another draft of the scene on the board. A question about the plan
    /// ends where that is no longer the plan of the scene.
    pub(super) fn set_draft(&mut self, draft: Draft) {
        self.looks = self.looks.after(self.draft.agents(), draft.agents());
        let draft = Rc::new(draft);
        let held = self.fresh_answer().and_then(|answer| kept(answer, &draft));
        self.draft = draft;
        if let Some(held) = held {
            self.answer = Some(Rc::new(held));
        }
        match self.mode.audit().and_then(|audit| audit.on(&self.draft)) {
            Some(audit) => {
                let legal = audit.plan.is_legal();
                self.answer = legal.then(|| Rc::clone(&audit.plan.answer));
                self.mode = Activity::Auditing(Rc::new(audit)).into();
            }
            None => self.leave_audit(),
        }
        if self.is_stale() || self.answer.is_none() {
            self.mode = self.mode.with(None);
        }
    }
}

impl Document {
    /// The plan of elsewhere is not for this scene any longer.
    fn leave_audit(&mut self) {
        if self.mode.audit().is_some() {
            self.mode = Mode::default();
        }
    }
}

/// After an edit as a whole.
pub(super) fn solve_on_change(state: &mut State) {
    // A plan of elsewhere was judged anew, by other rules.
    super::audit::go_on(state);
    // A lesson asks the solver by itself.
    let is_own = state.lesson().is_none() && state.document.mode.is_editing();
    let is_wanted = state.settings.solve_on_change && is_own;
    if is_wanted && state.document.is_stale() && state.document.draft.instance().is_ok() {
        solve::start(state, solve::Start::quiet());
    }
}

/// What the hand was doing is over, and the document is another one.
pub(super) fn drop_gesture(state: &mut State) {
    state.view.gesture = Gesture::None;
}
