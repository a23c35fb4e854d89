//! What the page says by itself, and what a person answers.

use std::rc::Rc;

use super::file;
use crate::slot::{Elsewhere, Other, difference};
use crate::{Activity, SlotAction, State};

pub(super) fn slot(state: &mut State, action: SlotAction) {
    let waiting = &mut state.view.waiting;
    match action {
        SlotAction::Lose(why) => waiting.lost = Some(why),
        SlotAction::Settle => waiting.lost = None,
        SlotAction::Unkept(why) => waiting.unkept = Some(why),
        SlotAction::Kept => waiting.unkept = None,
        SlotAction::Differ(elsewhere) => differ(state, *elsewhere),
        SlotAction::Agree => {
            if let Some(Other::Apart { .. }) = waiting.other {
                waiting.other = None;
            }
        }
        SlotAction::TakeTheirs => {
            if let Some(Other::Apart { moment, .. }) = waiting.other.take() {
                file::resume(state, Rc::unwrap_or_clone(moment));
            }
        }
        SlotAction::KeepMine => {
            if let Some(Other::Apart { tab, moment }) = waiting.other.take() {
                waiting.declined.insert(tab);
                // Undo brings back the one that was not taken.
                state.history.record(Rc::unwrap_or_clone(moment));
            }
        }
        SlotAction::Close if waiting.unkept.is_some() || waiting.other.is_some() => {
            waiting.unkept = None;
            waiting.other = None;
        }
        SlotAction::Close => waiting.go_on(),
    }
}

/// Another tab has something else of this scene. Where nothing was edited here, it
/// is taken; else a person is asked.
fn differ(state: &mut State, elsewhere: Elsewhere) {
    let Elsewhere {
        tab,
        moment,
        is_ahead,
    } = elsewhere;
    if state.view.waiting.declined.contains(&tab) {
        return;
    }
    if is_ahead && is_at_rest(state) {
        let change = difference(&state.document, &moment.document);
        file::resume(state, moment);
        state.view.waiting.other = Some(Other::Taken { change });
    } else {
        let moment = Rc::new(moment);
        state.view.waiting.other = Some(Other::Apart { tab, moment });
    }
}

/// Whether nobody is in the middle of anything.
fn is_at_rest(state: &State) -> bool {
    !state.has_gesture()
        && state.work.is_idle()
        && !state.history.can_redo()
        && state.document.mode.activity == Activity::Editing
}
