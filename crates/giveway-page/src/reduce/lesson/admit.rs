//! What becomes of an action while a lesson is on the board.

use giveway_course::port::{Hand, Pick};
use giveway_model::Cell;
use std::rc::Rc;

use super::{change, leave};
use crate::intake::protocol::Reply;
use crate::lesson::{Fate, fate};
use crate::reduce::step;
use crate::{Action, BoardAction, IntakeAction, Notice, Selection, State};

/// An action of which a lesson decides what becomes; `Some` where it is to happen.
pub(in crate::reduce) fn admit(state: &mut State, action: Action) -> Option<Action> {
    let Some(lesson) = state.lesson.clone() else {
        return Some(action);
    };
    match fate(state, &lesson, &action) {
        Fate::Happens => {
            if lesson.board.hand == Hand::Points
                && let Action::Board(action) = &action
                && let Some(cell) = pointed_at(state, action)
            {
                point(state, cell);
            }
            Some(action)
        }
        Fate::Own => {
            let mut own = (*lesson.own).clone();
            step(&mut own, action);
            change(state, |lesson| lesson.own = Rc::new(own));
            None
        }
        Fate::Leaves => {
            open_instead(state, action);
            None
        }
        Fate::Closed(why) => {
            state.view.notice = Some(Notice::refusal(why));
            None
        }
        Fate::Dropped => None,
    }
}

/// What would take the place of a lesson happens to a person's own page. Where nothing
/// comes of it, such as of a file that cannot be read, the lesson stays as it is.
fn open_instead(state: &mut State, action: Action) {
    let opens = match &action {
        Action::Intake(IntakeAction::Reply { reply, .. }) => matches!(
            **reply,
            Reply::Found(_)
                | Reply::Run(_)
                | Reply::Missing {
                    on_board: Some(_),
                    ..
                }
        ),
        _ => true,
    };
    let mut left = state.clone();
    leave(&mut left);
    // The answer of the reader is for what asked it.
    left.intake = state.intake.clone();
    let own = left.clone();
    step(&mut left, action);
    let is_waiting = left.intake.job().is_some() || left.view.notice.is_some();
    let is_same = left.document == own.document && left.history == own.history;
    if is_same && (is_waiting || !opens) {
        state.intake = left.intake;
        state.view.notice = left.view.notice;
    } else {
        *state = left;
    }
}

/// What a person points at: by a press, by a key, or by selecting it.
fn pointed_at(state: &State, action: &BoardAction) -> Option<Cell> {
    match action {
        BoardAction::Press(cell) | BoardAction::Select(Selection::Cell(cell)) => Some(*cell),
        BoardAction::UseTool => Some(state.view.cursor),
        BoardAction::Select(Selection::Agent(agent)) => {
            let is_on = |cell: &Cell| state.agents_at(*cell).any(|other| other == *agent);
            let (width, height) = {
                let grid = state.document.draft.grid();
                (grid.width(), grid.height())
            };
            let all = (0..height).flat_map(|y| (0..width).map(move |x| Cell::new(x, y)));
            // A pointer has brought the cursor there.
            std::iter::once(state.view.cursor).chain(all).find(is_on)
        }
        _ => None,
    }
}

/// A person points at a cell.
fn point(state: &mut State, cell: Cell) {
    let draft = &state.document.draft;
    let cell = draft.clamp(cell);
    let robots = state.agents_at(cell);
    let agents = state.world().agents();
    let names = robots.filter_map(|agent| agents.get(agent));
    let pick = Pick {
        cell,
        time: state.view.playback.time,
        robots: names.map(|agent| agent.name.clone()).collect(),
    };
    // What was said of the click before is over.
    state.view.notice = None;
    change(state, |lesson| {
        let number = lesson.pick.as_ref().map_or(0, |(number, _)| number + 1);
        lesson.pick = Some((number, pick));
    });
}
